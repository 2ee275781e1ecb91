#include "support/gl_context.hpp"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "support/error.hpp"

namespace support {
namespace {

const char* const advice =
    "; install a driver (Debian: apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri)";

/// libepoxy ends the whole program when it does not find these libraries, so look for them first.
void require_libraries() {
    if (::dlopen("libEGL.so.1", RTLD_LAZY | RTLD_GLOBAL) == nullptr) {
        throw Error(std::string("no OpenGL context: no EGL library libEGL.so.1") + advice);
    }
    if (::dlopen("libOpenGL.so.0", RTLD_LAZY | RTLD_GLOBAL) == nullptr &&
        ::dlopen("libGL.so.1", RTLD_LAZY | RTLD_GLOBAL) == nullptr) {
        throw Error(std::string("no OpenGL context: no OpenGL library libOpenGL.so.0 or libGL.so.1") +
                    advice);
    }
}

/// Whether `name` is one of the words of `extensions`.
bool has_extension(const char* extensions, const char* name) {
    const std::string padded = " " + std::string(extensions != nullptr ? extensions : "") + " ";
    return padded.find(" " + std::string(name) + " ") != std::string::npos;
}

/// The displays that need no window, the likeliest first.
std::vector<EGLDisplay> windowless_displays() {
    // Only client extensions may be asked for before there is a display.
    const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<EGLDisplay> displays;
    if (has_extension(extensions, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    if (has_extension(extensions, "EGL_EXT_platform_device") &&
        (has_extension(extensions, "EGL_EXT_device_enumeration") ||
         has_extension(extensions, "EGL_EXT_device_base"))) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        if (eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count) == EGL_TRUE) {
            for (EGLint i = 0; i < count; ++i) {
                displays.push_back(
                    eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr));
            }
        }
    }
    return displays;
}

EGLContext create_context(EGLDisplay display, int major, int minor) {
    const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                              major,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              minor,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
}

bool make_current(EGLDisplay display, EGLContext context) {
    return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
}

std::string gl_string(GLenum name) {
    const GLubyte* const text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

/// "3.3 (Core Profile) Mesa ... on llvmpipe": what the display's driver offers at best, or "".
std::string best_offer(EGLDisplay display) {
    const std::vector<std::pair<int, int>> versions = {{4, 2}, {4, 1}, {4, 0}, {3, 3}, {3, 2}, {3, 1}};
    for (const auto& [major, minor] : versions) {
        const EGLContext context = create_context(display, major, minor);
        if (context == EGL_NO_CONTEXT) {
            continue;
        }
        std::string offer;
        if (make_current(display, context)) {
            offer = gl_string(GL_VERSION) + " on " + gl_string(GL_RENDERER);
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, context);
        return offer;
    }
    return "";
}

}  // namespace

GlContext::GlContext(int major, int minor) {
    require_libraries();
    const std::string wanted = std::to_string(major) + "." + std::to_string(minor);
    std::string offers;
    bool any_display = false;
    for (const EGLDisplay display : windowless_displays()) {
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
            continue;
        }
        any_display = true;
        const char* const extensions = eglQueryString(display, EGL_EXTENSIONS);
        if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
            has_extension(extensions, "EGL_KHR_surfaceless_context") &&
            (has_extension(extensions, "EGL_KHR_no_config_context") ||
             has_extension(extensions, "EGL_MESA_configless_context"))) {
            const EGLContext context = create_context(display, major, minor);
            if (context != EGL_NO_CONTEXT && make_current(display, context)) {
                display_ = display;
                context_ = context;
                version_ = gl_string(GL_VERSION);
                renderer_ = gl_string(GL_RENDERER);
                return;
            }
            if (context != EGL_NO_CONTEXT) {
                eglDestroyContext(display, context);
            } else if (offers.empty()) {
                offers = best_offer(display);
            }
        }
        eglTerminate(display);
    }
    if (!offers.empty()) {
        throw Error("no OpenGL " + wanted + " context: the driver offers " + offers +
                    "; use a newer driver or Mesa's llvmpipe (LIBGL_ALWAYS_SOFTWARE=1)");
    }
    throw Error("no OpenGL " + wanted + " context: EGL has no " +
                (any_display ? "driver for desktop OpenGL" : "display that works without a window") + advice);
}

GlContext::~GlContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

void check_gl(const char* after) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) {
        return;
    }
    const char* const name = error == GL_OUT_OF_MEMORY                   ? "out of memory"
                             : error == GL_INVALID_ENUM                  ? "invalid enum"
                             : error == GL_INVALID_VALUE                 ? "invalid value"
                             : error == GL_INVALID_OPERATION             ? "invalid operation"
                             : error == GL_INVALID_FRAMEBUFFER_OPERATION ? "invalid framebuffer operation"
                                                                         : "unknown error";
    throw Error(std::string("OpenGL reports '") + name + "' after " + after +
                "; try a smaller --size or another driver");
}

}  // namespace support
