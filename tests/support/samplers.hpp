#pragma once

// Seeded samplers that give the same numbers with every standard library.

#include <cmath>
#include <cstdint>

#include <airlight/types.hpp>

namespace airlight_test {

/// SplitMix64 (Steele, Lea, Flood 2014): 64 good bits from a counter.
class SplitMix64 {
  public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9E3779B97F4A7C15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

  private:
    std::uint64_t state_;
};

/// Numbers of many kinds from a source of 64 bits.
template <typename Source>
class Draws : public Source {
  public:
    using Source::bits;
    using Source::Source;

    /// Uniform in [0, 1), 53 bits.
    double unit() {
        return static_cast<double>(bits() >> 11) * 0x1p-53;
    }

    /// Uniform in [low, high].
    double uniform(double low, double high) {
        return low + (high - low) * unit();
    }

    /// Uniform in the logarithm, low > 0.
    double log_uniform(double low, double high) {
        return low * std::exp(std::log(high / low) * unit());
    }

    /// An integer in [0, count).
    int below(int count) {
        return static_cast<int>(bits() % static_cast<std::uint64_t>(count));
    }

    /// A direction, uniform on the sphere.
    template <typename T>
    airlight::vec3<T> direction() {
        const double z = uniform(-1.0, 1.0);
        const double phi = uniform(0.0, 6.283185307179586);
        const double sine = std::sqrt((1.0 - z) * (1.0 + z));
        const airlight::vec3<T> drawn(T(sine * std::cos(phi)), T(sine * std::sin(phi)), T(z));
        // A type wider than double sees that double's vector is none of length 1.
        return sizeof(T) > sizeof(double) ? drawn / std::sqrt(glm::dot(drawn, drawn)) : drawn;
    }
};

using Random = Draws<SplitMix64>;

/// `count` cells of [low, high], a point in each: a stratified sweep that always holds both ends.
template <typename Function>
void for_stratified(Random& random, double low, double high, int count, Function function) {
    function(low);
    function(high);
    for (int i = 0; i < count; ++i) {
        function(low + (high - low) * (i + random.unit()) / count);
    }
}

}  // namespace airlight_test
