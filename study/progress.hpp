#pragma once

// A bar on the terminal while something long goes on.

#include <mutex>
#include <string>

namespace study {

/// One line on stderr: redrawn on a terminal, ten lines in a log.
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
};

}  // namespace study
