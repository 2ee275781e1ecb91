#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/constants.hpp>

#include "story.hpp"

using namespace airlight_test;

TEST_SUITE_BEGIN("constants");

TEST_CASE_TEMPLATE("pi is the number nearest to the circle's ratio", T, float, double, long double) {
    // Half an ulp is the best a rounded constant can be; the reference's own rounding is the other half.
    CHECK_WITHIN(compare_ulp("pi", {}, airlight::pi<T>, 3.14159265358979323846264338327950288L), 0.5L);
}

TEST_CASE_TEMPLATE("no surface lies beyond every distance", T, float, double, long double) {
    CHECK(airlight::no_surface<T>() > std::numeric_limits<T>::max());
}

TEST_SUITE_END();
