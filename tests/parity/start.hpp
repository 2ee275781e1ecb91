#pragma once

// What the programs of this folder begin with.

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "shader.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/gl_context.hpp"

namespace parity {

using support::add_switch;
using support::add_value;
using support::guarded_main;
using support::skipped;

/// Whether a machine without OpenGL is a failure: in CI, and where the user says so.
inline bool gl_required() {
    return support::environment_asks({"CI", "AIRLIGHT_REQUIRE_GL"});
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

inline void add_glsl(CLI::App& app, GlslFolder& glsl) {
    add_value(app, "--glsl", "<folder>", glsl.folder,
              "the generated GLSL and its manifest.json (default: that of the source tree)");
}

inline void add_share(CLI::App& app, double& share, const std::string& default_text) {
    // Not CLI::PositiveNumber: it lets NaN through, and its message spells out the largest double.
    const CLI::Validator above_zero(
        [](std::string& text) {
            double number = 0;
            return CLI::detail::lexical_cast(text, number) && number > 0 && number <= 1000
                       ? std::string()
                       : "needs a number above 0 and up to 1000, not '" + text + "'";
        },
        "");
    add_value(app, "--share", "<number>", share,
              "of each row's inputs, 1 is all (default " + default_text + ")")
        ->check(above_zero);
}

}  // namespace parity
