// Every function of the manifest, GPU against C++ float and double.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>

#include "../support/accuracy_page.hpp"
#include "builtins.hpp"
#include "compare.hpp"
#include "report.hpp"
#include "start.hpp"
#include "support/error.hpp"
#include "support/files.hpp"

namespace parity {

namespace {

struct Options {
    GlslFolder glsl{AIRLIGHT_PARITY_GLSL_DIR};
    Settings settings;
    std::string function;  // "" for all
    std::filesystem::path write;
    std::filesystem::path check_page;
    bool list = false;
};

/// Decimal digits only: by itself CLI11 reads 0x10 and takes 010 for octal.
CLI::Validator whole_number() {
    return CLI::Validator(
        [](std::string& text) {
            if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) {
                return "needs a whole number, not '" + text + "'";
            }
            text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
            return std::string();
        },
        "");
}

/// Rows without a function and functions without a row, each as one line.
std::vector<std::string> unmatched(const Manifest& manifest) {
    std::vector<std::string> out;
    std::map<std::string, int> rows;
    for (const Row& row : all_rows()) {
        if (++rows[row.function] == 2) {
            out.push_back("the function '" + row.function + "' has two rows; keep one");
        }
        if (manifest.function(row.function) == nullptr) {
            out.push_back("the row '" + row.function +
                          "' has no function in manifest.json; delete the row or regenerate the GLSL");
        }
    }
    for (const Function& function : manifest.functions) {
        if (rows.count(function.name) == 0) {
            out.push_back("the function '" + function.name + "' of " + function.header +
                          " has no row; add one to tests/parity/rows (see tests/parity/README.md)");
        }
    }
    return out;
}

/// Every flag and every choice of it must be met by some scene, or rows would not see it.
std::vector<std::string> unseen_flags(const Manifest& manifest) {
    std::vector<std::string> out;
    for (const Flag& flag : manifest.flags) {
        std::vector<std::string> values =
            flag.type == "bool" ? std::vector<std::string>{"0", "1"} : flag.choices;
        if (values.empty()) {
            values = {flag.default_value, "a value other than " + flag.default_value};
        }
        for (const std::string& value : values) {
            const bool seen =
                value == flag.default_value ||
                std::any_of(scene_names().begin(), scene_names().end(), [&](const SceneName& scene) {
                    return std::any_of(
                        scene.defines.begin(), scene.defines.end(), [&](const SceneDefine& define) {
                            return define.macro == flag.macro &&
                                   (define.value == value || (flag.type != "bool" && flag.choices.empty()));
                        });
                });
            if (!seen) {
                out.push_back("no scene of tests/parity/scenes.hpp has " + flag.macro + " at " + value +
                              "; add one");
            }
        }
    }
    return out;
}

/// Whether the committed page is in step: every function of the manifest is listed, and nothing else is.
/// Digits differ from machine to machine and are not looked at.
int check_page(const std::filesystem::path& page, const Manifest& manifest) {
    const std::string text = support::read_file(page);
    std::set<std::string> listed;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| `", 0) != 0) {
            continue;
        }
        const std::string name = line.substr(3, line.find('`', 3) - 3);
        const std::string letters = "abcdefghijklmnopqrstuvwxyz0123456789_";
        if (name.find_first_not_of(letters) ==
            std::string::npos) {  // not a measured expression such as x / y
            listed.insert(name);
        }
    }
    int wrong = 0;
    for (const Function& function : manifest.functions) {
        if (listed.erase(function.name) == 0) {
            std::cout << "FAILED: " << page.string() << " does not list '" << function.name
                      << "'; write it anew: parity --write " << page.string() << "\n";
            ++wrong;
        }
    }
    for (const std::string& name : listed) {
        std::cout << "FAILED: " << page.string() << " lists '" << name
                  << "', which is no function of the manifest; write it anew: parity --write "
                  << page.string() << "\n";
        ++wrong;
    }
    std::cout << manifest.functions.size() << " functions, " << wrong << " out of step\n";
    return wrong == 0 ? 0 : 1;
}

