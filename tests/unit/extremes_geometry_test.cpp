// Crossings, viewpoints and view paths at and between the ends of every parameter.

#include <doctest/doctest.h>

#include "geometry_promises.hpp"
#include "samplers.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("extremes_geometry");

TEST_CASE_TEMPLATE("rays, eyes and paths keep their promises around any planet", T, float, double,
                   long double) {
    Random random(421);
    Verdict all;
    for (int i = 0; i < 200000; ++i) {
        check_any_geometry<T>(all, random);
    }
    all.print((std::string("geometry, ") + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

TEST_SUITE_END();
