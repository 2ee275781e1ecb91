#include "comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace deferred {
namespace {

constexpr double floor_share = 1e-3;

/// Black for equal, then blue at 1e-8, green at 1e-6, red at 1e-4, white from 1e-2.
std::array<std::uint8_t, 3> difference_color(double difference) {
    if (!(difference > 0)) {
        return {0, 0, 0};
    }
    static const std::array<std::array<double, 3>, 6> stops = {
        {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}, {1, 1, 1}}};
    const double place = std::clamp((std::log10(difference) + 10) / 2, 0.0, 4.0);
    const std::size_t stop = std::size_t(place);
    const double share = place - double(stop);
    std::array<std::uint8_t, 3> color{};
    for (std::size_t c = 0; c < 3; ++c) {
        color[c] =
            std::uint8_t(std::lround(255 * (stops[stop][c] * (1 - share) + stops[stop + 1][c] * share)));
    }
    return color;
}

double mean_without_disc(const std::vector<float>& radiance, const std::vector<bool>& disc) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        if (!disc[i / 3] && std::isfinite(radiance[i])) {
            sum += double(radiance[i]);
            ++count;
        }
    }
    return count > 0 ? sum / double(count) : 0;
}

}  // namespace

Comparison compare(const std::vector<float>& gpu, const std::vector<float>& cpu, int width, int height,
                   const std::vector<bool>& disc) {
    Comparison result{};
    result.floor = floor_share * mean_without_disc(cpu, disc);
    result.largest = -1;
    result.picture.resize(gpu.size());
    std::vector<double> differences(gpu.size());
    for (std::size_t pixel = 0; pixel < gpu.size() / 3; ++pixel) {
        double worst = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::size_t i = 3 * pixel + channel;
            const double difference = std::abs(double(gpu[i]) - double(cpu[i]));
            double relative = difference > 0 ? difference / std::max(double(cpu[i]), result.floor) : 0;
            if (!std::isfinite(gpu[i]) || !std::isfinite(cpu[i])) {
                relative = std::numeric_limits<double>::infinity();
            }
            differences[i] = relative;
            worst = std::max(worst, relative);
            if (relative > result.largest) {
                result.largest = relative;
                result.x = int(pixel) % width;
                result.y = height - 1 - int(pixel) / width;
                result.channel = int(channel);
                result.gpu = gpu[i];
                result.cpu = cpu[i];
            }
        }
        const std::array<std::uint8_t, 3> color = difference_color(worst);
        std::copy(color.begin(), color.end(), result.picture.begin() + std::ptrdiff_t(3 * pixel));
    }
    const std::size_t rank = std::size_t(0.999 * double(differences.size() - 1));
    std::nth_element(differences.begin(), differences.begin() + std::ptrdiff_t(rank), differences.end());
    result.percentile = differences[rank];
    return result;
}

std::string describe(const Comparison& c) {
    static const std::array<const char*, 3> names = {"red", "green", "blue"};
    char text[512];
    std::snprintf(
        text, sizeof text,
        "GPU against CPU: largest relative difference %.2e at pixel (%d, %d) %s, GPU %.9g, CPU %.9g; "
        "99.9 %% are below %.2e; relative to the CPU's value or to %.2e, a thousandth of the "
        "picture's mean without the sun's disc, where that is more",
        c.largest, c.x, c.y, names[std::size_t(c.channel)], double(c.gpu), double(c.cpu), c.percentile,
        c.floor);
    return text;
}

}  // namespace deferred
