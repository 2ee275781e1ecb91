#pragma once

// What the programs of this folder begin with.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "shader.hpp"
#include "support/error.hpp"
#include "support/gl_context.hpp"

namespace parity {

/// Exit status that CTest reads as "skipped".
constexpr int skipped = 77;

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

/// --help: one line of usage, the description, a line for each option, the footer.
class HelpText : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string /*name*/,
                          CLI::AppFormatMode /*mode*/) const override {
        const auto label = [](const CLI::Option* option) {
            const std::string& value = option->get_option_text();
            return "--" + option->get_lnames().front() + (value.empty() ? "" : " " + value);
        };
        std::size_t width = 18;  // at least, for the programs with few options to look the same
        for (const CLI::Option* const option : app->get_options()) {
            width = std::max(width, label(option).size() + 2);
        }
        std::ostringstream out;
        out << "usage: " << app->get_name() << " [options]\n" << app->get_description() << "\n" << std::left;
        for (const CLI::Option* const option : app->get_options()) {
            out << "  " << std::setw(static_cast<int>(width)) << label(option) << option->get_description()
                << "\n";
        }
        out << app->get_footer() << "\n";
        return out.str();
    }
};

/// `value` is what --help and errors call the option's value. Of an option given twice the last one holds.
template <typename T>
CLI::Option* add_value(CLI::App& app, const std::string& name, const std::string& value, T& target,
                       const std::string& description) {
    return app.add_option(name, target, description)->option_text(value)->type_name(value)->take_last();
}

/// Without a value: neither --name=false nor --name=2 is accepted.
inline CLI::Option* add_switch(CLI::App& app, const std::string& name, bool& target,
                               const std::string& description) {
    return app.add_flag(name, target, description)->disable_flag_override();
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

/// The command line, --help, one-line errors, exit status.
template <typename Run>
int guarded_main(CLI::App& app, int argc, char** argv, const Run& run) {
    app.formatter(std::make_shared<HelpText>());
    app.set_help_flag("-h,--help", "this text");
    try {
        app.parse(argc, argv);
        return run();
    } catch (const CLI::ParseError& e) {
        if (app.get_help_ptr()->count() > 0) {  // whatever else is wrong
            std::cout << app.help();
            return 0;
        }
        std::cerr << argv[0] << ": " << e.what() << "\n" << app.help();
        return 2;
    } catch (const std::exception& e) {
        std::cerr << argv[0] << ": " << e.what() << "\n";
        return 1;
    }
}

}  // namespace parity
