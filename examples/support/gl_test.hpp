#pragma once

// What tests of OpenGL start with.

#include <iostream>
#include <memory>
#include <string>

#include "command_line.hpp"
#include "error.hpp"
#include "gl_context.hpp"

namespace support {

/// A context, or null (after saying why) where there is no OpenGL and neither CI nor the user requires it.
inline std::unique_ptr<GlContext> open_context() {
    try {
        return std::make_unique<GlContext>(4, 3);
    } catch (const Error& error) {
        if (environment_asks({"CI", "AIRLIGHT_REQUIRE_GL"})) {
            throw;
        }
        std::cout << "skipped: " << error.what() << "\n(set AIRLIGHT_REQUIRE_GL=1 to make this a failure)\n";
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

}  // namespace support
