#include "support/manifest.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/error.hpp"
#include "support/files.hpp"

namespace support {
namespace {

template <typename Items>
auto find_named(const Items& items, const std::string& name) {
    return std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
}

template <typename Items>
const auto& get_named(const Items& items, const std::string& name, const char* kind) {
    const auto found = find_named(items, name);
    if (found == items.end()) {
        throw Error(std::string("manifest.json names the ") + kind + " '" + name +
                    "' but does not describe it; regenerate the GLSL with glslgen");
    }
    return *found;
}

std::vector<Member> read_members(const nlohmann::json& list) {
    std::vector<Member> out;
    for (const auto& item : list) {
        out.push_back({item.at("type"), item.at("name")});
    }
    return out;
}

}  // namespace

const Function* Manifest::function(const std::string& name) const {
    const auto found = find_named(functions, name);
    return found == functions.end() ? nullptr : &*found;
}

const Struct& Manifest::struct_named(const std::string& name) const {
    return get_named(structs, name, "type");
}

const Flag& Manifest::flag(const std::string& name) const {
    return get_named(flags, name, "flag");
}

const Hook& Manifest::hook(const std::string& name) const {
    return get_named(hooks, name, "hook");
}

std::vector<std::string> Manifest::files() const {
    std::vector<std::string> out;
    const auto add = [&](const std::string& file) {
        if (std::find(out.begin(), out.end(), file) == out.end()) {
            out.push_back(file);
        }
    };
    for (const Constant& item : constants) {
        add(item.file);
    }
    for (const Struct& item : structs) {
        add(item.file);
    }
    for (const Function& item : functions) {
        add(item.file);
    }
    return out;
}

std::string Manifest::signature(const std::string& type) const {
    if (type == "float") {
        return "f";
    }
    if (type == "int") {
        return "i";
    }
    if (type == "bool") {
        return "b";
    }
    if (type == "vec2" || type == "vec3" || type == "vec4") {
        return std::string(static_cast<std::size_t>(type[3] - '0'), 'f');
    }
    std::string out;
    for (const Member& member : struct_named(type).members) {
        out += signature(member.type);
    }
    return out;
}

Manifest read_manifest(const std::filesystem::path& file) {
    Manifest out;
    const std::string text = read_file(file);
    try {
        const nlohmann::json json = nlohmann::json::parse(text);
        for (const auto& item : json.at("constants")) {
            out.constants.push_back({item.at("name"), item.at("glsl"), item.at("type"), item.at("value"),
                                     item.at("header"), item.at("file")});
        }
        for (const auto& item : json.at("flags")) {
            out.flags.push_back({item.at("name"), item.at("macro"), item.at("type"), item.at("default"),
                                 item.value("choices", std::vector<std::string>())});
        }
        for (const auto& item : json.at("hooks")) {
            out.hooks.push_back(
                {item.at("name"), item.at("macro"), item.at("parameters"), item.at("default")});
        }
        for (const auto& item : json.at("structs")) {
            out.structs.push_back(
                {item.at("name"), item.at("glsl"), item.at("file"), read_members(item.at("members"))});
        }
        for (const auto& item : json.at("functions")) {
            out.functions.push_back({item.at("name"), item.at("glsl"), item.at("header"), item.at("file"),
                                     read_members(item.at("parameters")), item.at("result"), item.at("flags"),
                                     item.at("hooks"), item.at("calls")});
        }
    } catch (const nlohmann::json::exception& e) {
        throw Error(file.string() + " is not the manifest that glslgen writes: " + e.what());
    }
    return out;
}

}  // namespace support
