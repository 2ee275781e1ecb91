#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/sky_view_table.hpp>

#include <cmath>

#include "extremes.hpp"
#include "promises.hpp"
#include "samplers.hpp"
#include "table_worlds.hpp"

using namespace airlight;
using namespace airlight_test;

TEST_SUITE_BEGIN("sky_view_table");

TEST_CASE_TEMPLATE(
    "a texel of the sky sees the sky, one of the ground the ground, down to the horizon itself", T, float,
    double) {
    int texels = 0;
    for (const TableWorld& world : table_worlds()) {
        const Atmosphere<T> air = converted<T>(world.air);
        const T metre = air.ground_radius / T(world.air.ground_radius > 1e5 ? 6.36e6 : 6.36e3);
        for (const T height : {T(0), T(2), T(1e3L), T(1e4L), T(4e5L)}) {
            const T altitude = height * metre;
            for (int j = 0; j < 108; ++j) {
                const vec2<T> uv(T(0.3L), (T(j) + T(0.5)) / T(108));
                const SkyDirection<T> seen = sky_view_parameters(air.ground_radius, altitude, uv, 192, 108);
                const SkyRay<T> ray = sky_view_ray(air, altitude, T(0.3L), seen);
                const AirRay<T> found = air_ray(air, ray.eye, ray.direction, ray.distance);
                INFO(world.name, " altitude ", double(altitude), " row ", j);
                if (!seen.reaches_ground) {
                    CHECK_UNARY(!found.reaches_ground);
                } else {
                    // On the ground, or at the horizon's distance, where it is no lower than rounding says.
                    const T end =
                        altitude_along_ray(air.ground_radius, found.altitude, found.along, found.extent);
                    CHECK(end <= T(40) * std::numeric_limits<T>::epsilon() * (air.ground_radius + altitude));
                }
                ++texels;
            }
        }
    }
    CHECK(texels == 5 * 5 * 108);
}

TEST_CASE_TEMPLATE("a texel is the light of its ray", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const SkyDirection<T> seen = {T(0.25), T(0.5), false};
    const vec3<T> texel = sky_view_texel<T>(air, T(100), T(0.4L), seen);
    const SkyRay<T> ray = sky_view_ray(air, T(100), T(0.4L), seen);
    const Scattered<T> light = single_scattering<T>(air, ray.eye, ray.direction, ray.to_sun, no_surface<T>());
    CHECK(texel == light.radiance);  // exact: the same call
    const T nearly = T(8) * std::numeric_limits<T>::epsilon();
    CHECK(std::fabs(ray.direction.z - T(0.25)) <= nearly);
    CHECK(std::fabs(ray.to_sun.z - T(0.4L)) <= nearly);
}

TEST_CASE_TEMPLATE("every atmosphere, eye, sun and texel gives an amount of light", T, float, double) {
    Random random(61);
    for (int i = 0; i < 3000; ++i) {
        const Atmosphere<T> air = any_atmosphere<T>(random);
        const T altitude = any_viewpoint<T>(random, air).altitude;
        const T mu_s = cosine<T>(random);
        const vec2<T> uv(T(random.uniform(-0.1, 1.1)), T(random.uniform(-0.1, 1.1)));
        const SkyDirection<T> seen = sky_view_parameters(air.ground_radius, altitude, uv, 64, 32);
        INFO("altitude ", double(altitude), " mu_s ", double(mu_s), " R ", double(air.ground_radius));
        CHECK_UNARY(is_amount(sky_view_texel<T>(air, altitude, mu_s, seen)));
    }
}

TEST_SUITE_END();
