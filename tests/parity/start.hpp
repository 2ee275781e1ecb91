#pragma once

// What the programs of this folder begin with.

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "shader.hpp"
#include "support/command_line.hpp"
#include "support/gl_test.hpp"

namespace parity {

using support::add_switch;
using support::add_value;
using support::guarded_main;
using support::is_software;
using support::open_context;
using support::skipped;

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
