#pragma once

// The scenes in which functions with flags are compared, C++ type and shader defines side by side, and the
// hooks that both sides compile.

#include <airlight/diffuse_light.hpp>
#include <airlight/froxel_table.hpp>
#include <airlight/gathered_light.hpp>
#include <airlight/habitat_indirect.hpp>
#include <airlight/scene.hpp>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "../support/scenes.hpp"

namespace parity {

using airlight_test::Fog;
using airlight_test::HenyeyGreenstein;
using airlight_test::Lorentzian;
using airlight_test::Nodes;
using airlight_test::NoMie;
using airlight_test::NoOzone;
using airlight_test::NoShadow;

using SceneTypes =
    std::tuple<airlight::DefaultScene, NoMie, NoOzone, Lorentzian, HenyeyGreenstein, Fog, NoShadow, Nodes<3>,
               Nodes<4>, Nodes<5>, Nodes<6>, Nodes<10>, Nodes<12>, Nodes<16>, Nodes<24>>;

/// One define of the shader: macro and value. Values at their defaults are not listed.
struct SceneDefine {
    std::string macro;
    std::string value;
};

struct SceneName {
    std::string name;
    std::vector<SceneDefine> defines;
    bool fog = false;    ///< Atmosphere::mie_g is a droplet diameter
    bool shadow = true;  ///< Scene::planet_shadow
};

/// In the order of SceneTypes.
inline const std::array<SceneName, std::tuple_size_v<SceneTypes>>& scene_names() {
    static const std::array<SceneName, std::tuple_size_v<SceneTypes>> names = {
        SceneName{"default", {}},
        SceneName{"no aerosol", {{"AIRLIGHT_MIE", "0"}}},
        SceneName{"no ozone", {{"AIRLIGHT_OZONE", "AIRLIGHT_OZONE_NONE"}}},
        SceneName{"Lorentzian ozone", {{"AIRLIGHT_OZONE", "AIRLIGHT_OZONE_LORENTZIAN"}}},
        SceneName{"Henyey-Greenstein aerosol", {{"AIRLIGHT_MIE_PHASE", "AIRLIGHT_PHASE_HENYEY_GREENSTEIN"}}},
        SceneName{"fog", {{"AIRLIGHT_MIE_PHASE", "AIRLIGHT_PHASE_FOG"}}, true},
        SceneName{"no planet shadow", {{"AIRLIGHT_PLANET_SHADOW", "0"}}, false, false},
        SceneName{"3 nodes", {{"AIRLIGHT_NODES", "3"}}},
        SceneName{"4 nodes", {{"AIRLIGHT_NODES", "4"}}},
        SceneName{"5 nodes", {{"AIRLIGHT_NODES", "5"}}},
        SceneName{"6 nodes", {{"AIRLIGHT_NODES", "6"}}},
        SceneName{"10 nodes", {{"AIRLIGHT_NODES", "10"}}},
        SceneName{"12 nodes", {{"AIRLIGHT_NODES", "12"}}},
        SceneName{"16 nodes", {{"AIRLIGHT_NODES", "16"}}},
        SceneName{"24 nodes", {{"AIRLIGHT_NODES", "24"}}},
    };
    return names;
}

/// A visibility hook that depends on every coordinate and reaches 0 and 1: lit on one side of the eye.
struct PartlyLit {
    template <typename T>
    T operator()(const airlight::vec3<T>& position) const {
        const T reach = glm::abs(position.x) + glm::abs(position.y) + glm::abs(position.z);
        return reach > T(0)
                   ? glm::clamp(T(0.5) + (position.x - T(0.5) * position.y + T(0.25) * position.z) / reach,
                                T(0), T(1))
                   : T(1);
    }
};

/// A hook that depends on every coordinate of light and place.
struct PartlySeen {
    template <typename T>
    T operator()(const airlight::vec3<T>& light_position, const airlight::vec3<T>& position) const {
        const airlight::vec3<T> way = light_position - position;
        const T reach = glm::abs(way.x) + glm::abs(way.y) + glm::abs(way.z);
        return reach > T(0)
                   ? glm::clamp(T(0.5) + (way.x - T(0.5) * way.y + T(0.25) * way.z) / reach, T(0), T(1))
                   : T(1);
    }
};

/// Light from all sides that differs in each of its parts.
struct UnevenLight {
    template <typename T>
    airlight::DiffuseLight<T> operator()(T altitude, T mu_s) const {
        const T strength = (T(2) + mu_s) * (T(10000) / (T(10000) + altitude));
        const auto colour = [&](T red, T green, T blue) {
            return strength * airlight::vec3<T>(red, green, blue);
        };
        return airlight::DiffuseLight<T>{colour(T(0.5), T(0.75), T(1)),     colour(T(-0.125), T(0), T(0.25)),
                                         colour(T(0.125), T(0.25), T(0.5)), colour(T(0.25), T(0.125), T(0)),
                                         colour(T(0.5), T(0.25), T(0.125)), colour(T(0.25), T(0.5), T(0.125)),
                                         colour(T(2), T(1.5), T(1)),        colour(T(0.25), T(0.25), T(0.5)),
                                         colour(T(0.5), T(0.75), T(1))};
    }
};

/// Irradiance of the ground that rises with the sun.
struct LitGround {
    template <typename T>
    airlight::vec3<T> operator()(T mu_s) const {
        return (T(1) + mu_s) * airlight::vec3<T>(T(0.125), T(0.25), T(0.5));
    }
};

/// What stands in for the tables of scattered light: a little of every number that they are read with.
struct StandInTable {
    template <typename T>
    airlight::vec3<T> operator()(T, T mu, T mu_s, T nu, bool reaches_ground) const {
        const T light = T(1) + T(0.25) * mu + T(0.5) * mu_s + T(0.125) * nu;
        return airlight::vec3<T>(light, T(0.5) * light, reaches_ground ? T(0.25) * light : T(2) * light);
    }
    template <typename T>
    airlight::vec3<T> operator()(T mu_s) const {
        const T light = T(1) + T(0.5) * mu_s;
        return airlight::vec3<T>(light, T(2) * light, T(4) * light);
    }
    template <typename T>
    airlight::vec3<T> operator()(T, T mu_s, int side, int polar, int azimuth) const {
        const T light = T(4 + side) + T(0.5) * T(polar) + mu_s;
        return airlight::vec3<T>(light, light + T(azimuth), T(1));
    }
};

/// Froxels whose light and depth grow with the distance, by no law that the look-up knows.
struct UnevenFroxels {
    template <typename T>
    airlight::FroxelAir<T> operator()(const airlight::vec3<T>& uvw) const {
        const T light = T(1) + T(0.5) * uvw.x + T(0.25) * uvw.y;
        const T far = uvw.z * (T(0.5) + uvw.z);
        return airlight::FroxelAir<T>{
            airlight::vec3<T>(T(0.5) * far, far, T(2) * far) * light,
            airlight::vec3<T>(T(0.25) * uvw.z, uvw.z, T(4) * uvw.z) * light,
        };
    }
};

/// A habitat's light that differs along each coordinate and does not ask its strips.
struct UnevenHabitat {
    template <typename T>
    airlight::vec3<T> operator()(const airlight::HabitatAir<T>& air, const airlight::HabitatLights<T>&,
                                 const airlight::vec3<T>& position) const {
        const T reach = air.radius + glm::abs(position.x) + glm::abs(position.y);
        const T light = T(2) + (position.x - T(0.5) * position.y) / reach;
        return airlight::vec3<T>(light, T(0.5) * light, T(0.25) * light);
    }
};

/// Indirect irradiance of a habitat's wall that differs along each coordinate.
struct UnevenWall {
    template <typename T>
    airlight::vec3<T> operator()(const airlight::vec3<T>& position) const {
        const T reach = T(1) + glm::abs(position.x) + glm::abs(position.y) + glm::abs(position.z);
        const T light = T(2) + (position.x - T(0.5) * position.y + T(0.25) * position.z) / reach;
        return airlight::vec3<T>(T(0.5) * light, light, T(0.25) * light);
    }
};

/// Slants a little more and a little less than guessed.
struct UnevenSlants {
    template <typename T>
    airlight::vec2<T> operator()(const airlight::vec2<T>& uv) const {
        return airlight::vec2<T>(T(0.03125) * uv.x - T(0.0625) * uv.y, T(0.0625) * uv.x * uv.y);
    }
};

/// Light to space that rises with the sun and does not ask the atmosphere.
struct EveningLight {
    template <typename T>
    airlight::vec3<T> operator()(const airlight::Atmosphere<T>&, T altitude, T mu) const {
        const T light = (T(0.5) + T(0.5) * mu) * (T(10000) / (T(10000) + altitude));
        return airlight::vec3<T>(light, T(0.5) * light, T(0.25) * light);
    }
};

/// The same hooks for a shader, by hand: they play the part of the user's own code. A macro is one line:
/// GLSL 3.30 has no line continuation.
inline const char* const hooks_glsl =
    R"glsl(
float parity_partly_lit(vec3 position) {
    float reach = abs(position.x) + abs(position.y) + abs(position.z);
    return reach > 0.0 ? clamp(0.5 + (position.x - 0.5 * position.y + 0.25 * position.z) / reach, 0.0, 1.0) : 1.0;
}
#define AIRLIGHT_VISIBILITY(position) parity_partly_lit(position)

float parity_partly_seen(vec3 light_position, vec3 position) {
    vec3 way = light_position - position;
    float reach = abs(way.x) + abs(way.y) + abs(way.z);
    return reach > 0.0 ? clamp(0.5 + (way.x - 0.5 * way.y + 0.25 * way.z) / reach, 0.0, 1.0) : 1.0;
}
#define AIRLIGHT_LIGHT_VISIBILITY(light_position, position) parity_partly_seen(light_position, position)

float parity_strength(float altitude, float mu_s) {
    return (2.0 + mu_s) * (10000.0 / (10000.0 + altitude));
}
)glsl"
    "#define AIRLIGHT_MULTIPLE_SCATTERING(altitude, mu_s) airlight_DiffuseLight( "
    "parity_strength(altitude, mu_s) * vec3(0.5, 0.75, 1.0), parity_strength(altitude, mu_s) * "
    "vec3(-0.125, 0.0, 0.25), parity_strength(altitude, mu_s) * vec3(0.125, 0.25, 0.5), "
    "parity_strength(altitude, mu_s) * vec3(0.25, 0.125, 0.0), parity_strength(altitude, mu_s) "
    "* vec3(0.5, 0.25, 0.125), parity_strength(altitude, mu_s) * vec3(0.25, 0.5, 0.125), "
    "parity_strength(altitude, mu_s) * vec3(2.0, 1.5, 1.0), parity_strength(altitude, mu_s) * "
    "vec3(0.25, 0.25, 0.5), parity_strength(altitude, mu_s) * vec3(0.5, 0.75, 1.0))"
    R"glsl(
