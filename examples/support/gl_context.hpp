#pragma once

#include <string>

namespace support {

/// An OpenGL core context without a window, current on this thread while it lives.
///
/// Tries Mesa's surfaceless platform first (software or hardware), then every EGL device, which is how
/// NVIDIA's driver is reached. Throws Error, in one line, when there is no EGL, no display without a window,
/// or no driver with the version asked for; the last names the newest version and renderer found.
class GlContext {
  public:
    explicit GlContext(int major = 4, int minor = 3);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    const std::string& version() const {
        return version_;
    }  ///< of the driver, as it calls it
    const std::string& renderer() const {
        return renderer_;
    }  ///< of the driver, as it calls it

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
    std::string version_;
    std::string renderer_;
};

/// Throws Error when OpenGL has reported an error since the last call. `after` says after what.
void check_gl(const char* after);

}  // namespace support
