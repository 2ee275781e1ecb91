// Takes the place of window.cpp where GLFW or Dear ImGui was not found.

#include "support/error.hpp"
#include "window.hpp"

namespace deferred {

void run_window(const Options&) {
    throw support::Error(
        "built without a window; install GLFW and Dear ImGui (Debian: apt-get install libglfw3-dev "
        "libimgui-dev), configure again and build");
}

}  // namespace deferred
