#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/gl_objects.hpp"

namespace deferred {

void delete_query(GLuint name);
using Query = support::GlName<delete_query>;

/// How long a pass kept the GPU.
struct PassTime {
    std::string name;
    double milliseconds;
};

/// GPU time of each pass, by timer queries. Results come some frames later and nothing waits for them, unless
/// asked to.
class PassTimers {
  public:
    /// Before the first pass of a frame: forgets the passes that the last frame did not have.
    void begin_frame();

    /// The pass before ends here, if one is running, and this one begins.
    void start(const std::string& name);
    void stop();

    /// The newest times there are, in the order of the passes; with `wait`, those of the last frame.
    std::vector<PassTime> read(bool wait);

  private:
    struct Pass {
        std::string name;
        std::int64_t frame;          // that had it last
        std::vector<Query> pending;  // the oldest first
        double milliseconds;
    };

    static void take(Pass& pass, bool wait);

    std::vector<Pass> passes_;
    std::int64_t frame_ = 0;
    std::ptrdiff_t next_ = 0;  // where a pass that was not there before belongs
    bool running_ = false;
};

}  // namespace deferred
