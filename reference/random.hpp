#pragma once

#include <array>
#include <cstdint>
#include <random>

namespace reference {

/// Even numbers in [0, 1). Each stream of a seed has its own.
class Random {
  public:
    Random(std::uint64_t seed, std::uint64_t stream) {
        std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                               static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)};
        engine_.seed(sequence);
    }
    double operator()() {
        return static_cast<double>(engine_() >> 11) * 0x1p-53;
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace reference
