// Writes the C++ that times every function of the manifest: one function of the library, one benchmark, and
// nothing to add by hand when a function is added.
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/manifest.hpp"
#include "variants.hpp"

namespace cpu_bench {
namespace {

using support::Function;
using support::Manifest;
using support::Member;
using support::Struct;

/// What a parameter is given, by type and name: C++ in which `draw` is a Draw<T> and `atmosphere` the
/// scene's. "type function.parameter" wins over "type parameter".
const std::map<std::string, std::string> inputs_by_name = {
    {"vec3 a", "draw.direction"},
    {"float along", "(atmosphere.ground_radius + draw.altitude) * draw.mu"},
    {"float alpha", "draw.between(0, 1)"},
    {"float altitude", "draw.altitude"},
    {"vec3 ambient_scattering", "atmosphere.rayleigh_scattering"},
    {"vec3 b", "draw.to_sun"},
    {"float centre", "atmosphere.ozone_altitude"},
    {"bool climbing", "draw.choose(2)"},
    {"float contrast", "draw.between(0.02, 0.05)"},
    {"float cos_theta", "draw.cos_theta"},
    {"float depolarisation_ratio", "draw.between(0, 0.05)"},
    {"vec3 direction", "draw.direction"},
    {"float distance", "draw.distance"},
    {"float droplet_diameter_um", "draw.between(5, 50)"},
    {"float exponent", "draw.between(0.5, 2)"},
    {"float exposure", "draw.between(1, 20)"},
    {"float extent", "draw.decades(2, 5)"},
    {"Viewpoint eye", "airlight::Viewpoint<T>{draw.altitude, draw.up}"},
    {"float factor", "draw.choose(2) ? T(1) : T(-1)"},
    {"float g", "atmosphere.mie_g"},
    {"float ground_radius", "atmosphere.ground_radius"},
    {"float half_width", "atmosphere.ozone_half_width"},
    {"float height", "atmosphere.rayleigh_scale_height"},
    {"float high", "atmosphere.ozone_altitude"},
    {"float high_radius", "atmosphere.ground_radius + draw.decades(4, 5)"},
    {"float inverse_radius", "T(1) / (atmosphere.ground_radius + draw.altitude)"},
    {"float inverse_root", "draw.between(0.001, 0.1)"},
    {"float k", "draw.between(-0.9, 0.9)"},
    {"float low", "atmosphere.ozone_altitude - atmosphere.ozone_half_width"},
    {"float low_along", "draw.decades(2, 5)"},
    {"float low_radius", "atmosphere.ground_radius + draw.decades(0, 4)"},
    {"float mu", "draw.mu"},
    {"float mu_s", "draw.mu_s"},
    {"float new_units_per_old_unit", "draw.between(0.001, 1)"},
    {"float number_density", "T(2.5e25)"},
    {"vec3 optical_depth", "draw.color(0, 2)"},
    {"float outwards", "draw.choose(2) ? T(1) : T(-1)"},
    {"float perigee_altitude", "draw.between(0, 1) * draw.altitude"},
    {"float perigee_radius", "atmosphere.ground_radius + draw.between(0, 1) * draw.altitude"},
    {"vec3 viewpoint_from_centre.position", "(atmosphere.ground_radius + draw.altitude) * draw.up"},
    {"vec3 viewpoint_from_surface.position", "draw.decades(0, 5) * draw.direction"},
    {"float pulled", "draw.between(-5, 5)"},
    {"vec3 radiance", "draw.color(0, 10)"},
    {"float line_point.radius", "(atmosphere.ground_radius + draw.altitude)"},
    {"float line_towards_sun.radius", "(atmosphere.ground_radius + draw.altitude)"},
    {"float radius", "atmosphere.ground_radius"},
    {"float rayleigh_column", "draw.between(0, 1e4)"},
    {"float reference_wavelength", "T(5.5e-7)"},
    {"float refractivity", "draw.between(2e-4, 4e-4)"},
    {"float rise", "draw.decades(4, 5)"},
    {"float root", "draw.between(100, 400)"},
    {"float scale_height", "atmosphere.rayleigh_scale_height"},
    {"vec3 scattering", "atmosphere.mie_scattering"},
    {"float shell_altitude", "atmosphere.ozone_altitude"},
    {"vec3 shells", "draw.color(1e5, 1e6)"},
    {"float sine", "glm::sqrt((T(1) - draw.mu) * (T(1) + draw.mu))"},
    {"float single_scattering_albedo", "draw.between(0.8, 1)"},
    {"bool sinks", "draw.mu < T(0)"},
    {"vec3 solar_irradiance", "draw.color(1, 2)"},
    {"float sun_height", "atmosphere.ground_radius * draw.mu_s"},
    {"vec3 surface_radiance", "draw.color(0, 1)"},
    {"float t", "draw.decades(2, 5)"},
    {"vec3 to_sun", "draw.to_sun"},
    {"vec3 up_at_origin", "draw.up"},
    {"float visibility", "draw.decades(3, 5)"},
    {"float wavelength", "draw.between(4e-7, 7e-7)"},
    {"float chapman.x", "draw.between(700, 6000)"},
    {"float x", "draw.between(0, 5)"},
};

/// Parameters for which the range of their type is right: scalars and colours in [0, 1].
const std::set<std::string> inputs_by_type = {"encoded", "linear", "u", "density"};

/// Names of parameters that have no entry, as they are met.
std::map<std::string, std::string> unknown;

std::string template_arguments(const Function& function) {
    return function.flags.empty() ? "<T>" : "<T, Scene>";
}

std::string draw_value(const Manifest& manifest, const std::string& owner, const Member& parameter,
                       int depth);

/// A structure as the library makes it: the result of the first function that returns one.
std::string draw_struct(const Manifest& manifest, const std::string& owner, const Member& parameter,
                        int depth) {
    for (const Function& maker : manifest.functions) {
        bool takes_it = false;
        for (const Member& p : maker.parameters) {
            takes_it = takes_it || p.type == parameter.type;
        }
        if (maker.result != parameter.type || takes_it || depth > 3) {
            continue;
        }
        std::string arguments;
        for (const Member& p : maker.parameters) {
            arguments += (arguments.empty() ? "" : ", ") + draw_value(manifest, maker.name, p, depth + 1);
        }
        return "airlight::" + maker.name + template_arguments(maker) + "(" + arguments + ")";
    }
    std::string members;
    for (const Member& member : manifest.struct_named(parameter.type).members) {
        members += (members.empty() ? "" : ", ") + draw_value(manifest, owner, member, depth + 1);
    }
    return "airlight::" + parameter.type + "<T>{" + members + "}";
}

std::string draw_value(const Manifest& manifest, const std::string& owner, const Member& parameter,
                       int depth) {
    if (parameter.type == "Atmosphere") {
        return "atmosphere";
    }
    if (parameter.type == "int") {
        return parameter.name == "steps" ? "16"
                                         : "draw.below(4)";  // an index of the nodes, of which there are 4
    }
    for (const std::string& name : {owner + "." + parameter.name, parameter.name}) {
        const auto found = inputs_by_name.find(parameter.type + " " + name);
        if (found != inputs_by_name.end()) {
            return found->second;
        }
    }
    if (parameter.type != "float" && parameter.type != "bool" && parameter.type.compare(0, 3, "vec") != 0) {
        return draw_struct(manifest, owner, parameter, depth);
    }
    if (inputs_by_type.count(parameter.name) == 0) {
        unknown[parameter.name] = owner;
    }
    if (parameter.type == "float") {
        return "draw.between(0, 1)";
    }
    if (parameter.type == "bool") {
        return "draw.choose(2)";
    }
    return parameter.type == "vec3" ? "draw.color(0, 1)"
                                    : "airlight::" + parameter.type + "<T>(draw.between(0, 1))";
}

/// AIRLIGHT_OZONE_NONE is airlight::ozone_none.
std::string cpp_value(const support::Flag& flag, const std::string& value) {
    if (flag.type == "bool") {
        return value == "0" ? "false" : "true";
    }
    const std::string prefix = "AIRLIGHT_";
    if (value.compare(0, prefix.size(), prefix) != 0) {
        return value;
    }
    std::string out = value.substr(prefix.size());
    for (char& c : out) {
        c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    }
    return "airlight::" + out;
}

std::string identifier(std::string text) {
    for (char& c : text) {
        const bool keep = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        c = keep ? c : '_';
    }
    return text;
}

/// Every scene that some variant asks for, each once: name of the structure and its definition.
class Scenes {
  public:
    explicit Scenes(const Manifest& manifest) : manifest_(manifest) {}