#define AIRLIGHT_GROUND_IRRADIANCE(mu_s) ((1.0 + (mu_s)) * vec3(0.125, 0.25, 0.5))

vec3 parity_table(float mu, float mu_s, float nu, bool reaches_ground) {
    float light = 1.0 + 0.25 * mu + 0.5 * mu_s + 0.125 * nu;
    return vec3(light, 0.5 * light, reaches_ground ? 0.25 * light : 2.0 * light);
}
vec3 parity_irradiance(float mu_s) {
    float light = 1.0 + 0.5 * mu_s;
    return vec3(light, 2.0 * light, 4.0 * light);
}
vec3 parity_light(float mu_s, int side, int polar, int azimuth) {
    float light = float(4 + side) + 0.5 * float(polar) + mu_s;
    return vec3(light, light + float(azimuth), 1.0);
}
#define AIRLIGHT_ORDER_RADIANCE(altitude, mu, mu_s, nu, reaches_ground) parity_table(mu, mu_s, nu, reaches_ground)
#define AIRLIGHT_ORDER_IRRADIANCE(mu_s) parity_irradiance(mu_s)
#define AIRLIGHT_INCIDENT_LIGHT(altitude, mu_s, side, polar, azimuth) parity_light(mu_s, side, polar, azimuth)
#define AIRLIGHT_GATHERED_RAYLEIGH(altitude, mu, mu_s, nu, reaches_ground) parity_table(mu, mu_s, nu, reaches_ground)
#define AIRLIGHT_GATHERED_MIE(altitude, mu, mu_s, nu, reaches_ground) parity_table(mu, mu_s, nu, reaches_ground)
#define AIRLIGHT_SCATTERED_RAYLEIGH(altitude, mu, mu_s, nu, reaches_ground) parity_table(mu, mu_s, nu, reaches_ground)
#define AIRLIGHT_SCATTERED_MIE(altitude, mu, mu_s, nu, reaches_ground) parity_table(mu, mu_s, nu, reaches_ground)
#define AIRLIGHT_MULTIPLE_RADIANCE(altitude, mu, mu_s, nu, reaches_ground) parity_table(mu, mu_s, nu, reaches_ground)

