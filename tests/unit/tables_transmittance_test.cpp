#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/single_scattering.hpp>
#include <airlight/tables/transmittance.hpp>

#include <cmath>
#include <cstdio>

#include "half.hpp"
#include "promises.hpp"
#include "scenes.hpp"
#include "transmittance_errors.hpp"
#include "worlds.hpp"

using namespace airlight;
using namespace airlight_test;

namespace {

/// Relative errors of a table of slants as it is, in half precision, and with the weights of a GPU's filter,
/// which are multiples of 1 / 256.
struct SlantErrors {
    ErrorMetrics as_baked;
    ErrorMetrics in_half;
    ErrorMetrics coarse_weights;
};

template <typename T, typename Scene>
SlantErrors slant_errors(const char* name, const Atmosphere<T>& air, int width, int height) {
    const Table<vec2<T>> table = bake_slants<T, Scene>(air, width, height);
    Table<vec2<T>> half = table;
    for (vec2<T>& texel : half.texels) {
        texel = as_half(texel);
    }
    const auto coarse = [&](const Atmosphere<T>& atmosphere, T altitude, T mu) {
        const auto look_up = [&](const vec2<T>& uv) {
            const auto rounded = [](T u, int size) {
                return (std::nearbyint((u * T(size) - T(0.5)) * T(256)) / T(256) + T(0.5)) / T(size);
            };
            return sample(table, vec2<T>(rounded(uv.x, width), rounded(uv.y, height)));
        };
        return transmittance_from_slants<T, Scene>(atmosphere, altitude, mu, width, height, look_up);
    };
    const auto measure = [&](const char* how, const auto& to_space) {
        const ErrorMetrics m = error_metrics(transmittance_errors<T, Scene>(air, to_space, 20000));
        std::printf("slants %s %s, %d x %d, %s: max %.1e p95 %.1e median %.1e\n", name, type_name<T>(), width,
                    height, how, m.largest, m.p95, m.median);
        return m;
    };
    return SlantErrors{measure("as baked", SlantTransmittance<T, Scene>{&table}),
                       measure("half", SlantTransmittance<T, Scene>{&half}),
                       measure("weights of 1/256", coarse)};
}

}  // namespace

TEST_SUITE_BEGIN("tables_transmittance");

TEST_CASE_TEMPLATE("64 x 32 slants are off by less than 1e-3, in half precision and on coarse filters too", T,
                   float, double) {
    const auto check = [](const SlantErrors& errors, double worst, double usual) {
        // The printed errors with a fifth to spare; the goal is 1e-3.
        CHECK(errors.as_baked.largest <= worst);
        CHECK(errors.in_half.largest <= worst);
        CHECK(errors.coarse_weights.largest <= worst);
        CHECK(errors.as_baked.p95 <= usual);
        CHECK(errors.in_half.p95 <= usual);
        CHECK(errors.coarse_weights.p95 <= usual);
    };
    check(slant_errors<T, DefaultScene>("earth", earth<T>(), 64, 32), 2.5e-4, 5e-5);
    check(slant_errors<T, NoOzone>("cs562", cs562_earth<T>(), 64, 32), 2.7e-4, 4e-5);
    check(slant_errors<T, NoOzone>("elek", elek_earth<T>(), 64, 32), 1.7e-4, 3e-5);
    check(slant_errors<T, NoOzone>("mars", mars<T>(), 64, 32), 2.5e-4, 5e-5);
    check(slant_errors<T, NoOzone>("titan", titan<T>(), 64, 32), 6e-4, 3e-4);
    Atmosphere<T> low = earth<T>();
    low.top_altitude = T(60e3L);  // where 6e-4 of the molecules are still to come
    check(slant_errors<T, DefaultScene>("earth to 60 km", low, 64, 32), 2.5e-4, 9e-5);
}

TEST_CASE_TEMPLATE("a Lorentz curve is as wrong as its ramps, which the table does not replace", T, float,
                   double) {
    const SlantErrors errors = slant_errors<T, Lorentzian>("leenman", leenman_earth<T>(), 64, 32);
    CHECK(errors.as_baked.largest <= 4e-3);  // lorentzian_ramps: 4.3e-3 of the level column, printed 3.4e-3
    CHECK(errors.as_baked.largest >= 1e-3);  // not within the goal; drop this line when the ramps are better
    CHECK(errors.in_half.p95 <= 1.5e-3);
}

TEST_CASE("four times the texels, a fourth of the error, down to what the closed form leaves") {
    const auto worst = [](int width, int height) {
        return slant_errors<double, NoOzone>("elek", elek_earth<double>(), width, height).as_baked.largest;
    };
    const double coarse = worst(16, 8);
    const double middle = worst(32, 16);
    CHECK(coarse / middle >= 3);  // linear filtering is of second order: 4 in the limit
    CHECK(middle / worst(64, 32) >= 3);
}

TEST_CASE("an altitude counts for little: four rows do what 32 do") {
    const SlantErrors few = slant_errors<double, DefaultScene>("earth", earth<double>(), 64, 4);
    CHECK(few.as_baked.largest <= 2.5e-4);  // as with 32, above
}

TEST_CASE_TEMPLATE("an extinction table of 256 x 256 is right in the sky and lost at the horizon", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    const Table<vec3<T>> table = bake_extinction<T>(air);
    const ExtinctionTransmittance<T> to_space{&table};
    for (const double faintest : {1e-30, 1e-2, 1e-1}) {
        const ErrorMetrics m =
            error_metrics(transmittance_errors<T, DefaultScene>(air, to_space, 20000, faintest));
        std::printf("extinction %s, from %.0e: max %.1e p95 %.1e median %.1e\n", type_name<T>(), faintest,
                    m.largest, m.p95, m.median);
        CHECK(m.median <= 2e-5);  // printed: 1.2e-5
        CHECK(m.largest >= 0.1);  // why slants are the default
    }
    // Behind the planet 0, but for the texel that the edge runs through.
    CHECK(to_space(air, T(0), T(-0.02L)) == vec3<T>(T(0)));
    CHECK(to_space(air, T(100), T(-1)) == vec3<T>(T(0)));
    CHECK(to_space(air, T(1e9L), T(1)).x > T(0.999L));  // above the air as at its top
}