int run(const Options& options) {
    if (options.list) {
        for (const Row& row : all_rows()) {
            std::cout << row.function << "\n";
        }
        return 0;
    }
    const Manifest manifest = read_manifest(options.glsl.folder / "manifest.json");
    if (!options.check_page.empty()) {
        return check_page(options.check_page, manifest);
    }
    const std::unique_ptr<support::GlContext> context = open_context();
    if (context == nullptr) {
        return skipped;
    }
    Settings settings = options.settings;
    settings.software_gl = is_software(context->renderer());
    const std::string driver = context->renderer() + ", " + context->version();
    std::cout << "driver: " << driver << "\ntolerances: "
              << (settings.software_gl ? "software GL: + - * / sqrt exact, built-ins as measured now"
                                       : "the GLSL specification's table of operation errors")
              << "\n\n";

    std::vector<std::string> failures = unmatched(manifest);
    for (const std::string& line : unseen_flags(manifest)) {
        failures.push_back(line);
    }
    const BuiltinReport builtins = measure_builtins(settings.seed);
    for (const BuiltinRow& b : builtins.builtins) {
        std::cout << b.name << ": " << b.inputs << " inputs, max relative " << b.max_relative
                  << ", max absolute " << b.max_absolute << ", worst at x = " << number_text(b.at_x)
                  << ", y = " << number_text(b.at_y) << "; " << b.specification
                  << " of what the specification allows\n";
    }
    for (const OperationRow& o : builtins.operations) {
        std::cout << o.glsl << " against " << o.cpp << ": " << o.different << " of " << o.inputs
                  << " differ, max " << o.max_ulp << " ulp\n";
    }
    std::cout << "\n";

    std::vector<RowResult> results;
    for (const Function& function : manifest.functions) {
        for (const Row& row : all_rows()) {
            if (row.function != function.name ||
                (!options.function.empty() && options.function != row.function)) {
                continue;
            }
            results.push_back(run_row(row, function, manifest, options.glsl, settings));
            std::cout << describe(results.back(), manifest) << std::flush;
            for (const std::string& failure : results.back().failures) {
                failures.push_back(function.name + ": " + failure);
            }
            break;
        }
    }
    if (!options.function.empty() && results.empty()) {
        throw support::Error("there is no row for '" + options.function + "'; --list names them");
    }

    std::size_t inputs = 0;
    for (const RowResult& result : results) {
        inputs += result.inputs;
    }
    std::cout << "\n"
              << results.size() << " functions, " << inputs << " inputs, " << failures.size()
              << " failures\n";
    for (const std::string& failure : failures) {
        std::cout << "FAILED: " << failure << "\n";
    }
    if (!failures.empty()) {
        return 1;
    }
    if (!options.write.empty()) {
        if (!options.function.empty()) {
            throw support::Error("--write needs every function; leave out --function");
        }
        // The page's last section is tests/accuracy's.
        const std::string section =
            std::filesystem::exists(options.write)
                ? airlight_test::float_error_section(support::read_file(options.write))
                : std::string();
        support::write_file(options.write, accuracy_page(results, builtins, manifest, settings, driver) +
                                               (section.empty() ? "" : "\n" + section));
        std::cout << "wrote " << options.write.string() << "\n";
    }
    return 0;
}

}  // namespace
}  // namespace parity

int main(int argc, char** argv) {
    parity::Options options;
    CLI::App app(
        "Compares every function of the generated GLSL with the C++ headers on the GPU of this machine.",
        "parity");
    parity::add_glsl(app, options.glsl);
    parity::add_switch(app, "--one-file", options.glsl.one_file,
                       "take every function from airlight.glsl instead of its own file");
    parity::add_value(app, "--function", "<name>", options.function, "this function only");
    parity::add_share(app, options.settings.share, "1");
    parity::add_value(app, "--seed", "<number>", options.settings.seed, "of the inputs")
        ->transform(parity::whole_number());
    parity::add_value(app, "--write", "<file>", options.write,
                      "write the accuracy page (only when everything passes)");
    parity::add_value(app, "--check-page", "<file>", options.check_page,
                      "only check that the accuracy page lists every function; needs no OpenGL");
    parity::add_switch(app, "--list", options.list, "print the rows and exit");
    app.footer("Exit status: 0 all pass, 1 something differs, 2 wrong use, 77 no OpenGL on this machine.");
    return parity::guarded_main(app, argc, argv, [&] { return parity::run(options); });
}
