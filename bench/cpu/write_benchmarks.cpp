// Writes the C++ that times every function of the manifest: one function of the library, one benchmark, and
// nothing to add by hand when a function is added.
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "parameters.hpp"
#include "support/command_line.hpp"
#include "support/files.hpp"
#include "support/manifest.hpp"
#include "variants.hpp"

namespace cpu_bench {
namespace {

using support::Function;
using support::Manifest;
using support::Member;

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
std::string timing(const Function& function, Parameters& parameters) {
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
            drawn += (drawn.empty() ? "" : ", ") + parameters.value(function.name, parameter);
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

std::string benchmarks(const Manifest& manifest, Parameters& parameters) {
    Scenes scenes(manifest);
    std::string functions;
    std::string entries;
    for (const Function& function : manifest.functions) {
        functions += timing(function, parameters) + "\n";
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
    const Manifest manifest = support::read_manifest(manifest_file);
    Parameters parameters(manifest);
    support::write_file(output, benchmarks(manifest, parameters));
    for (const auto& [parameter, function] : parameters.unknown()) {
        std::cout << "note: '" << parameter << "' of " << function
                  << " is drawn from [0, 1]; a better range goes into bench/cpu/parameters.cpp\n";
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
