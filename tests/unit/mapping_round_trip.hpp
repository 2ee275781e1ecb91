#pragma once

// A mapping and its inverse, over every texel of a table.

#include <airlight/types.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "story.hpp"
#include "table_worlds.hpp"

namespace airlight_test {

/// The furthest that a round trip ends from the centre of the texel it began at, in texels of the axis.
class RoundTrip {
  public:
    template <typename T>
    void add(const char* world, T sent, T back, int size) {
        const double off = std::fabs(static_cast<double>(back) - static_cast<double>(sent)) * size;
        if (!(off <= worst_)) {  // NaN is the worst
            worst_ = off;
            where_ = std::string(world) + ", " + type_name<T>() + ", sent " + exact(sent) + ", back " +
                     exact(back);
        }
    }
    double worst() const {
        return worst_;
    }
    std::string story() const {
        return "off by " + brief(worst_) + " texels: " + where_;
    }
    void print(const char* what) const {
        std::printf("round trip %s: %s\n", what, story().c_str());
    }

  private:
    double worst_ = 0.0;
    std::string where_;
};

/// Calls visit(centre) with the texture coordinates of every texel's centre.
template <typename T, typename Visit>
void for_each_centre(int width, int height, int depth, const Visit& visit) {
    for (int k = 0; k < depth; ++k) {
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                visit(airlight::vec3<T>((T(i) + T(0.5)) / T(width), (T(j) + T(0.5)) / T(height),
                                        (T(k) + T(0.5)) / T(depth)));
            }
        }
    }
}

/// Numbers that a mapping may be handed by mistake or by rounding.
template <typename T>
std::vector<T> odd_numbers() {
    const T most = std::numeric_limits<T>::max();
    return {T(0),         T(-0.0),       T(1),       T(-1),
            T(1.0000001), T(-1.0000001), T(0.5),     T(1e-30),
            T(-1e-30),    T(6.36e6),     T(-6.36e6), T(1e9),
            T(-1e9),      most,          -most,      std::numeric_limits<T>::denorm_min()};
}
/// The same, and what is no number at all. Not for builds that assume there is none.
template <typename T>
std::vector<T> no_numbers() {
    const T infinity = std::numeric_limits<T>::infinity();
    return {infinity, -infinity, std::numeric_limits<T>::quiet_NaN()};
}

}  // namespace airlight_test
