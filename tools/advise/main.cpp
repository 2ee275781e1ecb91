// advise: which terms and how many nodes a scene needs. README.md explains what it prints.

#include <unistd.h>
#include <airlight/constants.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "emit.hpp"
#include "report.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/files.hpp"

namespace {

using advise::Range;

struct Options {
    std::string preset;
    std::string file;
    std::string ozone;
    std::string phase = "cornette_shanks";
    std::pair<double, double> height{0, 0};
    std::pair<double, double> sun{0, 0};
    std::pair<double, double> distance{0, 0};
    double tolerance = 1;
    std::string by = "worst";
    int views = 800;
    int seed = 1;
    std::string name = "Scene";
    std::string cpp;
    std::string glsl;
};

std::string number(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

Range range(const char* option, const std::pair<double, double>& values, double least, double most) {
    const auto [low, high] = values;
    if (std::isnan(low) || std::isnan(high) || low > high) {
        throw support::Error(std::string("--") + option + ": give the smaller number first, then the larger");
    }
    if (low < least || high > most) {
        throw support::Error(std::string("--") + option + ": both numbers must lie between " + number(least) +
                             " and " + number(most));
    }
    return {low, high};
}

int index_of(const std::string& word, const std::vector<std::string>& words) {
    return static_cast<int>(std::find(words.begin(), words.end(), word) - words.begin());
}

bool identifier(const std::string& text) {
    const auto good = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9');
    };
    return !text.empty() && (text[0] < '0' || text[0] > '9') && std::all_of(text.begin(), text.end(), good);
}

advise::Question question_of(const Options& options) {
    advise::Question out;
    if (options.file.empty()) {
        out.air = advise::preset(options.preset);
        out.air_name = "--preset " + options.preset;
    } else {
        out.air = {advise::parsed_atmosphere(support::read_file(options.file), options.file),
                   airlight::ozone_tent};
        out.air_name = "--file " + options.file;
    }
    if (!options.ozone.empty()) {
        out.air.ozone = index_of(options.ozone, advise::ozone_names());
    }
    out.mie_phase = index_of(options.phase, advise::phase_names());
    const double g = out.air.atmosphere.mie_g;
    if (out.mie_phase == airlight::phase_fog ? !(g > 0) : !(std::abs(g) < 1)) {
        throw support::Error("mie_g is " + number(g) +
                             (out.mie_phase == airlight::phase_fog
                                  ? "; with --phase fog it is the droplets' diameter in micrometres, over 0"
                                  : "; it must lie between -1 and 1"));
    }
    // airlight's eyes reach 1e12 m.
    out.ranges.height = range("height", options.height, -out.air.atmosphere.ground_radius, 1e12);
    out.ranges.sun = range("sun", options.sun, -90, 90);
    out.ranges.distance = range("distance", options.distance, 0, airlight::no_surface<double>());
    if (!(options.tolerance > 0 && options.tolerance < 100)) {
        throw support::Error("--tolerance: give per cent, more than 0 and less than 100");
    }
    out.tolerance = options.tolerance / 100.0;
    out.by = options.by == "worst" ? advise::By::worst : advise::By::p95;
    out.views = options.views;
    out.seed = static_cast<std::uint64_t>(options.seed);
    if (!identifier(options.name)) {
        throw support::Error("--name: '" + options.name + "' is no name of a C++ struct");
    }
    return out;
}

/// One line on a terminal, nothing elsewhere: the run takes seconds.
void show(double done) {
    if (isatty(STDERR_FILENO) != 0) {
        std::fprintf(stderr, done < 1 ? "\rmeasuring %3.0f %%" : "\r               \r", 100.0 * done);
    }
}

void put(const std::string& path, const std::string& text) {
    if (path.empty()) {
        std::cout << "\n" << text;
    } else {
        support::write_file(path, text);
        std::cout << path << "\n";
    }
}

int run(const Options& options) {
    const advise::Question question = question_of(options);
    // Where it cannot be written, say so before the work.
    for (const std::string& path : {options.cpp, options.glsl}) {
        if (!path.empty()) {
            const auto folder = std::filesystem::path(path).parent_path();
            support::make_writable_directory(folder.empty() ? "." : folder);
        }
    }
    const advise::Answer answer = advise::answered(question, show);
    std::cout << advise::report(question, answer);
    const std::string head = "Chosen by advise: " + advise::summary(question, answer) + ".";
    const advise::Setting& setting = answer.advice.setting;
    const std::string guard = options.cpp.empty() ? "" : "#pragma once\n\n";
    put(options.cpp, guard + advise::cpp_text(setting, options.name, head));
    put(options.glsl, advise::glsl_text(setting, head));
    return std::cout.flush() ? 0 : 1;
}

void add_options(CLI::App& app, Options& options) {
    using support::add_value;
    CLI::Option* const preset = add_value(app, "--preset", "NAME", options.preset,
                                          "earth, cs562_earth, elek_earth, leenman_earth or mars")
                                    ->check(CLI::IsMember(advise::preset_names()));
    CLI::Option* const file =
        add_value(app, "--file", "FILE", options.file,
                  "an atmosphere in metres: a line `name = number` for each member of airlight::Atmosphere");
    preset->excludes(file);
    app.callback([preset, file] {
        if (preset->count() + file->count() == 0) {
            throw CLI::RequiredError("--preset NAME or --file FILE");
        }
    });
    app.add_option("--height", options.height, "camera heights over the ground sphere, metres")
        ->option_text("MIN MAX")
        ->required();
    app.add_option("--sun", options.sun, "elevations of the sun at the camera, degrees")
        ->option_text("MIN MAX")
        ->required();
    app.add_option("--distance", options.distance,
                   "of the surfaces seen, metres; a MAX of inf adds views that end on none, the sky's")
        ->option_text("MIN MAX")
        ->required();
    add_value(app, "--tolerance", "PERCENT", options.tolerance, "how much the picture may change (1)");
    add_value(app, "--by", "worst|p95", options.by,
              "whether the worst view or 95 % of the views stay within it (worst)")
        ->check(CLI::IsMember({"worst", "p95"}));
    add_value(app, "--ozone", "PROFILE", options.ozone,
              "none, tent or lorentzian (tent; leenman_earth: lorentzian)")
        ->check(CLI::IsMember(advise::ozone_names()));
    add_value(app, "--phase", "NAME", options.phase,
              "the aerosol's: cornette_shanks, henyey_greenstein or fog (cornette_shanks)")
        ->check(CLI::IsMember(advise::phase_names()));
    add_value(app, "--views", "COUNT", options.views, "views to draw, 20 to 100000 (800)")
        ->check(CLI::Range(20, 100000));
    add_value(app, "--seed", "NUMBER", options.seed, "of the views (1)")->check(CLI::NonNegativeNumber);
    add_value(app, "--name", "NAME", options.name, "of the C++ struct (Scene)");
    add_value(app, "--cpp", "FILE", options.cpp, "write the struct there, not to standard output");
    add_value(app, "--glsl", "FILE", options.glsl, "write the macros there, not to standard output");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Measures which terms of the air and how many nodes a scene needs: what a term is worth over the "
        "views\n"
        "that the scene may show, in per cent of their luminance. Prints a report, the Scene for C++ and "
        "the\n"
        "macros for GLSL.\n",
        "advise"};
    Options options;
    app.formatter(std::make_shared<support::HelpText>());
    app.set_help_flag("-h,--help", "this text");
    add_options(app, options);
    try {
        app.parse(argc, argv);
        return run(options);
    } catch (const CLI::ParseError& error) {
        if (app.get_help_ptr()->count() > 0) {
            std::cout << app.help();
            return 0;
        }
        std::cerr << "advise: " << error.what() << "; advise --help lists the options\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "advise: " << error.what() << "\n";
        return 1;
    }
}
