#include "compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <set>

#include "support/error.hpp"

namespace parity {
namespace {

/// GLSL has no infinity to rely on: the library's "no surface" is this number there.
constexpr float glsl_no_surface = 1e30F;

/// Floats as consecutive integers, so that neighbours differ by one.
std::int64_t ordinal(float x) {
    std::int32_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits >= 0 ? bits : -static_cast<std::int64_t>(bits & 0x7fffffff);
}

std::string text(const char* format, double a) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, a);
    return buffer.data();
}

bool uses_scene(const Function& function, const Manifest& manifest, const SceneName& scene) {
    return std::all_of(scene.defines.begin(), scene.defines.end(), [&](const SceneDefine& define) {
        return std::any_of(function.flags.begin(), function.flags.end(), [&](const std::string& flag) {
            return manifest.flag(flag).macro == define.macro;
        });
    });
}

/// Adds one scalar result to a tally. Returns false when it is outside its bound.
bool add(Tally& tally, double got, double expected, double bound, const std::vector<float>& inputs,
         std::size_t component, const std::string& scene) {
    ++tally.compared;
    double error = std::abs(got - expected);
    bool inside = error <= bound;
    if (!std::isfinite(expected) || !std::isfinite(got)) {
        const bool no_surface =
            std::isinf(expected) && got == std::copysign(static_cast<double>(glsl_no_surface), expected);
        inside = no_surface || got == expected;
        error = inside ? 0 : HUGE_VAL;
    }
    // Where the expected number is 0 or about to be flushed to 0, digits mean nothing: only the bound counts.
    const bool has_digits = std::abs(expected) >= 4 * smallest_normal && error > 0;
    const double ulp = has_digits ? error_in_ulp(got, expected) : 0;
    const double relative = has_digits ? error / std::abs(expected) : 0;
    const double of_bound = error == 0 ? 0 : (bound > 0 ? error / bound : HUGE_VAL);
    tally.max_ulp = std::max(tally.max_ulp, ulp);
    tally.max_relative = std::max(tally.max_relative, relative);
    tally.max_of_bound = std::max(tally.max_of_bound, of_bound);
    tally.outside += inside ? 0 : 1;
    Worst& worst = tally.worst;
    if (!worst.any || of_bound > worst.of_bound || (of_bound == worst.of_bound && ulp > worst.ulp)) {
        worst = {true, ulp, relative, of_bound, expected, got, bound, component, inputs, scene};
    }
    return inside;
}

std::string compared_line(const char* title, const Tally& tally, const std::vector<std::string>& results,
                          const RowResult& result, const Manifest& manifest) {
    std::string out = std::string("    ") + title + ": ";
    if (tally.compared == 0) {
        return out + "nothing compared\n";
    }
    out += "max " + text("%.4g", tally.max_ulp) + " ulp, " + text("%.2g", tally.max_relative) +
           " relative, " + text("%.2g", tally.max_of_bound) + " of the bound; " +
           std::to_string(tally.compared) + " numbers";
    if (tally.undecided > 0) {
        out += ", " + std::to_string(tally.undecided) + " inputs left out (rounding could turn a branch)";
    }
    const Worst& w = tally.worst;
    out += "\n        worst: " + results[w.component] + " expected " + number_text(w.expected) + " got " +
           number_text(w.got) + ", " + text("%.4g", w.ulp) + " ulp, bound " + text("%.3g", w.bound);
    if (!w.scene.empty()) {
        out += ", scene: " + w.scene;
    }
    const std::string inputs = describe_inputs(*result.function, manifest, w.inputs);
    return out + (inputs.empty() ? "" : "\n        at " + inputs) + "\n";
}

}  // namespace

std::uint64_t ulps_between(float a, float b) {
    const std::int64_t d = ordinal(a) - ordinal(b);
    return static_cast<std::uint64_t>(d < 0 ? -d : d);
}

double error_in_ulp(double got, double expected) {
    if (got == expected) {
        return 0;
    }
    const double size = std::max(std::abs(expected), smallest_normal);
    if (!std::isfinite(size) || !std::isfinite(got)) {
        return HUGE_VAL;
    }
    return std::abs(got - expected) / std::ldexp(1.0, std::ilogb(size) - 23);
}

std::string number_text(double x) {
    return text("%.9g", x) + " (" + text("%a", x) + ")";
}

