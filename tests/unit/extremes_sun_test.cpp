// The sun's disc and what hides it, at and between the ends of every parameter.

#include <doctest/doctest.h>

#include "samplers.hpp"
#include "sun_promises.hpp"

using namespace airlight_test;

TEST_SUITE_BEGIN("extremes_sun");

TEST_CASE_TEMPLATE("the sun's disc and its eclipses keep their promises", T, float, double, long double) {
    Random random(441);
    Verdict all;
    for (int i = 0; i < 60000; ++i) {
        check_any_sun<T>(all, random);
    }
    all.print((std::string("the sun, ") + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

TEST_SUITE_END();
