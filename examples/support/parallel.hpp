#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace support {

/// Calls row(y) for y = 0 .. height - 1, on every core. `row` must not throw.
template <typename Row>
void for_each_row(int height, const Row& row) {
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int y = next++; y < height; y = next++) {
            row(y);
        }
    };
    std::vector<std::thread> others(std::max(1u, std::thread::hardware_concurrency()) - 1);
    for (std::thread& thread : others) {
        thread = std::thread(work);
    }
    work();
    for (std::thread& thread : others) {
        thread.join();
    }
}

}  // namespace support