TEST_CASE_TEMPLATE("at its own texels an extinction table returns what passes to space from there", T, float,
                   double) {
    const Atmosphere<T> air = earth<T>();
    const Table<vec3<T>> table = bake_extinction<T>(air, 16, 33);
    const ExtinctionTransmittance<T> to_space{&table};
    int dark = 0;
    for (int j = 0; j < table.height; ++j) {
        for (int i = 0; i < table.width; ++i) {
            const vec3<T> centre = texel_centre<T>(table, i, j);
            const AltitudeCosine<T> at =
                extinction_parameters(air, vec2<T>(centre.x, centre.y), table.width, table.height);
            const vec3<T> expected = transmittance_to_space<T>(air, at.altitude, at.mu);
            const vec3<T> got = to_space(air, at.altitude, at.mu);
            for (int k = 0; k < 3; ++k) {
                // There and back a coordinate is off by 4 roundoffs of the size each way, and as much of a
                // neighbour, which is 1 at most, is mixed in along each axis.
                CHECK(std::fabs(got[k] - expected[k]) <=
                      T(2 * 8 * 33) * std::numeric_limits<T>::epsilon() / 2);
            }
            dark += behind_planet(air.ground_radius, at.altitude, at.mu) ? 1 : 0;
        }
    }
    CHECK(dark > table.width * table.height / 4);  // of the lower half most: the horizon dips by 10 degrees
    CHECK(dark < table.width * table.height / 2);
}

TEST_CASE("a march with the extinction table sees by day what a march with the closed form sees") {
    const Atmosphere<double> air = earth<double>();
    const Table<vec3<double>> table = bake_extinction<double>(air);
    const ExtinctionTransmittance<double> look_up{&table};
    const Viewpoint<double> eye{2, vec3<double>(0, 0, 1)};
    const vec3<double> direction(0.6, 0, 0.8);
    for (const double sine : {1.0, 0.8, 0.5}) {
        const vec3<double> to_sun(0, std::sqrt((1 - sine) * (1 + sine)), sine);
        const Scattered<double> known =
            single_scattering_marched<double>(air, eye, direction, to_sun, no_surface<double>(), 32);
        const Scattered<double> looked_up = single_scattering_marched<double, DefaultScene>(
            air, eye, direction, to_sun, no_surface<double>(), 32, AlwaysLit{}, look_up);
        for (int i = 0; i < 3; ++i) {
            CHECK_WITHIN(
                compare_relative("single_scattering_marched", {{"sine", sine}, {"channel", double(i)}},
                                 looked_up.radiance[i], known.radiance[i]),
                3e-5L);  // modelling: a few times the median look-up, docs/tables.md (measured: 1.6e-5)
        }
        CHECK(looked_up.transmittance == known.transmittance);  // exact: the table is not asked for it
    }
}

TEST_CASE_TEMPLATE("a march with the table sees what a march with the closed form sees", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const Table<vec2<T>> table = bake_slants<T>(air);
    const SlantTransmittance<T> look_up{&table};
    const Viewpoint<T> eye{T(2), vec3<T>(T(0), T(0), T(1))};
    for (const double sun : {60.0, 10.0, 1.0, -2.0}) {
        const double radians = sun * 0.017453292519943295;
        const vec3<T> to_sun(T(std::cos(radians)), T(0), T(std::sin(radians)));
        const vec3<T> direction(T(0.6L), T(0), T(0.8L));
        const Scattered<T> known =
            single_scattering_marched<T>(air, eye, direction, to_sun, no_surface<T>(), 32);
        const Scattered<T> looked_up = single_scattering_marched<T, DefaultScene>(
            air, eye, direction, to_sun, no_surface<T>(), 32, AlwaysLit{}, look_up);
        for (int i = 0; i < 3; ++i) {
            CHECK(std::fabs(looked_up.radiance[i] / known.radiance[i] - 1) <= T(3e-4L));  // the table's worst
        }
    }
}

TEST_CASE_TEMPLATE("sizes of 1, worlds without air and layers of no height give shares", T, float, double) {
    Atmosphere<T> flat = earth<T>();
    flat.rayleigh_scale_height = flat.mie_scale_height = flat.ozone_half_width = T(0);
    Atmosphere<T> bare = earth<T>();
    bare.top_altitude = T(0);
    Atmosphere<T> empty = earth<T>();
    empty.rayleigh_scattering = empty.mie_scattering = empty.mie_absorption = empty.ozone_absorption =
        vec3<T>(T(0));
    for (const Atmosphere<T>& air : {earth<T>(), flat, bare, empty}) {
        for (const int size : {1, 2, 7}) {
            const Table<vec2<T>> slants = bake_slants<T>(air, size, size);
            const Table<vec3<T>> extinction = bake_extinction<T>(air, size, size);
            for (const T altitude : {T(0), T(1e3L), T(1e5L), T(-5)}) {
                for (const T mu : {T(-1), T(-1e-4L), T(0), T(0.3L), T(1)}) {
                    CHECK_UNARY(is_share(SlantTransmittance<T>{&slants}(air, altitude, mu)));
                    CHECK_UNARY(is_share(ExtinctionTransmittance<T>{&extinction}(air, altitude, mu)));
                }
            }
        }
    }
}

TEST_SUITE_END();
