#include "support/glsl_values.hpp"

#include <algorithm>
#include <vector>

namespace support {

std::string construct(const Manifest& manifest, const std::string& type, std::size_t& at) {
    const auto next = [&] { return "fetch(base + " + std::to_string(at++) + ")"; };
    if (type == "float") {
        return next();
    }
    if (type == "int") {
        return "int(" + next() + ")";
    }
    if (type == "bool") {
        return next() + " != 0.0";
    }
    std::string out;
    if (type == "vec2" || type == "vec3" || type == "vec4") {
        for (char i = '0'; i < type[3]; ++i) {
            out += (out.empty() ? "" : ", ") + next();
        }
        return type + "(" + out + ")";
    }
    const Struct& description = manifest.struct_named(type);
    for (const Member& member : description.members) {
        out += (out.empty() ? "" : ", ") + construct(manifest, member.type, at);
    }
    return description.glsl + "(" + out + ")";
}

std::string store(const Manifest& manifest, const std::string& type, const std::string& value,
                  const std::string& qualifier, std::size_t& at) {
    const auto line = [&](const std::string& scalar) {
        const std::string k = std::to_string(at++);
        return "    " + qualifier + "float out_" + k + " = " + scalar + ";\n    out_data[out_base + " + k +
               "] = out_" + k + ";\n";
    };
    if (type == "float") {
        return line(value);
    }
    if (type == "int") {
        return line("float(" + value + ")");
    }
    if (type == "bool") {
        return line(value + " ? 1.0 : 0.0");
    }
    std::string out;
    if (type == "vec2" || type == "vec3" || type == "vec4") {
        for (int i = 0; i < type[3] - '0'; ++i) {
            out += line(value + "." + std::string(1, "xyzw"[i]));
        }
        return out;
    }
    for (const Member& member : manifest.struct_named(type).members) {
        out += store(manifest, member.type, value + "." + member.name, qualifier, at);
    }
    return out;
}

std::string glsl_type(const Manifest& manifest, const std::string& type) {
    static const std::vector<std::string> own = {"float", "int", "bool", "vec2", "vec3", "vec4"};
    return std::find(own.begin(), own.end(), type) != own.end() ? type : manifest.struct_named(type).glsl;
}

}  // namespace support
