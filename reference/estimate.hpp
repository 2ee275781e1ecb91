#pragma once

// What chance leaves of a number: its mean and how far that may be off.

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace reference {

/// A mean and how far it may be off.
struct Estimate {
    double mean = 0;
    double error = 0;  ///< standard error of the mean
};

/// Numbers that are added up in groups: the spread of the groups' means is the standard error.
class Tally {
  public:
    void add(double value) {
        sum_ += value;
    }
    void close_group(std::uint64_t count) {
        means_.push_back(sum_ / static_cast<double>(count));
        sum_ = 0;
    }
    /// Of a single group nobody knows how far it is off: its error is infinite.
    Estimate estimate() const {
        const auto count = static_cast<double>(means_.size());
        double mean = 0;
        for (const double m : means_) {
            mean += m / count;
        }
        double squares = 0;
        for (const double m : means_) {
            squares += (m - mean) * (m - mean);
        }
        return Estimate{mean, means_.size() > 1 ? std::sqrt(squares / (count * (count - 1)))
                                                : std::numeric_limits<double>::infinity()};
    }

  private:
    double sum_ = 0;
    std::vector<double> means_;
};

}  // namespace reference
