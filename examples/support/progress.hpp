#pragma once

// A bar on the terminal while something long goes on.

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace support {

/// One line on stderr, with the time that is left: redrawn on a terminal, ten lines in a log.
class ProgressBar {
  public:
    explicit ProgressBar(std::string what);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// May be called from several threads.
    void operator()(std::size_t done, std::size_t all);

  private:
    std::mutex mutex_;
    std::string what_;
    bool terminal_;
    int shown_ = -1;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// "45 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace support
