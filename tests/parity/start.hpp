#pragma once

// What the programs of this folder begin with.

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "support/error.hpp"
#include "support/gl_context.hpp"

namespace parity {

/// Exit status that CTest reads as "skipped".
constexpr int skipped = 77;

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Whether a machine without OpenGL is a failure: in CI, and where the user says so.
inline bool gl_required() {
    for (const char* const name : {"CI", "AIRLIGHT_REQUIRE_GL"}) {
        const char* const value = std::getenv(name);
        if (value != nullptr && *value != '\0' && std::strcmp(value, "0") != 0 &&
            std::strcmp(value, "false") != 0) {
            return true;
        }
    }
    return false;
}

/// A context, or null (after saying why) where there is no OpenGL and none is required.
inline std::unique_ptr<support::GlContext> open_context() {
    try {
        return std::make_unique<support::GlContext>(4, 3);
    } catch (const support::Error& e) {
        if (gl_required()) {
            throw;
        }
        std::cout << "skipped: " << e.what() << "\n(set AIRLIGHT_REQUIRE_GL=1 to make this a failure)\n";
        return nullptr;
    }
}

/// Whether the driver computes on the CPU, where + - * / sqrt are those of the machine.
inline bool is_software(const std::string& renderer) {
    for (const char* const name : {"llvmpipe", "softpipe"}) {
        if (renderer.find(name) != std::string::npos) {
            return true;
        }
    }
    return false;
}

/// --help, one-line errors, exit status.
template <typename Run>
int guarded_main(int argc, char** argv, const char* usage, const Run& run) {
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--help" || std::string(argv[i]) == "-h") {
            std::cout << usage;
            return 0;
        }
    }
    try {
        return run();
    } catch (const UsageError& e) {
        std::cerr << argv[0] << ": " << e.what() << "\n" << usage;
        return 2;
    } catch (const std::exception& e) {
        std::cerr << argv[0] << ": " << e.what() << "\n";
        return 1;
    }
}

}  // namespace parity