vec3 parity_froxel_light(vec3 uvw) {
    float light = 1.0 + 0.5 * uvw.x + 0.25 * uvw.y;
    float far = uvw.z * (0.5 + uvw.z);
    return vec3(0.5 * far, far, 2.0 * far) * light;
}
vec3 parity_froxel_depth(vec3 uvw) {
    float light = 1.0 + 0.5 * uvw.x + 0.25 * uvw.y;
    return vec3(0.25 * uvw.z, uvw.z, 4.0 * uvw.z) * light;
}
vec3 parity_habitat(float radius, vec3 position) {
    float reach = radius + abs(position.x) + abs(position.y);
    float light = 2.0 + (position.x - 0.5 * position.y) / reach;
    return vec3(light, 0.5 * light, 0.25 * light);
}
#define AIRLIGHT_HABITAT_LIGHT(position) parity_habitat(air.radius, position)
vec3 parity_wall(vec3 position) {
    float reach = 1.0 + abs(position.x) + abs(position.y) + abs(position.z);
    float light = 2.0 + (position.x - 0.5 * position.y + 0.25 * position.z) / reach;
    return vec3(0.5 * light, light, 0.25 * light);
}
#define AIRLIGHT_INDIRECT_IRRADIANCE(position) parity_wall(position)
vec2 parity_slants(vec2 uv) {
    return vec2(0.03125 * uv.x - 0.0625 * uv.y, 0.0625 * uv.x * uv.y);
}
vec3 parity_evening(float altitude, float mu) {
    float light = (0.5 + 0.5 * mu) * (10000.0 / (10000.0 + altitude));
    return vec3(light, 0.5 * light, 0.25 * light);
}
#define AIRLIGHT_FROXEL_TABLE(uvw) airlight_FroxelAir(parity_froxel_light(uvw), parity_froxel_depth(uvw))
#define AIRLIGHT_SLANT_TABLE(uv) parity_slants(uv)
#define AIRLIGHT_TRANSMITTANCE_TO_SPACE(altitude, mu) parity_evening(altitude, mu)
)glsl";

}  // namespace parity
