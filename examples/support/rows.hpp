#pragma once

// Rows of a table or a picture, or any jobs, on all cores and with a bar that tells how far they are.

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "parallel.hpp"
#include "progress.hpp"

namespace support {

/// rows(count, body), as airlight::bake_table wants it. What is made in several passes calls it once for
/// each, and says at the start how many there are.
class Rows {
  public:
    /// Without a name there is no bar.
    explicit Rows(const std::string& name = "") {
        if (!name.empty()) {
            bar_ = std::make_shared<ProgressBar>(name);
        }
    }

    /// Tells `tell` the share that is done, from several threads; when it answers false, the rows that are
    /// left are passed over, and what was made is of no use.
    explicit Rows(std::function<bool(double share)> tell) : tell_(std::move(tell)) {}

    void expect_passes(int passes) const {
        passes_ = passes;
        pass_ = 0;
    }

    template <typename Body>
    void operator()(int count, const Body& body) const {
        std::atomic<int> done{0};
        for_each_row(count, [&](int row) {
            if (tell_ && !tell_((pass_ + double(done) / count) / passes_)) {
                return;
            }
            body(row);
            report(std::size_t(++done), std::size_t(count));
        });
        end_pass();
    }

    /// For a pass that somebody else goes through.
    void report(std::size_t done, std::size_t all) const {
        if (bar_ != nullptr) {
            (*bar_)(std::size_t(pass_) * all + done, std::size_t(passes_) * all);
        }
    }

    void end_pass() const {
        ++pass_;
    }

  private:
    std::shared_ptr<ProgressBar> bar_;
    std::function<bool(double)> tell_;
    mutable int passes_ = 1;
    mutable int pass_ = 0;
};

}  // namespace support
