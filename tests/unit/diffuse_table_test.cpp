#include <cmath>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/diffuse_table.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("diffuse_table");

TEST_CASE_TEMPLATE("every texel's centre comes back", T, float, double) {
    for (const Atmosphere<T>& air : {earth<T>(), mars<T>(), rescaled(earth<T>(), T(0.001L))}) {
        const int width = 64;
        const int height = 16;
        for (int j = 0; j < height; ++j) {
            for (int i = 0; i < width; ++i) {
                const vec2<T> uv((T(i) + T(0.5)) / T(width), (T(j) + T(0.5)) / T(height));
                const AltitudeCosine<T> at = diffuse_table_parameters(air, uv, width, height);
                const vec2<T> back = diffuse_table_uv(air, at.altitude, at.mu, width, height);
                // In texels; a root and a quotient each way, of numbers up to the size.
                const T close = T(64) * T(width) * std::numeric_limits<T>::epsilon();
                CHECK(std::fabs(back.x * T(width) - T(i) - T(0.5)) <= close);
                CHECK(std::fabs(back.y * T(height) - T(j) - T(0.5)) <= close);
            }
        }
    }
}

TEST_CASE_TEMPLATE("the table's ends are the ground and the top, the sun at the nadir and at the zenith", T,
                   float, double) {
    const Atmosphere<T> air = earth<T>();
    const AltitudeCosine<T> low = diffuse_table_parameters(air, vec2<T>(T(0)), 64, 16);
    const AltitudeCosine<T> high = diffuse_table_parameters(air, vec2<T>(T(1)), 64, 16);
    CHECK(low.altitude == T(0));
    CHECK(low.mu == T(-1));
    CHECK(high.altitude == air.top_altitude);
    CHECK(high.mu == T(1));
}

TEST_CASE("half of the table lies within a few degrees of sunset") {
    const Atmosphere<double> air = earth<double>();
    const double at_dusk = diffuse_table_parameters(air, vec2<double>(0.25, 0.5), 64, 16).mu;
    const double at_dawn = diffuse_table_parameters(air, vec2<double>(0.75, 0.5), 64, 16).mu;
    // c / (1 + 2 c) = 0.115, half a texel's shift aside: 6.6 degrees.
    CHECK(at_dawn == doctest::Approx(0.115).epsilon(0.05));
    CHECK(at_dusk == doctest::Approx(-0.115).epsilon(0.05));
}

TEST_CASE_TEMPLATE("light comes out of its texels as it went in, at noon and deep in twilight", T, float,
                   double) {
    Random random(91);
    for (int i = 0; i < 2000; ++i) {
        const T scale = T(random.log_uniform(1e-20, 1.0));
        const auto any = [&](double low) {
            return scale * vec3<T>(T(low + random.unit()), T(low + random.unit()), T(low + random.unit()));
        };
        const DiffuseLight<T> light{any(0.1), any(-0.5), any(-0.5), any(-0.5), any(0),
                                    any(0),   any(0),    any(0),    any(0)};
        const DiffuseLight<T> back = unpacked_diffuse_light(packed_diffuse_light(light));
        // exp(log x): a rounding of the logarithm of up to 46, in units of the mean, and the ratio's own.
        const T close = T(100) * std::numeric_limits<T>::epsilon() * scale;
        for (int c = 0; c < 3; ++c) {
            CHECK(std::fabs(back.mean[c] - light.mean[c]) <= close * T(1.1L));
            CHECK(std::fabs(back.vertical[c] - light.vertical[c]) <= close);
            CHECK(std::fabs(back.slanted[c] - light.slanted[c]) <= close);
            CHECK(std::fabs(back.across[c] - light.across[c]) <= close);
            CHECK(std::fabs(back.aerosol_up[c] - light.aerosol_up[c]) <= close);
            CHECK(std::fabs(back.aerosol_down[c] - light.aerosol_down[c]) <= close);
            CHECK(std::fabs(back.aerosol_sunward[c] - light.aerosol_sunward[c]) <= close);
            CHECK(std::fabs(back.aerosol_away[c] - light.aerosol_away[c]) <= close);
            CHECK(std::fabs(back.aerosol_aside[c] - light.aerosol_aside[c]) <= close);
        }
        const SkyIrradiance<T> sky{any(0.1), any(0.1), any(-0.5)};
        const SkyIrradiance<T> sky_back = unpacked_sky_irradiance(packed_sky_irradiance(sky));
        for (int c = 0; c < 3; ++c) {
            CHECK(std::fabs(sky_back.down[c] - sky.down[c]) <= close * T(1.1L));
            CHECK(std::fabs(sky_back.up[c] - sky.up[c]) <= close * T(1.1L));
            CHECK(std::fabs(sky_back.sunward[c] - sky.sunward[c]) <= close);
        }
    }
}

TEST_CASE_TEMPLATE("darkness is packed without an infinity and stays dark", T, float, double) {
    const DiffuseTexels<T> texels = packed_diffuse_light(even_light(vec3<T>(T(0))));
    CHECK(std::isfinite(static_cast<double>(texels.mean.x)));
    CHECK(std::fabs(texels.mean.x) < T(65504));  // the largest half
    CHECK(unpacked_diffuse_light(texels).mean.x <= T(1.01L) * diffuse_table_dark<T>);
    CHECK(unpacked_diffuse_light(texels).aerosol_up.x == T(0));
}

TEST_SUITE_END();
