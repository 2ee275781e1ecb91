#include "progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace support {

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
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    // Not before there is something to judge by, and not for what is over at once.
    std::string left;
    if (done > 0 && done < all && passed > 2) {
        left = ", " + duration_text(passed * static_cast<double>(all - done) / static_cast<double>(done)) +
               " left";
    }
    std::fprintf(stderr, terminal_ ? "\r%-28s [%s%s] %3d %%%-20s" : "%-28s [%s%s] %3d %%%s\n", what_.c_str(),
                 std::string(static_cast<std::size_t>(filled), '#').c_str(),
                 std::string(static_cast<std::size_t>(40 - filled), '.').c_str(), percent, left.c_str());
}

std::string duration_text(double seconds) {
    const long whole = std::lround(seconds);
    if (whole < 60) {
        return std::to_string(whole) + " s";
    }
    if (whole < 3600) {
        return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    }
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

}  // namespace support
