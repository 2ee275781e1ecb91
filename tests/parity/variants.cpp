// Every generated file in every version of GLSL and with every flag, a term that is off against coefficients
// of zero, and proof that the comparison notices an edited shader.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <string>

#include "builtins.hpp"
#include "compare.hpp"
#include "scratch_folder.hpp"
#include "start.hpp"
#include "support/error.hpp"
#include "support/files.hpp"

namespace parity {
namespace {

struct Options {
    GlslFolder glsl{AIRLIGHT_PARITY_GLSL_DIR};
    std::string only;  // "" for all parts
};

// ---- every file, alone, with each flag ----

/// All values a flag is compiled with; for a count its default and another one.
std::vector<std::string> values_of(const Flag& flag) {
    if (flag.type == "bool") {
        return {"0", "1"};
    }
    return flag.choices.empty() ? std::vector<std::string>{flag.default_value, "3"} : flag.choices;
}

const std::vector<std::string>& versions() {
    static const std::vector<std::string> all = {
        "#version 330 core\n", "#version 430 core\n", "#version 450 core\n",
        "#version 300 es\nprecision highp float;\nprecision highp int;\n"};
    return all;
}

/// A whole fragment shader around a generated file: the includer's part of the bargain.
std::string fragment_shader(const std::string& version, const std::string& defines, const std::string& text) {
    return version + defines + text + "\nout vec4 pixel;\nvoid main() {\n    pixel = vec4(1.0);\n}\n";
}

struct Counter {
    std::size_t passed = 0;
    std::vector<std::string> failures;

