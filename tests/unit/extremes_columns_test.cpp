// Columns, optical depths and transmittances at and between the ends of every parameter.

#include <doctest/doctest.h>

#include "column_promises.hpp"
#include "converted.hpp"
#include "samplers.hpp"
#include "worlds.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

// The cosine of a ray that touches the ground, or -1 from below it.
template <typename T>
T to_horizon(T radius, T altitude) {
    const T sine = radius / (radius + altitude);
    return altitude > T(0) ? -std::sqrt((T(1) - sine) * (T(1) + sine)) : T(-1);
}

}  // namespace

TEST_SUITE_BEGIN("extremes_columns");

TEST_CASE_TEMPLATE("columns keep their promises for any air and any ray", T, float, double, long double) {
    Random random(401);
    Verdict all;
    for (int i = 0; i < 60000; ++i) {
        check_any_ray<T>(all, random);
    }
    all.print((std::string("columns, ") + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

TEST_CASE_TEMPLATE("columns keep their promises where every parameter stands at an end", T, float, double,
                   long double) {
    Verdict all;
    for (const T radius : {T(100), T(6360e3), T(7e7)}) {
        for (const T scale_height : {T(0), T(0.1L), T(8000), T(1e6)}) {
            for (const T top : {T(0), T(1e-3L), T(1e5), T(1e12)}) {
                for (const T half_width : {T(0), T(0.1L), T(1e6)}) {
                    Atmosphere<T> air = earth<T>();
                    air.ground_radius = radius;
                    air.top_altitude = top;
                    air.rayleigh_scale_height = scale_height;
                    air.mie_scale_height = T(0.15L) * scale_height;
                    air.ozone_half_width = half_width;
                    air.ozone_altitude = T(1.5L) * half_width;
                    for (const T altitude : {-radius, T(-1), T(0), T(1e-6L), scale_height, top, 2 * top}) {
                        if (altitude > 4 * (radius + top)) {
                            continue;
                        }
                        for (const T mu :
                             {T(-1), to_horizon(radius, altitude), T(-1e-30L), T(0), T(1e-3L), T(1)}) {
                            for (const T distance : {T(0), T(1e-6L), T(1000), no_surface<T>()}) {
                                check_ray(all, air, altitude, mu, distance, T(0.5L));
                            }
                        }
                    }
                }
            }
        }
    }
    all.print((std::string("columns at the ends, ") + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

TEST_CASE_TEMPLATE("1000 optical depths per scale height leave nothing, none leave all", T, float, double,
                   long double) {
    Random random(402);
    Verdict all;
    for (int i = 0; i < 5000; ++i) {
        Atmosphere<T> air = any_atmosphere<T>(random);
        air.rayleigh_scale_height = T(random.log_uniform(0.1, 1e6));
        air.top_altitude = T(20) * air.rayleigh_scale_height;
        air.rayleigh_scattering = vec3<T>(T(1e3) / air.rayleigh_scale_height);
        const T mu = cosine<T>(random);
        all.holds("no light passes a thousand depths",
                  transmittance_to_space<T>(air, T(0), std::fabs(mu)) == vec3<T>(T(0)));
        all.holds("all light passes where nothing stops it",
                  transmittance<T>(airless(air), T(0), mu, any_distance<T>(random)) == vec3<T>(T(1)));
    }
    // Straight up through 1000 depths exp(-1000) is 0 in float and double; long double still has numbers
    // there.
    CHECK_MESSAGE((all.kept() || std::numeric_limits<T>::max_exponent > 2000), all.broken());
}

TEST_CASE("float columns stay within their bound of double's, whatever the air") {
    Random random(403);
    Verdict all;
    for (int i = 0; i < 60000; ++i) {
        const Atmosphere<float> air = any_atmosphere<float>(random);
        const float altitude = any_altitude(random, air);
        const float mu = cosine<float>(random);
        const float distance = any_distance<float>(random);
        const Atmosphere<double> wide = converted<double>(air);
        const AirPath<double> path = air_path<double>(wide, altitude, mu, distance);
        const Column<float> got = column(air, altitude, mu, distance);
        const Column<double> expected = column<double>(wide, altitude, mu, distance);
        Verdict verdict;
        const double u = std::numeric_limits<float>::epsilon() / 2;
        const auto compare = [&](const char* promise, float result, double truth, double scale_height) {
            if (has_column_laws(wide, path, scale_height, u)) {
                const double density = std::exp(-lowest_altitude(path) / scale_height);
                const double bound =
                    exponential_column_bound(wide, path, scale_height, truth, u) +
                    density * touching_way(wide, path, u) +
                    std::numeric_limits<float>::min() * (1 + level_air(wide, 0.0, scale_height));
                verdict.within(promise, std::fabs(static_cast<double>(result) - truth), bound);
            }
        };
        compare("column.rayleigh", got.rayleigh, expected.rayleigh, wide.rayleigh_scale_height);
        compare("column.mie", got.mie, expected.mie, wide.mie_scale_height);
        all.add(verdict, [&] { return told_ray(air, altitude, mu, distance, 0.0f); });
    }
    all.print("float columns against double");
    CHECK_MESSAGE(all.kept(), all.story());
}

TEST_SUITE_END();