std::vector<std::string> leaf_names(const Manifest& manifest, const std::string& type,
                                    const std::string& name) {
    if (type == "float" || type == "int" || type == "bool") {
        return {name};
    }
    std::vector<std::string> out;
    if (type == "vec2" || type == "vec3" || type == "vec4") {
        for (int i = 0; i < type[3] - '0'; ++i) {
            out.push_back(name + "." + "xyzw"[i]);
        }
        return out;
    }
    for (const Member& member : manifest.struct_named(type).members) {
        const auto inner = leaf_names(manifest, member.type, name + "." + member.name);
        out.insert(out.end(), inner.begin(), inner.end());
    }
    return out;
}

std::string describe_inputs(const Function& function, const Manifest& manifest,
                            const std::vector<float>& inputs, bool hexadecimal) {
    std::string out;
    std::size_t at = 0;
    for (const Member& parameter : function.parameters) {
        for (const std::string& name : leaf_names(manifest, parameter.type, parameter.name)) {
            const auto x = static_cast<double>(inputs[at++]);
            out +=
                (out.empty() ? "" : ", ") + name + " = " + (hexadecimal ? number_text(x) : text("%.9g", x));
        }
    }
    return out;
}

std::string describe(const RowResult& result, const Manifest& manifest) {
    const std::vector<std::string> names = leaf_names(manifest, result.function->result, "result");
    std::string out =
        result.function->name + ": " + std::to_string(result.inputs) + " inputs, " +
        std::to_string(result.scenes) + (result.scenes == 1 ? " scene" : " scenes") +
        (result.row->tolerance == Tolerance::to_the_bit ? ", to the bit" : ", within the bound") +
        (result.failures.empty() ? "" : "  FAILED") + "\n";
    out += compared_line("GPU against C++ float", result.gpu_float, names, result, manifest);
    out += compared_line("the same, not pinned", result.gpu_plain, names, result, manifest);
    out += compared_line("C++ float against double", result.float_double, names, result, manifest);
    out += compared_line("GPU against C++ double", result.gpu_double, names, result, manifest);
    for (const std::string& failure : result.failures) {
        out += "    FAILED: " + failure + "\n";
    }
    return out;
}

