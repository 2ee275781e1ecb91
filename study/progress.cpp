#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace study {

ProgressBar::ProgressBar(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (terminal_ && shown_ >= 0) {
        std::fputc('\n', stderr);
    }
}

void ProgressBar::operator()(std::size_t done, std::size_t all) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const int percent = all > 0 ? static_cast<int>(100 * done / all) : 100;
    const int step = terminal_ ? 1 : 10;
    if (percent / step <= shown_ / step && shown_ >= 0) {
        return;
    }
    shown_ = percent;
    const int filled = percent * 40 / 100;
    std::fprintf(stderr, terminal_ ? "\r%-28s [%s%s] %3d %%" : "%-28s [%s%s] %3d %%\n", what_.c_str(),
                 std::string(static_cast<std::size_t>(filled), '#').c_str(),
                 std::string(static_cast<std::size_t>(40 - filled), '.').c_str(), percent);
}

}  // namespace study
