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

TEST_CASE("the checks see NaN and infinity where a compiler assumes that there are none") {
    const std::uint32_t float_bits[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u};
    const std::uint64_t double_bits[] = {0x7FF8000000000000u, 0x7FF0000000000000u, 0xFFF0000000000000u};
    for (int i = 0; i < 3; ++i) {
        float narrow = 0;
        double wide = 0;
        std::memcpy(&narrow, &float_bits[i], sizeof narrow);
        std::memcpy(&wide, &double_bits[i], sizeof wide);
        CHECK_FALSE(is_finite(narrow));
        CHECK_FALSE(is_finite(wide));
        CHECK_FALSE(is_finite(static_cast<long double>(wide)));
        CHECK_FALSE(is_share(narrow));
    }
    CHECK(is_finite(std::numeric_limits<float>::max()));
    CHECK(is_finite(std::numeric_limits<long double>::max()));
}

TEST_SUITE_END();
