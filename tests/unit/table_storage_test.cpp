#include <doctest/doctest.h>
#include <airlight/table_storage.hpp>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight_test;
using airlight::light_from_stored;
using airlight::stored_light;
using airlight::vec3;

TEST_SUITE_BEGIN("table_storage");

TEST_CASE_TEMPLATE("4 is stored as 512, black as 0, and less than black too", T, float, double, long double) {
    CHECK(stored_light(vec3<T>(T(4), T(0), T(-1))) == vec3<T>(T(512), T(0), T(0)));  // exact: powers of 2
    CHECK(light_from_stored(vec3<T>(T(512), T(0), T(128))) == vec3<T>(T(4), T(0), T(0.25L)));
}

TEST_CASE_TEMPLATE("light comes back to a few roundoffs, from starlight to the sun", T, float, double,
                   long double) {
    Random random(23);
    Worst worst;
    for (int n = 0; n < 3000; ++n) {
        const T light = T(random.log_uniform(1e-17, 65000.0));
        const vec3<T> back = light_from_stored(stored_light(vec3<T>(light, light, light)));
        worst.add(compare_ulp("light_from_stored", {{"light", light}}, back.x, light));
    }
    worst.print("of light and back");
    CHECK_WORST(worst, 4.0L);  // a root, the error of which counts twice, and a square
}

TEST_SUITE_END();
