#include "timer.hpp"

#include <algorithm>

namespace deferred {
namespace {

// A driver that is further behind than this is waited for.
constexpr std::size_t most_pending = 8;

}  // namespace

void delete_query(GLuint name) {
    glDeleteQueries(1, &name);
}

void PassTimers::begin_frame() {
    passes_.erase(
        std::remove_if(passes_.begin(), passes_.end(), [&](const Pass& pass) { return pass.frame < frame_; }),
        passes_.end());
    ++frame_;
    next_ = 0;
}

void PassTimers::start(const std::string& name) {
    stop();
    auto pass =
        std::find_if(passes_.begin(), passes_.end(), [&](const Pass& known) { return known.name == name; });
    if (pass == passes_.end()) {
        pass = passes_.insert(passes_.begin() + next_, Pass{name, frame_, {}, 0});
    }
    next_ = pass - passes_.begin() + 1;
    pass->frame = frame_;
    if (pass->pending.size() >= most_pending) {
        take(*pass, true);
    }
    GLuint query = 0;
    glGenQueries(1, &query);
    pass->pending.emplace_back(query);
    glBeginQuery(GL_TIME_ELAPSED, query);
    running_ = true;
}

void PassTimers::stop() {
    if (running_) {
        glEndQuery(GL_TIME_ELAPSED);
        running_ = false;
    }
}

std::vector<PassTime> PassTimers::read(bool wait) {
    stop();
    std::vector<PassTime> times;
    for (Pass& pass : passes_) {
        take(pass, wait);
        times.push_back({pass.name, pass.milliseconds});
    }
    return times;
}

void PassTimers::take(Pass& pass, bool wait) {
    while (!pass.pending.empty()) {
        const GLuint query = pass.pending.front();
        GLint available = GL_TRUE;
        if (!wait) {
            glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
        }
        if (available != GL_TRUE) {
            return;
        }
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
        pass.milliseconds = double(nanoseconds) * 1e-6;
        pass.pending.erase(pass.pending.begin());
    }
}

}  // namespace deferred
