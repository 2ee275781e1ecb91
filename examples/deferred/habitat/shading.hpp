#pragma once

#include <airlight/tables/habitat.hpp>

#include "frame.hpp"
#include "habitat/world.hpp"

// The light of a pixel in the habitat, from its G-buffer: the same formulas as shaders/habitat_shading.glsl.

namespace deferred::habitat {

/// The tables that a world's light is looked up in; those it does not need are empty.
struct Tables {
    airlight::Table<vec3> straight;  ///< by AirLight: what passes of the strips' light, or that light itself
    airlight::HabitatIndirectTables<float> indirect;
};

struct Surface {
    vec3 position;  ///< [m] from the cylinder's middle
    vec3 albedo;
    vec3 normal;
    float strip;  ///< share of it that a strip of light fills
};

/// Hook: indirect irradiance of the walls.
struct IndirectIrradiance {
    const World* world;
    const Tables* tables;

    vec3 operator()(const vec3& position) const {
        return world->bounces > 0 ? airlight::sample_habitat(world->air, world->lights,
                                                             tables->indirect.irradiance, position)
                                  : vec3(0);
    }
};

/// Hook: mean radiance of the strips by a table where that is how they are looked up, and of all other light.
struct LightAt {
    const World* world;
    const Tables* tables;

    vec3 operator()(const airlight::HabitatAir<float>& air, const airlight::HabitatLights<float>& lights,
                    const vec3& position) const {
        const vec3 indirect = world->bounces > 0
                                  ? airlight::sample_habitat(air, lights, tables->indirect.mean, position)
                                  : vec3(0);
        if (world->air_light == AirLight::phase) {
            return indirect;
        }
        const vec3 read = airlight::sample_habitat(air, lights, tables->straight, position);
        return world->air_light == AirLight::nodes
                   ? airlight::habitat_bare_radiance(air, lights, position) * read + indirect
                   : read + indirect;
    }
};

/// Light that leaves the surface towards the eye.
inline vec3 light_of_surface(const World& world, const Tables& tables, const Surface& surface) {
    const vec3 land = airlight::habitat_wall_radiance<float, airlight::DefaultScene>(
        world.air, world.lights, surface.albedo, surface.position, surface.normal, airlight::AlwaysSeen{},
        IndirectIrradiance{&world, &tables});
    return land * (1 - surface.strip) + world.lights.radiance * surface.strip;
}

/// Light of the air between the eye and a surface.
inline vec3 light_of_air(const World& world, const Tables& tables, const vec3& eye, const vec3& direction,
                         float distance) {
    const LightAt light{&world, &tables};
    if (world.air_light == AirLight::nodes) {
        return airlight::habitat_scattering_by_nodes<float, airlight::DefaultScene>(
            world.air, world.lights, eye, direction, distance, light);
    }
    if (world.air_light == AirLight::marched) {
        return airlight::habitat_scattering_marched<float, airlight::DefaultScene>(
            world.air, world.lights, eye, direction, distance, march_steps, light);
    }
    vec3 sum(0);
    for (int i = 0; i < 6; ++i) {
        sum += airlight::strip_scattering<float, airlight::DefaultScene>(
            world.air, airlight::habitat_strip(world.air, world.lights, i), eye, direction, distance, 1);
    }
    return world.bounces > 0 ? sum + airlight::habitat_scattering_by_nodes<float, airlight::DefaultScene>(
                                         world.air, world.lights, eye, direction, distance, light)
                             : sum;
}

}  // namespace deferred::habitat
