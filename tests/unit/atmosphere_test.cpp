#include <doctest/doctest.h>
#include <airlight/atmosphere.hpp>
#include <airlight/atmospheres.hpp>

#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

// Every member of an atmosphere with its name and the power of the unit of length it carries.
template <typename T, typename Function>
void for_each_member(const Atmosphere<T>& a, const Atmosphere<T>& b, Function function) {
    function("ground_radius", a.ground_radius, b.ground_radius, 1);
    function("top_altitude", a.top_altitude, b.top_altitude, 1);
    function("rayleigh_scale_height", a.rayleigh_scale_height, b.rayleigh_scale_height, 1);
    function("mie_scale_height", a.mie_scale_height, b.mie_scale_height, 1);
    function("mie_g", a.mie_g, b.mie_g, 0);
    function("ozone_altitude", a.ozone_altitude, b.ozone_altitude, 1);
    function("ozone_half_width", a.ozone_half_width, b.ozone_half_width, 1);
    for (int i = 0; i < 3; ++i) {
        function("rayleigh_scattering", a.rayleigh_scattering[i], b.rayleigh_scattering[i], -1);
        function("mie_scattering", a.mie_scattering[i], b.mie_scattering[i], -1);
        function("mie_absorption", a.mie_absorption[i], b.mie_absorption[i], -1);
        function("ozone_absorption", a.ozone_absorption[i], b.ozone_absorption[i], -1);
        function("ground_albedo", a.ground_albedo[i], b.ground_albedo[i], 0);
    }
}

}  // namespace

TEST_SUITE_BEGIN("atmosphere");

TEST_CASE_TEMPLATE("in kilometres lengths are a thousandth and coefficients a thousandfold", T, float, double,
                   long double) {
    const Atmosphere<T> metres = earth<T>();
    const Atmosphere<T> kilometres = rescaled(metres, T(0.001L));
    for_each_member(metres, kilometres, [](const char* name, T before, T after, int power) {
        const long double factor = power == 1 ? 0.001L : power == -1 ? 1000.0L : 1.0L;
        // 1 ulp for the operation (the docstring's bound), 1 for the rounding of 0.001 itself.
        CHECK_WITHIN(
            compare_ulp(name, {{"before", before}}, after, static_cast<long double>(before) * factor), 2.0L);
    });
}

TEST_CASE_TEMPLATE("optical depths do not change with the unit", T, float, double, long double) {
    const Atmosphere<T> metres = earth<T>();
    const Atmosphere<T> miles = rescaled(metres, T(1) / T(1609.344L));
    for (int i = 0; i < 3; ++i) {
        // Two rounded members and their product.
        CHECK_WITHIN(
            compare_ulp(
                "scattering scale_height", {}, miles.rayleigh_scattering[i] * miles.rayleigh_scale_height,
                static_cast<long double>(metres.rayleigh_scattering[i]) * metres.rayleigh_scale_height),
            4.0L);
    }
}

TEST_CASE_TEMPLATE("there and back again by a power of two is the same atmosphere", T, float, double,
                   long double) {
    const Atmosphere<T> before = mars<T>();
    const Atmosphere<T> after = rescaled(rescaled(before, T(1024)), T(1) / T(1024));
    for_each_member(before, after, [](const char* name, T x, T y, int) {
        CHECK_EQUAL(compare_ulp(name, {{"before", x}}, y, x));  // exact: only exponents change
    });
    const Atmosphere<T> scaled = rescaled(before, T(1024));
    for_each_member(before, scaled, [](const char* name, T x, T y, int power) {
        const T expected = power == 1 ? x * T(1024) : power == -1 ? x / T(1024) : x;
        CHECK_EQUAL(compare_ulp(name, {{"before", x}}, y, expected));
    });
}

TEST_CASE_TEMPLATE("there and back again by any factor is the same atmosphere to 2 ulp", T, float, double,
                   long double) {
    const Atmosphere<T> before = leenman_earth<T>();
    const Atmosphere<T> after = rescaled(rescaled(before, T(0.3048L)), T(1) / T(0.3048L));
    for_each_member(before, after, [](const char* name, T x, T y, int) {
        CHECK_WITHIN(compare_ulp(name, {{"before", x}}, y, x), 3.0L);  // two operations, and 1 / k rounded
    });
}

TEST_SUITE_END();
