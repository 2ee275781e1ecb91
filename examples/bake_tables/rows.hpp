#pragma once

// How the CPU goes through the rows of a table: on all its cores, and telling how far it is.

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "support/parallel.hpp"
#include "support/progress.hpp"

namespace bake_tables {

/// rows(count, body) for airlight::bake_table. A table made in several passes calls it once for each, and
/// says at the start how many there are.
class Rows {
  public:
    /// Without a name there is no bar.
    explicit Rows(const std::string& name = "") {
        if (!name.empty()) {
            bar_ = std::make_shared<support::ProgressBar>(name);
        }
    }

    void expect_passes(int passes) const {
        passes_ = passes;
        pass_ = 0;
    }

    template <typename Body>
    void operator()(int count, const Body& body) const {
        std::atomic<int> done{0};
        support::for_each_row(count, [&](int row) {
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
    std::shared_ptr<support::ProgressBar> bar_;
    mutable int passes_ = 1;
    mutable int pass_ = 0;
};

}  // namespace bake_tables