    void check(bool good, const std::string& what) {
        passed += good ? 1 : 0;
        if (!good) {
            failures.push_back(what);
        }
    }
};

void compile_everything(const Manifest& manifest, const GlslFolder& glsl, Counter& counter) {
    std::vector<std::string> files = manifest.files();
    files.push_back("airlight.glsl");
    const std::string hook = hooks_glsl;
    const auto compile = [&](const std::string& file, const std::string& version, const std::string& defines,
                             const std::string& text) {
        const std::string log = compile_log(fragment_shader(version, defines, text), false);
        counter.check(log.empty(),
                      file + " as " + version.substr(0, version.find('\n')) + " with\n" + defines + log);
    };
    for (const std::string& file : files) {
        const std::string text = expanded(glsl, file);
        for (const std::string& version : versions()) {
            compile(file, version, "", text);
            compile(file, version, hook, text);
            for (const Flag& flag : manifest.flags) {
                for (const std::string& value : values_of(flag)) {
                    compile(file, version, "#define " + flag.macro + " " + value + "\n", text);
                }
            }
            // The guards hold: the same text twice is the same text once.
            compile(file + " twice", version, "", text + text);
        }
    }
    // All flags against all flags, in the file that has everything.
    std::vector<std::string> combinations = {""};
    for (const Flag& flag : manifest.flags) {
        std::vector<std::string> next;
        for (const std::string& before : combinations) {
            for (const std::string& value : values_of(flag)) {
                next.push_back(before + "#define " + flag.macro + " " + value + "\n");
            }
        }
        combinations = next;
    }
    const std::string everything = expanded(glsl, "airlight.glsl");
    for (const std::string& defines : combinations) {
        for (const std::string& version : versions()) {
            compile("airlight.glsl", version, defines, everything);
        }
    }
}

// ---- a term that is off against coefficients of zero ----

/// Two scenes that must agree where some inputs are zero (or, for shadow, where the sun is up).
struct OffRule {
    std::string scene;                ///< of scenes.hpp, compared with the default scene
    std::vector<std::string> zeroed;  ///< members of the atmosphere
    std::vector<std::string> functions;
};

const std::vector<OffRule>& off_rules() {
    static const std::vector<std::string> spectra = {"column_optical_depth", "optical_depth",
                                                     "transmittance",        "transmittance_to_space",
                                                     "single_scattering",    "single_scattering_marched"};
    static const std::vector<std::string> scattered = {"single_scattering", "single_scattering_marched"};
    static const std::vector<OffRule> rules = {
        {"no aerosol", {"mie_scattering", "mie_absorption"}, spectra},
        {"no ozone", {"ozone_absorption"}, spectra},
        {"Lorentzian ozone", {"ozone_absorption"}, spectra},
        {"Henyey-Greenstein aerosol", {"mie_scattering"}, scattered},
        {"fog", {"mie_scattering"}, scattered},
        // The planet hides nothing from a sun above the horizon.
        {"no planet shadow", {}, {"transmittance_to_space"}},
    };
    return rules;
}

/// Zeroes the atmosphere's members; for the planet's shadow turns the sun above the horizon.
std::vector<float> switched_off(const OffRule& rule, const Function& function, const Manifest& manifest,
                                std::vector<float> inputs) {
    std::size_t at = 0;
    for (const Member& parameter : function.parameters) {
        for (const std::string& name : leaf_names(manifest, parameter.type, parameter.name)) {
            for (const std::string& member : rule.zeroed) {
                if (name.rfind("atmosphere." + member + ".", 0) == 0) {
                    inputs[at] = 0;
                }
            }
            if (rule.zeroed.empty() && name == "mu") {
                inputs[at] = std::abs(inputs[at]);
            }
            ++at;
        }
    }
    return inputs;
}

void compare_off(const Manifest& manifest, const GlslFolder& glsl, bool software_gl, Counter& counter) {
    constexpr std::size_t count = 2048;
    const auto scene_number = [](const std::string& name) {
        const auto& names = scene_names();
        const auto found = std::find_if(names.begin(), names.end(),
                                        [&](const SceneName& scene) { return scene.name == name; });
        if (found == names.end()) {
            throw support::Error("no scene is called '" + name + "' in scenes.hpp");
        }
        return static_cast<std::size_t>(found - names.begin());
    };
    for (const OffRule& rule : off_rules()) {
        const std::size_t scene = scene_number(rule.scene);
        for (const std::string& name : rule.functions) {
            const Function* const function = manifest.function(name);
            const auto row = std::find_if(all_rows().begin(), all_rows().end(),
                                          [&](const Row& r) { return r.function == name; });
            if (function == nullptr || row == all_rows().end()) {
                counter.check(false, "'" + name + "' is not in the manifest or has no row");
                continue;
            }
            std::vector<float> flat;
            std::vector<std::vector<float>> inputs;
            std::size_t nonzero = 0;
            for (std::size_t i = 0; i < count; ++i) {
                Draw draw(7, i, count);
                inputs.push_back(switched_off(rule, *function, manifest, row->draw(draw)));
                for (const float x : inputs.back()) {
                    flat.push_back(std::isinf(x) ? 1e30F : x);
                }
            }
            const std::size_t per_result = row->result_signature.size();
            const auto on_gpu = [&](std::size_t which) {
                return run_shader(
                    function_shader(manifest, *function, glsl, scene_names()[which], false, Compiled::pinned),
                    name, flat, count, per_result);
            };
            const std::vector<float> with = on_gpu(0);
            const std::vector<float> without = on_gpu(scene);
            std::size_t cpu_different = 0;
            std::size_t gpu_different = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const Evaluation a = row->evaluate(0, false, inputs[i]);
                const Evaluation b = row->evaluate(scene, false, inputs[i]);
                for (std::size_t c = 0; c < per_result; ++c) {
                    nonzero += a.in_float[c] != 0 ? 1 : 0;
                    // Equal, not close: adding 0 and multiplying it by anything finite rounds nothing.
                    cpu_different +=
                        a.in_float[c] != b.in_float[c] || a.in_double[c] != b.in_double[c] ? 1 : 0;
                    const float x = with[i * per_result + c];
                    const float y = without[i * per_result + c];
                    // A GPU may compile the two shaders differently; then the bound of the specification
                    // holds.
                    gpu_different += software_gl
                                         ? (x != y ? 1 : 0)
                                         : (std::abs(static_cast<double>(x) - static_cast<double>(y)) >
                                                    2 * a.bounds[c][hardware]
                                                ? 1
                                                : 0);
                }
            }
            std::cout << name << ", " << rule.scene << ": " << count << " inputs, " << cpu_different
                      << " numbers differ in C++, " << gpu_different << " on the GPU\n";
            counter.check(nonzero > count / 2, name + ": almost all results are 0, which proves nothing");
            counter.check(cpu_different == 0, name + " with the term of '" + rule.scene +
                                                  "' at zero is not the same as without it, in C++");
            counter.check(gpu_different == 0, name + " with the term of '" + rule.scene +
                                                  "' at zero is not the same as without it, on the GPU");
        }
    }
    for (const SceneName& scene : scene_names()) {
        // A count of nodes switches nothing off.
        const bool covered = scene.defines.empty() || scene.defines.front().macro == "AIRLIGHT_NODES" ||
                             std::any_of(off_rules().begin(), off_rules().end(),
                                         [&](const OffRule& rule) { return rule.scene == scene.name; });
        counter.check(covered, "the scene '" + scene.name + "' has no rule in variants.cpp");
    }
}

// ---- an edited shader is noticed ----

/// Every number in the body of a function, one edit each: the file with that number changed.
struct Edit {
    std::string description;
    std::string text;
};

std::vector<Edit> edits_of(const Function& function, const std::string& text) {
    std::vector<Edit> out;
    // A definition starts a line with its result type and opens its brace before any ';'.
    const std::string call = " " + function.glsl + "(";
    std::size_t begin = std::string::npos;
    for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
        const std::size_t line = text.rfind('\n', at) + 1;
        const std::size_t brace = text.find_first_of("{;", at);
        if (line != at && text.find_first_of(" /", line) == at && text[brace] == '{') {
            begin = brace + 1;
            break;
        }
    }
    if (begin == std::string::npos) {
        throw support::Error("no definition of " + function.glsl + " in " + function.file);
    }
    const std::size_t end = text.find("\n}", begin);
    std::string body = text.substr(begin, end - begin);
    for (std::size_t at = body.find("//"); at != std::string::npos; at = body.find("//", at)) {
        while (at < body.size() && body[at] != '\n') {
            body[at++] = ' ';  // numbers in comments do not count
        }
    }
    const auto add = [&](std::size_t at, const std::string& old, const std::string& with) {
        out.push_back(
            {old + " to " + with, text.substr(0, begin + at) + with + text.substr(begin + at + old.size())});
    };
    const std::string digits = "0123456789";
    for (std::size_t at = 0; at < body.size(); ++at) {
        const bool inside = at > 0 && (std::isalnum(static_cast<unsigned char>(body[at - 1])) != 0 ||
                                       body[at - 1] == '_' || body[at - 1] == '.');
        if (inside || digits.find(body[at]) == std::string::npos) {
            continue;
        }
        std::size_t length = 0;  // of the number: digits, a point, digits, perhaps an exponent
        static_cast<void>(std::stod(body.substr(at, 64), &length));
        const std::string old = body.substr(at, length);
        if (old.find('.') == std::string::npos) {
            continue;  // a count
        }
        // The bounds of a clamped cosine, which it passes by a roundoff at most.
        const std::string bounds = "-1.0, 1.0)";
        if ((at > 0 && body.compare(at - 1, bounds.size(), bounds) == 0) ||
            (at > 5 && body.compare(at - 6, bounds.size(), bounds) == 0)) {
            at += length;
            continue;
        }
        const double value = std::stod(old);
        std::string with = std::to_string(value != 0 ? value * 1.01 : 1.0);
        if (std::abs(value) > 1e6 || (value != 0 && std::abs(value) < 1e-3)) {
            with = old;
            with[0] = with[0] == '9' ? '8' : static_cast<char>(with[0] + 1);
        }
        add(at, old, with);
        at += length;
    }
    if (out.empty()) {  // no number of its own: turn a sign or an operation
        const std::vector<std::pair<std::string, std::string>> swaps = {
            {" * ", " + "}, {" + ", " - "}, {" - ", " + "}, {" / ", " * "}, {"exp(-", "exp("}};
        for (const auto& [old, with] : swaps) {
            const std::size_t at = body.find(old);
            if (at != std::string::npos) {
                add(at, old, with);
            }
        }
    }
    return out;
}

