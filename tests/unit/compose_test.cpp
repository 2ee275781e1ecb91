#include <doctest/doctest.h>
#include <airlight/compose.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("compose");

TEST_CASE_TEMPLATE("half of a surface of 8 and a quarter of a sun of 16 make 8", T, float, double,
                   long double) {
    const Scattered<T> air = Scattered<T>{vec3<T>(T(0.25), T(0), T(1)), vec3<T>(T(0.5), T(1), T(0))};
    // Exact: powers of two.
    CHECK(compose(vec3<T>(T(8)), air, vec3<T>(T(16))) == vec3<T>(T(8), T(8), T(16)));
}

TEST_CASE_TEMPLATE("without air the surface is seen as it is, in the dark the air is not seen", T, float,
                   double, long double) {
    const Scattered<T> nothing = Scattered<T>{vec3<T>(T(0)), vec3<T>(T(1))};
    const vec3<T> surface = vec3<T>(T(0.1L), T(0.7L), T(12));
    CHECK(compose(surface, nothing, vec3<T>(T(3))) == surface);  // exact: times 1 plus 0
    const Scattered<T> air = Scattered<T>{vec3<T>(T(0.3L)), vec3<T>(T(0.5))};
    CHECK(compose(surface, air, vec3<T>(T(0))) == surface * T(0.5));
}

TEST_CASE_TEMPLATE(
    "the sun's strength is the caller's: radiance is per unit of irradiance and composes linearly", T, float,
    double, long double) {
    // Our choice where sources multiply by 20 or 40 because it looks nice.
    Random random(131);
    for (int i = 0; i < 1000; ++i) {
        const Scattered<T> air = Scattered<T>{vec3<T>(T(random.unit()), T(random.unit()), T(random.unit())),
                                              vec3<T>(T(random.unit()))};
        const vec3<T> surface = vec3<T>(T(random.log_uniform(1e-3, 1e3)));
        const vec3<T> sun = vec3<T>(T(1.474L), T(1.8504L), T(1.91198L));
        const vec3<T> once = compose(surface, air, sun);
        // Exact: a power of two times everything that has a unit of light.
        CHECK(compose(surface * T(64), air, sun * T(64)) == once * T(64));
        for (int k = 0; k < 3; ++k) {
            const long double expected = static_cast<long double>(surface[k]) * air.transmittance[k] +
                                         static_cast<long double>(air.radiance[k]) * sun[k];
            // Two products and a sum of numbers >= 0: the docstring's 3 ulp.
            CHECK_WITHIN(compare_ulp("compose", {{"surface", surface[k]}, {"radiance", air.radiance[k]}},
                                     once[k], expected),
                         3.0L);
        }
    }
}

TEST_SUITE_END();
