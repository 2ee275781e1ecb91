#include "parameters.hpp"

#include <algorithm>
#include <cstring>
#include <set>

namespace cpu_bench {
namespace {

/// What a parameter is given, by type and name: C++ in which `draw` is a Draw<T> and `atmosphere` the
/// scene's. "type function.parameter" wins over "type parameter".
const std::map<std::string, std::string> inputs_by_name = {
    {"vec3 a", "draw.direction"},
    {"vec3 albedo", "draw.color(0, 1)"},
    {"StripApproach approach",
     "airlight::strip_approach(strip_of<T>(), draw.place(), draw.direction, T(2e4))"},
    {"float along", "(atmosphere.ground_radius + draw.altitude) * draw.mu"},
    {"float strip_corner.across", "draw.choose(2) ? T(1) : T(-1)"},
    {"float strip_corner.along", "draw.choose(2) ? T(1) : T(-1)"},
    {"float alpha", "draw.between(0, 1)"},
    {"float altitude", "draw.altitude"},
    {"vec3 after", "draw.color(0, 5)"},
    {"HabitatAir air", "habitat_of<T>(atmosphere)"},
    {"vec3 ambient_scattering", "atmosphere.rayleigh_scattering"},
    {"float azimuth_cosine", "draw.between(-1, 1)"},
    {"vec3 b", "draw.to_sun"},
    {"vec3 before", "draw.color(0, 5)"},
    {"vec3 begin", "draw.direction"},
    {"float bend", "T(0.225)"},
    {"float bent", "draw.between(-1, 1)"},
    {"float passed_of_stretch.begin", "draw.between(0, 1)"},
    {"vec3 centre", "draw.direction"},
    {"float centre", "atmosphere.ozone_altitude"},
    {"vec3 occultation_by_sphere.centre", "draw.decades(6, 9) * draw.direction"},
    {"vec3 sunlight_past_sphere.centre", "draw.decades(6, 9) * draw.direction"},
    {"float density", "draw.between(0.6, 1)"},
    {"bool climbs", "draw.choose(2)"},
    {"bool climbing", "draw.choose(2)"},
    {"float contrast", "draw.between(0.02, 0.05)"},
    {"float cos_between", "draw.mu"},
    {"float cos_incidence", "draw.mu_s"},
    {"float cos_sphere", "glm::abs(draw.cos_theta)"},
    {"float cos_theta", "draw.cos_theta"},
    {"vec3 depth", "draw.color(0, 2)"},
    {"float depolarisation_ratio", "draw.between(0, 0.05)"},
    {"vec3 direction", "draw.direction"},
    {"float distance", "draw.distance"},
    {"float droplet_diameter_um", "draw.between(5, 50)"},
    {"float passed_of_stretch.end", "draw.between(1, 2)"},
    {"vec3 end", "draw.to_sun"},
    {"float excess", "draw.decades(2, 6)"},
    {"float exponent", "draw.between(0.5, 2)"},
    {"float exposure", "draw.between(1, 20)"},
    {"float extent", "draw.decades(2, 5)"},
    {"vec3 eye", "draw.place()"},
    {"Viewpoint eye", "airlight::Viewpoint<T>{draw.altitude, draw.up}"},
    {"float factor", "draw.choose(2) ? T(1) : T(-1)"},
    {"bool first_order", "false"},
    {"vec3 far_depth", "draw.color(0, 5)"},
    {"float from", "draw.between(0, 0.5)"},
    {"vec3 from", "draw.place()"},
    {"float g", "atmosphere.mie_g"},
    {"float gas_constant", "T(287.05)"},
    {"float gap", "draw.between(-1.1, 1.1)"},
    {"float gravity", "draw.between(1, 10)"},
    {"float ground_radius", "atmosphere.ground_radius"},
    {"float half_length", "T(24e3)"},
    {"float half_width", "atmosphere.ozone_half_width"},
    {"float windowed_power.half_width", "draw.between(0, 0.1)"},
    {"float height", "atmosphere.rayleigh_scale_height"},
    {"float high", "atmosphere.ozone_altitude"},
    {"float high_radius", "atmosphere.ground_radius + draw.decades(4, 5)"},
    {"float horizon", "airlight::horizon_cosine(atmosphere.ground_radius, draw.altitude)"},
    {"float inverse_radius", "T(1) / (atmosphere.ground_radius + draw.altitude)"},
    {"float inverse_root", "draw.between(0.001, 0.1)"},
    {"float k", "draw.between(-0.9, 0.9)"},
    {"float light_lost_in_shadow.offset", "draw.between(0, 1)"},
    {"LinearLight light", "strip_of<T>()"},
    {"HabitatLights lights", "airlight::rama_lights<T>()"},
    {"PointLight light", "lamp_of<T>()"},
    {"float limb_exponent", "draw.between(0.3, 0.7)"},
    {"float lit", "draw.decades(2, 5)"},
    {"float low", "atmosphere.ozone_altitude - atmosphere.ozone_half_width"},
    {"float low_along", "draw.decades(2, 5)"},
    {"float low_radius", "atmosphere.ground_radius + draw.decades(0, 4)"},
    {"float lowest_sun", "T(-0.2)"},
    {"float max_distance", "T(1e5)"},
    {"float middle", "draw.between(-0.5, 0)"},
    {"vec3 mean_radiance", "draw.color(0, 1)"},
    {"float mie_g", "atmosphere.mie_g"},
    {"float mu", "draw.mu"},
    {"vec3 mie", "draw.color(0, 1)"},
    {"float mu_normal", "draw.mu"},
    {"float mu_s", "draw.mu_s"},
    {"float new_units_per_old_unit", "draw.between(0.001, 1)"},
    {"vec3 near_depth", "draw.color(0, 5)"},
    {"vec3 normal", "draw.up"},
    {"float nu", "draw.between(-1, 1)"},
    {"float number_density", "T(2.5e25)"},
    {"vec3 optical_depth", "draw.color(0, 2)"},
    {"float outwards", "draw.choose(2) ? T(1) : T(-1)"},
    {"float perigee_altitude", "draw.between(0, 1) * draw.altitude"},
    {"float perigee_radius", "atmosphere.ground_radius + draw.between(0, 1) * draw.altitude"},
    {"Viewpoint place", "airlight::Viewpoint<T>{draw.altitude, draw.up}"},
    {"vec3 sunlight_past_ground.position", "draw.decades(3, 6) * draw.direction"},
    {"vec3 viewpoint_from_centre.position", "(atmosphere.ground_radius + draw.altitude) * draw.up"},
    {"vec3 viewpoint_from_surface.position", "draw.decades(0, 5) * draw.direction"},
    {"float power", "draw.between(0.2, 1.4)"},
    {"float pulled", "draw.between(-5, 5)"},
    {"bool reaches_ground", "draw.mu < T(0)"},
    {"vec3 radiance", "draw.color(0, 10)"},
    {"float line_point.radius", "(atmosphere.ground_radius + draw.altitude)"},
    {"float line_towards_sun.radius", "(atmosphere.ground_radius + draw.altitude)"},
    {"float peak", "draw.between(0, 50)"},
    {"float peak_node.width", "draw.between(10, 100)"},
    {"float strip_nearness.width", "draw.between(10, 100)"},
    {"vec3 origin", "draw.place()"},
    {"vec3 position", "draw.place()"},
    {"vec3 light_position", "draw.place()"},
    {"float radius", "atmosphere.ground_radius"},
    {"float range", "T(1e5)"},
    {"vec3 rayleigh", "draw.color(0, 1)"},
    {"float rayleigh_column", "draw.between(0, 1e4)"},
    {"float reference_wavelength", "T(5.5e-7)"},
    {"float refractivity", "draw.between(2e-4, 4e-4)"},
    {"vec3 right", "draw.to_sun"},
    {"float rise", "draw.decades(4, 5)"},
    {"float root", "draw.between(100, 400)"},
    {"float scale_height", "atmosphere.rayleigh_scale_height"},
    {"vec3 scattering", "atmosphere.mie_scattering"},
    {"float share", "draw.between(0, 1)"},
    {"float shell_altitude", "atmosphere.ozone_altitude"},
    {"vec3 shells", "draw.color(1e5, 1e6)"},
    {"float sin_between", "glm::sqrt((T(1) - draw.mu) * (T(1) + draw.mu))"},
    {"float sin_radius", "draw.between(0.004, 0.005)"},
    {"float sin_sphere", "glm::sqrt((T(1) - draw.cos_theta) * (T(1) + draw.cos_theta))"},
    {"float sine", "glm::sqrt((T(1) - draw.mu) * (T(1) + draw.mu))"},
    {"float single_scattering_albedo", "draw.between(0.8, 1)"},
    {"bool sinks", "draw.mu < T(0)"},
    {"vec3 slope", "draw.color(0, 5)"},
    {"vec3 solar_irradiance", "draw.color(1, 2)"},
    {"float solid_angle", "draw.between(0.1, 6)"},
    {"float slope", "draw.between(-0.5, 0.5)"},
    {"float spin", "draw.between(0, 0.1)"},
    {"float spread", "draw.between(0, 0.1)"},
    {"float square", "draw.between(0, 1.1)"},
    {"float sun_height", "atmosphere.ground_radius * draw.mu_s"},
    {"vec3 surface_radiance", "draw.color(0, 1)"},
    {"float t", "draw.decades(2, 5)"},
    {"float to", "draw.between(0.5, 1)"},
    {"float temperature", "draw.between(200, 400)"},
    {"vec3 to", "draw.place()"},
    {"vec3 to_light", "draw.place()"},
    {"vec3 to_sun", "draw.to_sun"},
    {"float top_altitude", "atmosphere.top_altitude"},
    {"vec3 unit", "draw.color(0, 1)"},
    {"vec3 up", "draw.up"},
    {"vec3 up_at_origin", "draw.up"},
    {"StripView view", "airlight::strip_view(strip_of<T>(), draw.place())"},
    {"float visibility", "draw.decades(3, 5)"},
    {"float wavelength", "draw.between(4e-7, 7e-7)"},
    {"float chapman.x", "draw.between(700, 6000)"},
    {"float windowed_power.x", "draw.between(-0.1, 1)"},
    {"float source_share.x", "draw.between(0, 1)"},
    {"float arc_tangent.x", "draw.between(-1, 1)"},
    {"float passed_of_stretch.x", "draw.between(0, 2)"},
    {"float share_of_half.x", "draw.between(0, 24e3)"},
    {"float dawson.x", "draw.between(-2, 2)"},
    {"float area_sine.x", "draw.decades(-2, 3)"},
    {"float x", "draw.between(0, 5)"},
    {"float y", "draw.between(0, 1)"},
};

/// Parameters for which the range of their type is right: scalars and colours in [0, 1].
const std::set<std::string> inputs_by_type = {
    "chord_distance", "encoded", "extinction", "found",         "light", "linear", "lost", "part", "passed",
    "screen",         "source",  "stored",     "transmittance", "u",     "upper",  "uv",   "uvw",  "whole"};

/// Structures come from functions that take structures; from here on they are put together member by member.
constexpr int deepest = 3;

}  // namespace

std::string template_arguments(const support::Function& function) {
    return function.flags.empty() ? "<T>" : "<T, Scene>";
}

std::string Parameters::value(const std::string& function, const support::Member& parameter, int depth) {
    const std::string& type = parameter.type;
    if (type == "Atmosphere") {
        return "atmosphere";
    }
    if (type == "int") {
        for (const char* const size : {"width", "height", "depth", "size"}) {
            const std::size_t at = parameter.name.rfind(size);
            if (at != std::string::npos && at + std::strlen(size) == parameter.name.size()) {
                return "32";
            }
        }
        for (const char* const number : {"count", "directions", "looks", "pieces"}) {
            if (parameter.name == number) {
                return "8";
            }
        }
        return parameter.name == "steps" ? "16" : "draw.below(4)";  // an index of nodes, of which there are 4
    }
    for (const std::string& name : {function + "." + parameter.name, parameter.name}) {
        const auto found = inputs_by_name.find(type + " " + name);
        if (found != inputs_by_name.end()) {
            return found->second;
        }
    }
    if (type != "float" && type != "bool" && type.compare(0, 3, "vec") != 0) {
        return structure(function, parameter, depth);
    }
    if (inputs_by_type.count(parameter.name) == 0) {
        unknown_[parameter.name] = function;
    }
    if (type == "float") {
        return "draw.between(0, 1)";
    }
    if (type == "bool") {
        return "draw.choose(2)";
    }
    return type == "vec3" ? "draw.color(0, 1)" : "airlight::" + type + "<T>(draw.between(0, 1))";
}

/// As the library makes it: the result of the first function that returns one and takes none.
std::string Parameters::structure(const std::string& function, const support::Member& parameter, int depth) {
    for (const support::Function& maker : manifest_.functions) {
        const auto is_it = [&](const support::Member& p) { return p.type == parameter.type; };
        if (depth > deepest || maker.result != parameter.type ||
            std::any_of(maker.parameters.begin(), maker.parameters.end(), is_it)) {
            continue;
        }
        std::string arguments;
        for (const support::Member& p : maker.parameters) {
            arguments += (arguments.empty() ? "" : ", ") + value(maker.name, p, depth + 1);
        }
        return "airlight::" + maker.name + template_arguments(maker) + "(" + arguments + ")";
    }
    std::string members;
    for (const support::Member& member : manifest_.struct_named(parameter.type).members) {
        members += (members.empty() ? "" : ", ") + value(function, member, depth + 1);
    }
    return "airlight::" + parameter.type + "<T>{" + members + "}";
}

}  // namespace cpu_bench