void try_edits(const Manifest& manifest, const GlslFolder& glsl, const Settings& settings, Counter& counter) {
    const ScratchFolder scratch("edits");
    std::filesystem::copy(
        glsl.folder, scratch.path,
        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);

    Settings few = settings;
    few.share = 1.0 / 16;
    few.stop_early = true;
    std::size_t noticed = 0;
    std::size_t all = 0;
    for (const Function& function : manifest.functions) {
        const auto row = std::find_if(all_rows().begin(), all_rows().end(),
                                      [&](const Row& r) { return r.function == function.name; });
        if (row == all_rows().end()) {
            continue;  // the functions test says so
        }
        const std::string text = support::read_file(glsl.folder / function.file);
        std::size_t noticed_here = 0;
        const std::vector<Edit> edits = edits_of(function, text);
        for (const Edit& edit : edits) {
            support::write_file(scratch.path / function.file, edit.text);
            const bool failed =
                !run_row(*row, function, manifest, GlslFolder{scratch.path}, few).failures.empty();
            noticed_here += failed ? 1 : 0;
            if (!failed) {
                std::cout << function.name << ": not noticed: " << edit.description << "\n";
            }
        }
        support::write_file(scratch.path / function.file, text);
        noticed += noticed_here;
        all += edits.size();
        const bool calls_only = edits.empty();  // nothing of its own to edit: its callees are
        counter.check(
            calls_only || noticed_here > 0,
            function.name + ": none of " + std::to_string(edits.size()) + " edits of its GLSL was noticed");
    }
    std::cout << noticed << " of " << all << " edits of one number in a generated file were noticed\n";
    // What is left are numbers that do not matter, such as the 1 in max(steps, 1) or the 0 in max(x, 0).
    counter.check(static_cast<double>(noticed) >= 0.9 * static_cast<double>(all),
                  "only " + std::to_string(noticed) + " of " + std::to_string(all) + " edits were noticed");
}

