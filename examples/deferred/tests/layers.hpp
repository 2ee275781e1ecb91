#pragma once

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/image.hpp"

/// The layers of a picture's OpenEXR file. Rows count from the top.
class Layers {
  public:
    explicit Layers(const std::filesystem::path& picture)
        : image(support::read_exr(picture.string() + ".exr")) {}

    const std::vector<float>& channel(const std::string& name) const {
        const support::ExrChannel* const found = support::find_channel(image, name);
        if (found == nullptr) {
            throw std::runtime_error("no channel " + name);
        }
        return found->pixels;
    }

    float mean(const std::string& name, int first_row, int end_row) const {
        const std::vector<float>& pixels = channel(name);
        double sum = 0;
        for (int i = first_row * image.width; i < end_row * image.width; ++i) {
            sum += double(pixels[std::size_t(i)]);
        }
        return float(sum / ((end_row - first_row) * image.width));
    }

    /// The lowest row without a surface in the picture's middle column.
    int horizon() const {
        const std::vector<float>& depth = channel("depth.Z");
        int row = 0;
        while (row + 1 < image.height &&
               std::isinf(depth[std::size_t((row + 1) * image.width + image.width / 2)])) {
            ++row;
        }
        return row;
    }

    support::ExrImage image;
};
