#include "settings_text.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace deferred {
namespace {

/// Digits enough to bring the same float back, and a point where an int would be read.
std::string number(float value) {
    char text[32];
    for (int digits = 7; digits <= 9; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, double(value));
        if (std::strtof(text, nullptr) == value) {
            break;
        }
    }
    std::string written = text;
    if (written.find_first_of(".e") == std::string::npos) {
        written += ".0";
    }
    return written;
}

/// The members of an atmosphere in their order, one a line.
std::string members(const airlight::Atmosphere<float>& a, const std::string& vector,
                    const std::string& suffix) {
    std::string text;
    const auto add = [&](const std::string& value, const char* name, bool last = false) {
        std::string line = "    " + value + (last ? "" : ",");
        line.resize(std::max<std::size_t>(line.size() + 2, 72), ' ');
        text += line + "// " + name + "\n";
    };
    const auto one = [&](float value) { return number(value) + suffix; };
    const auto three = [&](const airlight::vec3<float>& v) {
        return vector + "(" + one(v.x) + ", " + one(v.y) + ", " + one(v.z) + ")";
    };
    add(one(a.ground_radius), "ground_radius [m]");
    add(one(a.top_altitude), "top_altitude [m]");
    add(three(a.rayleigh_scattering), "rayleigh_scattering [1/m]");
    add(one(a.rayleigh_scale_height), "rayleigh_scale_height [m]");
    add(three(a.mie_scattering), "mie_scattering [1/m]");
    add(three(a.mie_absorption), "mie_absorption [1/m]");
    add(one(a.mie_scale_height), "mie_scale_height [m]");
    add(one(a.mie_g), "mie_g [1]");
    add(three(a.ozone_absorption), "ozone_absorption [1/m]");
    add(one(a.ozone_altitude), "ozone_altitude [m]");
    add(one(a.ozone_half_width), "ozone_half_width [m]");
    add(three(a.ground_albedo), "ground_albedo [1]", true);
    return text;
}

}  // namespace

std::string as_cpp(const World& world) {
    return "struct Scene : airlight::DefaultScene {\n    static constexpr int ozone = airlight::" +
           std::string(world.lorentzian_ozone ? "ozone_lorentzian" : "ozone_tent") +
           ";\n    static constexpr int nodes = " + std::to_string(world.nodes) +
           ";\n};\n\nconst airlight::Atmosphere<float> air{\n" +
           members(world.atmosphere, "airlight::vec3<float>", "f") + "};\n";
}

std::string as_glsl(const World& world) {
    return "#define AIRLIGHT_OZONE " +
           std::string(world.lorentzian_ozone ? "AIRLIGHT_OZONE_LORENTZIAN" : "AIRLIGHT_OZONE_TENT") +
           "\n#define AIRLIGHT_NODES " + std::to_string(world.nodes) +
           "\n#include \"airlight.glsl\"\n\nconst airlight_Atmosphere air = airlight_Atmosphere(\n" +
           members(world.atmosphere, "vec3", "") + ");\n";
}

}  // namespace deferred