int run(const Options& options) {
    const Manifest manifest = read_manifest(options.glsl.folder / "manifest.json");
    const std::unique_ptr<support::GlContext> context = open_context();
    if (context == nullptr) {
        return skipped;
    }
    std::cout << "driver: " << context->renderer() << ", " << context->version() << "\n";
    Settings settings;
    settings.software_gl = is_software(context->renderer());
    Counter counter;
    if (options.only.empty() || options.only == "compile") {
        compile_everything(manifest, options.glsl, counter);
        std::cout << counter.passed << " shaders compiled\n";
    }
    if (options.only.empty() || options.only == "off") {
        compare_off(manifest, options.glsl, settings.software_gl, counter);
    }
    if (options.only.empty() || options.only == "edits") {
        measure_builtins(settings.seed);
        try_edits(manifest, options.glsl, settings, counter);
    }
    std::cout << counter.passed << " checks passed, " << counter.failures.size() << " failed\n";
    for (const std::string& failure : counter.failures) {
        std::cout << "FAILED: " << failure << "\n";
    }
    return counter.failures.empty() ? 0 : 1;
}

}  // namespace
}  // namespace parity

int main(int argc, char** argv) {
    parity::Options options;
    CLI::App app(
        "Compiles every generated GLSL file in every version and with every flag on this machine's driver, "
        "compares\n"
        "terms that are off with coefficients of zero, and checks that an edited shader is noticed.",
        "parity_variants");
    parity::add_glsl(app, options.glsl);
    parity::add_value(app, "--only", "<part>", options.only, "compile, off or edits")
        ->check(CLI::IsMember({"compile", "off", "edits"}));
    app.footer("Exit status: 0 all pass, 1 something fails, 2 wrong use, 77 no OpenGL on this machine.");
    return parity::guarded_main(app, argc, argv, [&] { return parity::run(options); });
}
