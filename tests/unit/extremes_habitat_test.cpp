// Habitats, their strips and lamps, at and between the ends of every parameter.

#include <doctest/doctest.h>

#include "habitat_promises.hpp"
#include "samplers.hpp"

using namespace airlight_test;

TEST_SUITE_BEGIN("extremes_habitat");

TEST_CASE_TEMPLATE("the air and the lights of any habitat keep their promises", T, float, double,
                   long double) {
    Random random(660);
    Verdict all;
    for (int i = 0; i < 20000; ++i) {
        check_any_habitat<T>(all, random);
    }
    all.print((std::string("habitats, ") + type_name<T>()).c_str());
    CHECK_MESSAGE(all.kept(), all.story());
}

TEST_SUITE_END();