    std::string name(const std::vector<bench::FlagValue>& values) {
        if (values.empty()) {
            return "airlight::DefaultScene";
        }
        std::string name = "scene";
        std::string members;
        for (const bench::FlagValue& value : values) {
            const support::Flag& flag = manifest_.flag(value.flag);
            name += "_" + identifier(bench::flag_text(flag, value.value));
            members += "    static constexpr " + flag.type + " " + flag.name + " = " +
                       cpp_value(flag, value.value) + ";\n";
        }
        definitions_[name] = "struct " + name + " : airlight::DefaultScene {\n" + members + "};\n";
        return name;
    }

    std::string text() const {
        std::string out;
        for (const auto& [name, definition] : definitions_) {
            out += definition;
        }
        return out;
    }

  private:
    const Manifest& manifest_;
    std::map<std::string, std::string> definitions_;
};

/// The function template that times one function; `steps` is the function's parameter of that name.
std::string timing(const Manifest& manifest, const Function& function) {
    std::string drawn;
    std::string arguments;
    int tuple_index = 0;
    for (const Member& parameter : function.parameters) {
        arguments += arguments.empty() ? "" : ", ";
        if (parameter.type == "Atmosphere") {
            arguments += "atmosphere";
        } else if (parameter.name == "steps") {
            arguments += "steps";
        } else {
            drawn += (drawn.empty() ? "" : ", ") + draw_value(manifest, function.name, parameter, 0);
            arguments += "std::get<" + std::to_string(tuple_index++) + ">(in)";
        }
    }
    return "template <typename T, typename Scene>\nvoid time_" + identifier(function.name) +
           "(benchmark::State& state, int constant) {\n"
           "    [[maybe_unused]] const auto atmosphere = opaque(atmosphere_of<T, Scene>());\n"
           "    [[maybe_unused]] const int steps = opaque(constant);\n"
           "    run_batch<T>(\n        state,\n        [&]([[maybe_unused]] Draw<T>& draw) { return "
           "std::make_tuple(" +
           drawn + "); },\n        [&]([[maybe_unused]] const auto& in) { return airlight::" + function.name +
           template_arguments(function) + "(" + arguments + "); });\n}\n";
}

std::string benchmarks(const Manifest& manifest) {
    Scenes scenes(manifest);
    std::string functions;
    std::string entries;
    for (const Function& function : manifest.functions) {
        functions += timing(manifest, function) + "\n";
        std::vector<bench::Variant> variants = bench::settings(manifest, function);
        const std::vector<bench::Variant> with_flags =
            bench::flag_variants(manifest, function, variants.front());
        variants.insert(variants.end(), with_flags.begin(), with_flags.end());
        for (const bench::Variant& variant : variants) {
            const std::string name = function.name + (variant.setting.empty() ? "" : "/" + variant.setting) +
                                     (variant.flags == "default" ? "" : "/" + variant.flags);
            const int steps = variant.counts.empty() ? 0 : variant.counts.front();
            entries += "    add(\"" + name + "/\" SCALAR_NAME, time_" + identifier(function.name) +
                       "<SCALAR, " + scenes.name(variant.values) + ">, " + std::to_string(steps) + ");\n";
        }
    }
    return "// Written by write_benchmarks from manifest.json; compiled once for each scalar type.\n"
           "#include <tuple>\n\n#include \"batch.hpp\"\n\nnamespace cpu_bench {\nnamespace {\n\n" +
           scenes.text() + "\n" + functions +
           "}  // namespace\n\nvoid ADD_BENCHMARKS(std::vector<std::string>& names) {\n"
           "    const auto add = [&](const char* name, void (*time)(benchmark::State&, int), int steps) {\n"
           "        names.push_back(name);\n        benchmark::RegisterBenchmark(name, time, steps);\n    "
           "};\n" +
           entries + "}\n\n}  // namespace cpu_bench\n";
}

int run(const std::filesystem::path& manifest_file, const std::filesystem::path& output) {
    support::write_file(output, benchmarks(support::read_manifest(manifest_file)));
    for (const auto& [parameter, function] : unknown) {
        std::cout << "note: '" << parameter << "' of " << function
                  << " is drawn from [0, 1]; a better range goes into bench/cpu/write_benchmarks.cpp\n";
    }
    return 0;
}

}  // namespace
}  // namespace cpu_bench

int main(int argc, char** argv) {
    std::filesystem::path manifest;
    std::filesystem::path output;
    CLI::App app("Writes the benchmarks of all functions of a manifest.", "write_benchmarks");
    support::add_value(app, "--manifest", "<file>", manifest, "manifest.json of the generated GLSL")
        ->required();
    support::add_value(app, "--output", "<file>", output, "the C++ file to write")->required();
    return support::guarded_main(app, argc, argv, [&] { return cpu_bench::run(manifest, output); });
}
