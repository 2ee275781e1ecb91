// Phase functions, densities, coefficients and colours at and between the ends of every parameter.

#include <doctest/doctest.h>

#include "light_promises.hpp"
#include "samplers.hpp"

using namespace airlight_test;
using namespace airlight;

TEST_SUITE_BEGIN("extremes_light");

TEST_CASE_TEMPLATE("phase functions, densities and colours keep their promises", T, float, double,
                   long double) {
    Random random(431);
    Verdict all;
    for (int i = 0; i < 200000; ++i) {
        check_any_light<T>(all, random);
    }
    all.print((std::string("light, ") + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

TEST_SUITE_END();