RowResult run_row(const Row& row, const Function& function, const Manifest& manifest, const GlslFolder& glsl,
                  const Settings& settings, const Runner& run) {
    RowResult result;
    result.row = &row;
    result.function = &function;
    std::string manifest_inputs;
    for (const Member& parameter : function.parameters) {
        manifest_inputs += manifest.signature(parameter.type);
    }
    const std::string manifest_results = manifest.signature(function.result);
    if (manifest_inputs != row.input_signature || manifest_results != row.result_signature) {
        result.failures.push_back(
            "the row's scalars are (" + row.input_signature + ") -> (" + row.result_signature +
            "), the manifest's (" + manifest_inputs + ") -> (" + manifest_results +
            "); f float, i int, b bool. Give the row the parameters of " + function.header);
        return result;
    }

    const std::size_t per_input = row.input_signature.size();
    const std::size_t per_result = row.result_signature.size();
    const auto count = std::max<std::size_t>(
        1, per_input == 0 ? 1 : static_cast<std::size_t>(static_cast<double>(row.count) * settings.share));
    const std::size_t gpu = settings.software_gl ? software : hardware;

    for (std::size_t scene = 0; scene < scene_names().size(); ++scene) {
        const SceneName& scene_name = scene_names()[scene];
        if (settings.stop_early && (result.gpu_float.outside > 0 || !result.failures.empty())) {
            break;
        }
        if (!uses_scene(function, manifest, scene_name)) {
            continue;
        }
        // What only passes a count on is the same code under every count.
        const bool counts =
            !scene_name.defines.empty() && scene_name.defines.front().macro == "AIRLIGHT_NODES";
        if (settings.stop_early && counts && !function.calls.empty()) {
            continue;
        }
        for (const bool hooked : {false, true}) {
            // With the hook once, in the default scene: flags and hooks do not meet in the code.
            if (row.hooked_everywhere ? !hooked : hooked && (function.hooks.empty() || scene != 0)) {
                continue;
            }
            ++result.scenes;
            std::string where = scene == 0 && !hooked ? "" : scene_name.name;
            where += hooked ? ", with the tests' hooks" : "";

            std::vector<std::vector<float>> inputs;
            std::vector<float> flat;
            for (std::size_t i = 0; i < count; ++i) {
                Draw draw(settings.seed + scene * 1000003U, i, count, scene_name.fog, scene_name.shadow);
                inputs.push_back(row.draw(draw));
                for (const float x : inputs.back()) {
                    flat.push_back(std::isinf(x) && x > 0 ? glsl_no_surface : x);
                }
            }
            std::vector<float> got;
            std::vector<float> got_plain;
            try {
                const auto run_compiled = [&](Compiled compiled) {
                    return run(function_shader(manifest, function, glsl, scene_name, hooked, compiled),
                               function.file, flat, count, per_result);
                };
                got = run_compiled(settings.webgl ? Compiled::webgl : Compiled::pinned);
                if (!settings.webgl) {
                    got_plain = settings.stop_early ? got : run_compiled(Compiled::as_the_driver_likes);
                }
            } catch (const support::Error& e) {
                result.failures.push_back(std::string("its shader does not run: ") + e.what());
                return result;
            }

            for (std::size_t i = 0; i < count; ++i) {
                const Evaluation cpu = row.evaluate(scene, hooked, inputs[i]);
                ++result.inputs;
                const bool gpu_decided = !cpu.undecided[gpu];
                const bool double_decided = !cpu.undecided[precision];
                result.gpu_float.undecided += gpu_decided ? 0 : 1;
                result.gpu_plain.undecided += cpu.undecided[hardware] ? 1 : 0;
                result.float_double.undecided += double_decided ? 0 : 1;
                result.gpu_double.undecided += gpu_decided && double_decided ? 0 : 1;
                for (std::size_t c = 0; c < per_result; ++c) {
                    const auto expected = static_cast<double>(cpu.in_float[c]);
                    const auto shader = static_cast<double>(got[i * per_result + c]);
                    const Bounded::Bounds& bound = cpu.bounds[c];
                    if (std::isnan(expected)) {
                        if (result.failures.size() < 8) {
                            result.failures.push_back("C++ float gives NaN on the domain, at " +
                                                      describe_inputs(function, manifest, inputs[i]) +
                                                      (where.empty() ? "" : ", scene: " + where));
                        }
                        continue;
                    }
                    // To the bit means: whatever the bound allows for results too small for a normal float.
                    const bool flushed =
                        std::abs(expected) < smallest_normal || std::abs(shader) < smallest_normal;
                    result.above_zero += bound[gpu] > 0 && !flushed ? 1 : 0;
                    result.unbounded += std::isinf(bound[gpu]) || std::isinf(bound[precision]) ? 1 : 0;
                    if (gpu_decided) {
                        add(result.gpu_float, shader, expected, bound[gpu], inputs[i], c, where);
                    }
                    if (!settings.webgl && !cpu.undecided[hardware]) {
                        add(result.gpu_plain, static_cast<double>(got_plain[i * per_result + c]), expected,
                            bound[hardware], inputs[i], c, where);
                    }
                    if (double_decided) {
                        add(result.float_double, expected, cpu.in_double[c], bound[precision], inputs[i], c,
                            where);
                    }
                    if (gpu_decided && double_decided) {
                        add(result.gpu_double, shader, cpu.in_double[c], bound[gpu] + bound[precision],
                            inputs[i], c, where);
                    }
                }
            }
        }
    }

    const auto check_tally = [&](const Tally& tally, const std::string& title, double most_left_out) {
        if (tally.outside > 0) {
            result.failures.push_back(title + ": " + std::to_string(tally.outside) + " of " +
                                      std::to_string(tally.compared) + " numbers are outside their bound");
        }
        if (static_cast<double>(tally.undecided) > most_left_out * static_cast<double>(result.inputs)) {
            result.failures.push_back(
                title + ": " + std::to_string(tally.undecided) + " of " + std::to_string(result.inputs) +
                " inputs were left out because rounding could turn a branch; that is too many "
                "for the test to mean anything");
        }
    };
    if (static_cast<double>(result.unbounded) >
        row.most_unbounded * static_cast<double>(result.inputs * per_result)) {
        result.failures.push_back(
            "for " + std::to_string(result.unbounded) + " of " + std::to_string(result.inputs * per_result) +
            " numbers no bound exists: the function divides by something that may be 0");
    }
    // On software GL only a built-in's error can turn a branch; elsewhere any rounding can, and a good part
    // of the inputs are end points, where branches meet.
    check_tally(result.gpu_float, "GPU against C++ float", settings.software_gl ? 0.01 : row.most_undecided);
    check_tally(result.gpu_plain, "GPU, not pinned, against C++ float", row.most_undecided);
    check_tally(result.float_double, "C++ float against C++ double", row.most_undecided);
    check_tally(result.gpu_double, "GPU against C++ double", row.most_undecided);
    if (settings.software_gl && row.tolerance == Tolerance::to_the_bit && result.above_zero > 0) {
        result.failures.push_back(
            "the row says to_the_bit, but the function calls exp, log or pow: use within_bound");
    }
    if (settings.software_gl && row.tolerance == Tolerance::within_bound && result.above_zero == 0) {
        result.failures.push_back(
            "the row says within_bound, but nothing in the function may differ: use to_the_bit");
    }
    return result;
}

}  // namespace parity
