#pragma once

// The baselines' tables of the sun's transmittance.

#include <airlight/types.hpp>
#include <vector>

#include "texture.hpp"

namespace study {

/// Texels in double, row by row.
struct Texels {
    int width;
    int height;
    std::vector<airlight::vec3<double>> values;

    template <typename T>
    Texture<T> texture() const {
        std::vector<airlight::vec3<T>> converted;
        converted.reserve(values.size());
        for (const airlight::vec3<double>& v : values) {
            converted.emplace_back(T(v.x), T(v.y), T(v.z));
        }
        return Texture<T>(width, height, std::move(converted));
    }
};

/// 256 by 256, each texel by 500 intervals: the report gives no number.
const Texels& cs562_texels(std::size_t world);

/// 256 by 64, each texel by his 40 steps.
const Texels& hillaire_texels(std::size_t world);

template <typename T>
Texture<T> cs562_table(std::size_t world) {
    return cs562_texels(world).texture<T>();
}
template <typename T>
Texture<T> hillaire_table(std::size_t world) {
    return hillaire_texels(world).texture<T>();
}

}  // namespace study
