#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace deferred {

/// How far two pictures of the same surfaces are apart.
struct Comparison {
    double floor;       ///< differences are relative to the CPU's value, or to this where that is less
    double largest;     ///< relative difference of the worst channel of the worst pixel
    double percentile;  ///< 99.9 % of the channel values differ by less
    int x;              ///< of the worst pixel, from the left
    int y;              ///< of the worst pixel, from the top
    int channel;        ///< of the worst pixel: 0 red, 1 green, 2 blue
    float gpu;          ///< the worst channel's values
    float cpu;
    std::vector<std::uint8_t> picture;  ///< differences as colours: 3 bytes per pixel, the lower row first
};

/// Compares 3 channels per pixel, the lower row first. The floor is a thousandth of the mean of the channels,
/// the pixels of the sun's `disc` left out: below it an error is a thousand times fainter than what the eye
/// adapts to. A value that is no finite number counts as an infinite difference.
Comparison compare(const std::vector<float>& gpu, const std::vector<float>& cpu, int width, int height,
                   const std::vector<bool>& disc);

/// One line for people: the figures of a comparison and what they are relative to.
std::string describe(const Comparison& comparison);

}  // namespace deferred
