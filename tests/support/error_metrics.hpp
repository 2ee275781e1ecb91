#pragma once

// Figures that sum up many errors: largest, percentile, median, root mean square.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace airlight_test {

/// The value below which the share `fraction` of the samples lies (nearest rank); 0 of nothing.
inline double percentile(std::vector<double> samples, double fraction) {
    if (samples.empty()) {
        return 0.0;
    }
    const double rank = std::ceil(fraction * static_cast<double>(samples.size()));
    const std::size_t index = rank < 1.0 ? 0 : std::min(samples.size(), static_cast<std::size_t>(rank)) - 1;
    std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(index), samples.end());
    return samples[index];
}

struct ErrorMetrics {
    double largest;
    double p95;
    double median;
    double root_mean_square;
};

/// Sums up errors >= 0.
inline ErrorMetrics error_metrics(const std::vector<double>& errors) {
    double largest = 0.0;
    double squares = 0.0;
    for (const double error : errors) {
        largest = error > largest || std::isnan(error) ? error : largest;
        squares += error * error;
    }
    const double count = errors.empty() ? 1.0 : static_cast<double>(errors.size());
    return ErrorMetrics{largest, percentile(errors, 0.95), percentile(errors, 0.5),
                        std::sqrt(squares / count)};
}

/// Order of convergence seen in two errors when the number of steps doubles: 2 for a factor of 4.
inline double convergence_order(double coarse_error, double fine_error) {
    return std::log2(coarse_error / fine_error);
}

}  // namespace airlight_test
