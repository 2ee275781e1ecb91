#pragma once

// What command-line programs have in common: --help, options, one-line errors, exit statuses.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace support {

/// Exit status that CTest reads as "skipped".
constexpr int skipped = 77;

/// Whether one of these environment variables is set, and neither 0 nor false.
inline bool environment_asks(std::initializer_list<const char*> names) {
    for (const char* const name : names) {
        const char* const value = std::getenv(name);
        if (value != nullptr && *value != '\0' && std::strcmp(value, "0") != 0 &&
            std::strcmp(value, "false") != 0) {
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

}  // namespace support
