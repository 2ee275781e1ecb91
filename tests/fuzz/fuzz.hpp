#pragma once

// What every fuzz target shares: numbers from the fuzzer's bytes, and the end of a run that broke a promise.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "promises.hpp"
#include "samplers.hpp"

namespace airlight_fuzz {

/// A source for Draws: the fuzzer's bytes, eight at a time; 0 after the last.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    std::uint64_t bits() {
        std::uint64_t value = 0;
        for (int i = 0; i < 8 && size_ > 0; ++i, ++data_, --size_) {
            value |= static_cast<std::uint64_t>(*data_) << (8 * i);
        }
        return value;
    }

  private:
    const std::uint8_t* data_;
    std::size_t size_;
};

using FuzzDraws = airlight_test::Draws<Bytes>;

/// Runs `check.run<T>(verdict, draw)` in the type that the bytes choose, and aborts with the story of a
/// broken promise: libFuzzer then keeps the bytes.
template <typename Check>
int check_bytes(const std::uint8_t* data, std::size_t size, const Check& check) {
    FuzzDraws draw(data, size);
    airlight_test::Verdict all;
    switch (draw.below(3)) {
        case 0:
            check.template run<float>(all, draw);
            break;
        case 1:
            check.template run<double>(all, draw);
            break;
        default:
            check.template run<long double>(all, draw);
    }
    if (!all.kept()) {
        std::fprintf(stderr, "%s\n", all.story().c_str());
        std::abort();
    }
    return 0;
}

}  // namespace airlight_fuzz
