#pragma once

// A texture on the CPU: the hook that baselines with a table read.

#include <airlight/types.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace study {

/// Texels on a grid, read with linear filtering and clamped to the edge, as a GPU's sampler does.
template <typename T>
class Texture {
  public:
    Texture(int width, int height, std::vector<airlight::vec3<T>> texels)
        : width_(width), height_(height), texels_(std::move(texels)) {}

    airlight::vec3<T> operator()(const airlight::vec2<T>& uv) const {
        const double x = std::clamp(static_cast<double>(uv.x) * width_ - 0.5, 0.0, width_ - 1.0);
        const double y = std::clamp(static_cast<double>(uv.y) * height_ - 0.5, 0.0, height_ - 1.0);
        const int i = std::min(static_cast<int>(x), width_ - 2);
        const int j = std::min(static_cast<int>(y), height_ - 2);
        const T a = T(x - i);
        const T b = T(y - j);
        const auto* low = &texels_[static_cast<std::size_t>(j * width_ + i)];
        const auto* high = low + width_;
        return (T(1) - b) * ((T(1) - a) * low[0] + a * low[1]) + b * ((T(1) - a) * high[0] + a * high[1]);
    }

  private:
    int width_;
    int height_;
    std::vector<airlight::vec3<T>> texels_;
};

}  // namespace study
