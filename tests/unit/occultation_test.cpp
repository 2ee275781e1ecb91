#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/occultation.hpp>
#include <airlight/single_scattering.hpp>

#include "promises.hpp"
#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

constexpr long double fit_error = 1.5e-9L;  // docstring of segment_over_chord

template <typename T>
T share(T gap, T curvature) {
    return visible_share(Occultation<T>{gap, curvature});
}

template <typename T>
T light(T gap, T curvature, T exponent) {
    return visible_share_of_light(Occultation<T>{gap, curvature}, exponent);
}

/// What rounding and the fit may do to a share.
template <typename T>
long double slack() {
    return 2 * fit_error + 16 * unit_roundoff<T>();
}

}  // namespace

TEST_SUITE_BEGIN("occultation");

TEST_CASE_TEMPLATE("a straight edge through the centre leaves half a disc", T, float, double, long double) {
    // Half a circle is an end of the fit, so only rounding counts.
    CHECK_WITHIN(compare_ulp("visible_share", {{"gap", 0}, {"curvature", 0}}, share(T(0), T(0)), 0.5L), 2.0L);
    // Half a radius over the edge: 2/3 + sqrt(3) / (4 pi) = 0.80450, by hand.
    CHECK_WITHIN(compare_relative("visible_share", {{"gap", 0.5L}, {"curvature", 0}}, share(T(0.5), T(0)),
                                  0.804498890521L),
                 1e-11L + slack<T>());  // the digits written here
}

TEST_CASE_TEMPLATE("equal discs a radius apart share 39.1 % of their area", T, float, double, long double) {
    // 2/3 - sqrt(3) / (2 pi) = 0.391002; the edge of one passes through the centre of the other.
    CHECK_WITHIN(compare_relative("visible_share", {{"gap", 0}, {"curvature", 1}}, share(T(0), T(1)),
                                  1 - 0.391002218956L),
                 1e-11L + slack<T>());  // the digits written here
}

TEST_CASE_TEMPLATE("a disc of half the width wholly in front leaves a ring of three quarters", T, float,
                   double, long double) {
    for (const T gap : {T(-0.5), T(-0.25), T(0)}) {
        CHECK(share(gap, T(2)) == T(0.75));  // exact: 1 - 1/4 in powers of two
    }
}

TEST_CASE_TEMPLATE("without overlap all is seen, behind a larger disc nothing", T, float, double,
                   long double) {
    const T exponents[] = {T(0), T(0.397L), T(0.652L), T(2)};
    for (const T curvature : {T(0), T(1e-6L), T(0.5), T(1)}) {
        CHECK(share(T(1), curvature) == T(1));  // exact, as all here: decided before anything is rounded
        CHECK(share(T(200), curvature) == T(1));
        CHECK(share(T(-1), curvature) == T(0));
        for (const T exponent : exponents) {
            CHECK(light(T(1), curvature, exponent) == T(1));
            CHECK(light(T(-1), curvature, exponent) == T(0));
        }
    }
    CHECK(share(T(-1), T(0)) == T(0));
    CHECK(share(T(-1e6L), T(0)) == T(0));
}

TEST_CASE_TEMPLATE("two discs hide the same area of each other", T, float, double, long double) {
    Random random(311);
    for (int i = 0; i < 20000; ++i) {
        const T curvature = T(random.log_uniform(0.25, 4));
        const T other = 1 / curvature;
        const T gap = T(random.uniform(-1, 1));
        const T its_gap = 1 + curvature * (gap - 1);
        if (its_gap <= -other) {
            continue;  // the centres would be less than nothing apart
        }
        const long double mine = 1 - static_cast<long double>(share(gap, curvature));
        const long double its = (1 - static_cast<long double>(share(its_gap, other))) * other * other;
        // Rounding its_gap moves the edge by a few roundoffs of the larger radius.
        CHECK(std::fabs(mine - its) <= (1 + other * other) * (slack<T>() + 8 * unit_roundoff<T>()));
    }
}

TEST_CASE_TEMPLATE("more overlap never shows more, and no step is larger than its chord", T, float, double,
                   long double) {
    for (const T curvature : {T(0), T(0.01L), T(0.5), T(0.97L), T(1), T(1.03L), T(2), T(30)}) {
        for (const T exponent : {T(-1), T(0), T(0.397L), T(0.652L)}) {
            const auto seen = [&](T gap) {
                return exponent < T(0) ? share(gap, curvature) : light(gap, curvature, exponent);
            };
            T before = seen(T(1.01L));
            const int count = 4000;
            for (int i = 0; i <= count; ++i) {
                const T gap = T(1.01L) - T(2.02L) * T(i) / T(count);
                if (curvature * gap <= T(-1)) {
                    break;
                }
                const T now = seen(gap);
                CAPTURE(exact(static_cast<long double>(gap)));
                CAPTURE(exact(static_cast<long double>(curvature)));
                CHECK(static_cast<long double>(now - before) <= slack<T>());
                // A disc uncovers at most its diameter: 2 / pi of its area per radius, times 1 + a / 2 where
                // its middle is brighter, and a half more for the light's eight even discs, of which one may
                // lie there.
                const T step = T(2.02L) / T(count);
                CHECK(static_cast<long double>(before - now) <= 2 * step + slack<T>());
                before = now;
            }
        }
    }
}

TEST_CASE_TEMPLATE("segments and shares agree with 50 digits", T, float, double, long double) {
    Worst segments;
    Worst shares;
    Worst lights;
    for (const Row& row : reference("occultation")) {
        const T a = row.input<T>("a");
        const T b = row.input<T>("b");
        const T c = row.input<T>("c");
        const long double expected = row.expected("expected");
        if (row.text("function") == "segment") {
            segments.add(compare_relative("segment_over_chord", {{"chord_distance", a}},
                                          segment_over_chord(a), expected));
        } else if (row.text("function") == "share") {
            // The fit's share of the whole, in the unit of rounding.
            const long double condition = row.expected("condition") + fit_error / unit_roundoff<T>() / 8.0L;
            shares.add(compare_roundoffs("visible_share", {{"gap", a}, {"curvature", b}}, share(a, b),
                                         expected, condition));
        } else {
            REQUIRE(row.text("function") == "light");
            Comparison compared = compare_relative("visible_share_of_light",
                                                   {{"gap", a}, {"curvature", b}, {"limb_exponent", c}},
                                                   light(a, b, c), expected);
            compared.error *= std::fabs(expected);  // of the disc's light
            lights.add(compared);
        }
    }
    segments.print("against 50 digits");
    shares.print("against 50 digits, the fit counted as rounding");
    lights.print("against rings of light");
    CHECK_WORST(segments, fit_error + 8 * unit_roundoff<T>());  // the docstring's
    CHECK_WORST(shares, 8.0L + table_rounding<T>());            // the docstring's
    CHECK_WORST(lights, 0.0025L);                               // the docstring's
}

TEST_CASE_TEMPLATE("light of exponent 0 is the area, and a darker rim is missed less", T, float, double,
                   long double) {
    for (const T gap : {T(-0.7L), T(0), T(0.4L), T(0.9L)}) {
        CHECK_WITHIN(compare_ulp("visible_share_of_light", {{"gap", gap}}, light(gap, T(0.9L), T(0)),
                                 static_cast<long double>(share(gap, T(0.9L)))),
                     8.0L);  // sums of eight terms, twice
    }
    CHECK(light(T(0.5), T(1), T(0.652L)) > light(T(0.5), T(1), T(0.397L)));
    CHECK(light(T(0.5), T(1), T(0.397L)) > share(T(0.5), T(1)));
}

TEST_CASE_TEMPLATE("the sun's centre on the horizon is half a sun, from any altitude", T, float, double,
                   long double) {
    const T radius = 6360;  // km
    const T sun = T(0.00465L);
    CHECK(occultation_by_ground(radius, T(0), T(0), sun).gap == T(0));  // exact
    CHECK(occultation_by_ground(radius, T(0), T(0), sun).curvature == T(0));
    for (const T altitude : {T(0.002L), T(1), T(10), T(400), T(6360), T(1e5L)}) {
        // The horizon lies below level by an angle whose cosine is R / (R + h).
        const T dip = -std::sqrt(altitude * (2 * radius + altitude)) / (radius + altitude);
        const Occultation<T> ground = occultation_by_ground(radius, altitude, dip, sun);
        // Roundings of the dip, which its sine, R / (R + h), divides; in radii of the sun.
        CHECK(std::fabs(ground.gap) <= 8 * unit_roundoff<T>() * (radius + altitude) / radius / sun);
        const T up = occultation_by_ground(radius, altitude, std::fmin(dip + T(0.01L), T(1)), sun).gap;
        CHECK(up > ground.gap);
    }
    // 30 000 km out the planet's edge is bent: its radius there is 10.0 degrees, the sun's 0.27.
    const Occultation<T> far = occultation_by_ground(radius, T(30000), T(-0.984L), sun);
    CHECK_WITHIN(compare_relative("occultation_by_ground.curvature", {}, far.curvature, 0.0261L),
                 0.01L);  // 0.00465 / tan(10.08 degrees), by hand
}

TEST_CASE_TEMPLATE("on the ground the nadir is dark and the zenith bright, to the last quarter turn", T,
                   float, double, long double) {
    const T radius = T(6.36e6L);
    const vec3<T> up(T(0), T(0), T(1));
    // Exact, all of them: the quarter turns between the edge and both poles have a cosine of 0.
    for (const T altitude : {T(-5), T(0)}) {
        for (const T sun : {T(0.00465L), T(0)}) {
            const Occultation<T> nadir = occultation_by_ground(radius, altitude, T(-1), sun);
            CHECK(nadir.gap <= T(-1));
            CHECK(visible_share(nadir) == T(0));
            const Occultation<T> zenith = occultation_by_ground(radius, altitude, T(1), sun);
            CHECK(zenith.gap >= T(1));
            CHECK(visible_share(zenith) == T(1));
            const Viewpoint<T> eye = {altitude, up};
            CHECK(PastGround<T>{radius, eye, -up, sun, T(0.5)}(vec3<T>(T(0))) == T(0));
            CHECK(PastGround<T>{radius, eye, up, sun, T(0.5)}(vec3<T>(T(0))) == T(1));
        }
    }
    // A sphere of no size hides nothing, wherever it is.
    CHECK(visible_share(occultation_of_disc(T(1), T(0), T(1), T(0), T(0.00465L))) == T(1));
    CHECK(visible_share(occultation_of_disc(T(-1), T(0), T(1), T(0), T(0.00465L))) == T(1));
}

TEST_CASE_TEMPLATE("the sun's centre is hidden where behind_planet says so", T, float, double) {
    Random random(312);
    int hidden = 0;
    for (int i = 0; i < 20000; ++i) {
        const T altitude = T(random.log_uniform(1e-3, 1e5));
        const T mu = T(random.uniform(-1, 0.1));
        const Occultation<T> ground = occultation_by_ground(T(6360), altitude, mu, T(0.00465L));
        if (std::fabs(ground.gap) * T(0.00465L) < 8 * std::numeric_limits<T>::epsilon()) {
            continue;  // on the edge both may be right
        }
        const bool behind = behind_planet(T(6360), altitude, mu);
        CHECK((ground.gap < T(0)) == behind);
        hidden += behind ? 1 : 0;
    }
    CHECK(hidden > 1000);
}

TEST_CASE_TEMPLATE("the Moon covers the Sun when it is near, and leaves a ring when it is far", T, float,
                   double, long double) {
    const vec3<T> to_sun(T(0), T(0), T(1));
    const T moon = T(1737.4L);
    const T sun = T(0.00465L);
    const auto seen = [&](T distance) {
        return visible_share(occultation_by_sphere(vec3<T>(T(0), T(0), distance), moon, to_sun, sun));
    };
    CHECK(seen(T(356500)) == T(0));
    // 1 - (1737.4 / 406700 / 0.00465)^2 = 0.1560
    CHECK_WITHIN(compare_relative("visible_share", {{"distance", 406700}}, seen(T(406700)), 0.1560L),
                 5e-4L);  // half a unit of the digits written here, and the planes' sin^2
    // Two radii beside it, in front of it in the other half of the sky, and without size: all is seen.
    const vec3<T> beside(T(2 * 0.00465L * 4e5L), T(0), T(4e5L));
    CHECK(visible_share(occultation_by_sphere(beside, moon, to_sun, sun)) == T(1));
    CHECK(visible_share(occultation_by_sphere(vec3<T>(T(0), T(0), T(-4e5L)), moon, to_sun, sun)) == T(1));
    CHECK(visible_share(occultation_by_sphere(vec3<T>(T(0), T(0), T(4e5L)), T(0), to_sun, sun)) == T(1));
    CHECK(visible_share(occultation_by_sphere(vec3<T>(T(0)), T(0), to_sun, sun)) == T(1));
    // Inside it is dark, wherever the sun is.
    CHECK(visible_share(occultation_by_sphere(vec3<T>(T(0), T(0), T(-1)), moon, to_sun, sun)) == T(0));
    CHECK(visible_share(occultation_by_sphere(vec3<T>(T(0)), moon, to_sun, sun)) == T(0));
}

TEST_CASE_TEMPLATE("an eclipse scales exactly with the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two
    Random random(313);
    for (int i = 0; i < 1000; ++i) {
        const vec3<T> to_sun = random.direction<T>();
        const vec3<T> centre = (to_sun + T(0.01L) * random.direction<T>()) * T(random.log_uniform(1, 1e6));
        const T radius = T(0.01L) * T(random.log_uniform(1, 1e6));
        CHECK(sunlight_past_sphere(k * centre, k * radius, to_sun, T(0.00465L), T(0.5)) ==
              sunlight_past_sphere(centre, radius, to_sun, T(0.00465L), T(0.5)));
        CHECK(occultation_by_ground(k * T(6360), k * radius, T(-0.1L), T(0.00465L)).gap ==
              occultation_by_ground(T(6360), radius, T(-0.1L), T(0.00465L)).gap);
    }
}

TEST_CASE_TEMPLATE("every share is one, whatever the sizes", T, float, double, long double) {
    Random random(314);
    const T ends[] = {T(0),
                      T(1e-30L),
                      T(1e-6L),
                      T(1),
                      T(1) + std::numeric_limits<T>::epsilon(),
                      T(1) - std::numeric_limits<T>::epsilon(),
                      T(1e6L),
                      T(1e30L)};
    for (int i = 0; i < 50000; ++i) {
        const T curvature = i % 2 == 0 ? ends[random.below(8)] : T(random.log_uniform(1e-9, 1e9));
        const T kind = ends[random.below(8)];
        const T at_ends[] = {T(-1), T(1), T(0), 1 - 2 / curvature, -1 / curvature};
        T gap = i % 3 == 0 ? at_ends[random.below(5)] : T(random.uniform(-1.5, 1.5));
        gap = random.below(2) == 0 ? gap : gap * (T(1) - std::numeric_limits<T>::epsilon());
        if (!(std::fabs(gap) <= T(1e30L)) || curvature * gap < T(-1)) {
            continue;
        }
        CAPTURE(exact(static_cast<long double>(gap)));
        CAPTURE(exact(static_cast<long double>(curvature)));
        CHECK(is_share(share(gap, curvature)));
        CHECK(is_share(light(gap, curvature, T(random.uniform(0, 2)))));
        const T cosine = T(random.uniform(-1, 1));
        CHECK(is_share(visible_share(occultation_by_ground(T(6.36e6L), kind, cosine, T(0.00465L)))));
        CHECK(is_share(visible_share(occultation_by_ground(T(6.36e6L), -kind, cosine, T(0)))));
        const vec3<T> to_sun = random.direction<T>();
        const vec3<T> centre = kind > T(1e15L) ? to_sun : to_sun * kind;
        CHECK(is_share(sunlight_past_sphere(centre, T(random.log_uniform(1e-9, 1e9)), to_sun,
                                            T(random.unit()), T(0.5))));
    }
}

TEST_CASE_TEMPLATE("a moon's shadow darkens the air it falls on, and no other", T, float, double) {
    const Atmosphere<T> air = earth<T>();
    const Viewpoint<T> eye = {T(2), vec3<T>(T(0), T(0), T(1))};
    const vec3<T> to_sun(T(0.6L), T(0), T(0.8L));
    const vec3<T> direction(T(0), T(0.6L), T(0.8L));
    const T sun = T(0.00465L);
    const Scattered<T> lit = single_scattering(air, eye, direction, to_sun, no_surface<T>());
    const auto with_moon = [&](const vec3<T>& centre) {
        return single_scattering<T, DefaultScene>(air, eye, direction, to_sun, no_surface<T>(),
                                                  PastSphere<T>{centre, T(1737.4e3L), to_sun, sun, T(0.5)});
    };
    // Elsewhere in the sky: exact, every visibility is 1.
    const Scattered<T> beside = with_moon(direction * T(3.8e8L));
    CHECK(beside.radiance == lit.radiance);
    // Covering the sun from the eye and, 100 km up the ray, from there too.
    const Scattered<T> total = with_moon(to_sun * T(3.3e8L));
    CHECK(total.radiance.y < T(0.02L) * lit.radiance.y);
    CHECK(total.transmittance == lit.transmittance);  // exact: a shadow takes no air away
    // Half covered: the ray's light is dimmed by what its samples see, which parallax moves by 100 km / 3480
    // km.
    const vec3<T> side(T(-0.8L), T(0), T(0.6L));
    const vec3<T> half_way = to_sun * T(3.8e8L) + side * (sun * T(3.8e8L));
    const T here = sunlight_past_sphere(half_way, T(1737.4e3L), to_sun, sun, T(0.5));
    const Scattered<T> partial = with_moon(half_way);
    CHECK(here > T(0.2L));
    CHECK(here < T(0.8L));
    const T ratio = partial.radiance.y / lit.radiance.y;
    CHECK(std::fabs(ratio - here) < T(0.05L));  // the parallax, 100 km in 3480 km, and light low in the air
}

TEST_CASE_TEMPLATE("a sample's sunlight past the ground is that of its own place", T, float, double) {
    const T radius = 6360;
    const Viewpoint<T> eye = {T(400), vec3<T>(T(0), T(0), T(1))};
    const T sun = T(0.00465L);
    // At the eye, with the sun's centre on its horizon: half a sun, even or not.
    const T dip = -std::sqrt(T(400) * (2 * radius + 400)) / (radius + 400);
    const vec3<T> setting(radius / (radius + 400), T(0), dip);
    const T half = sunlight_past_ground(radius, eye, vec3<T>(T(0)), setting, sun, T(0));
    // Roundings of the dip over the sun's radius; and the horizon's bend, 0.00465 times the tangent of the
    // dip.
    CHECK(std::fabs(half - T(0.5)) < 64 * std::numeric_limits<T>::epsilon() / sun + T(0.001L));
    // Straight down on the ground the same sun has long set, and straight up it is high.
    CHECK(sunlight_past_ground(radius, eye, vec3<T>(T(0), T(0), T(-400)), setting, sun, T(0.5)) == T(0));
    CHECK(sunlight_past_ground(radius, eye, vec3<T>(T(0), T(0), T(400)), setting, sun, T(0.5)) == T(1));
}

TEST_CASE(
    "the planet's penumbra takes less than a hundredth of the air's light, and only at the terminator") {
    // Straight down from 1000 km, `way` radians before the terminator.
    const Atmosphere<double> air = earth<double>();
    const vec3<double> to_sun(1, 0, 0);
    Worst taken;
    for (const double way : {-0.1, -0.05, -0.02, 0.0, 0.02, 0.3}) {
        const vec3<double> up(std::sin(way), 0, std::cos(way));
        const Viewpoint<double> eye = {1e6, up};
        const PastGround<double> soft = {air.ground_radius, eye, to_sun, 0.00465, 0.5};
        const vec3<double> got = single_scattering_marched<double, NoShadow>(air, eye, -up, to_sun,
                                                                             no_surface<double>(), 4000, soft)
                                     .radiance;
        const vec3<double> sharp =
            single_scattering_marched(air, eye, -up, to_sun, no_surface<double>(), 4000).radiance;
        if (way > 0.01) {
            CHECK(got == sharp);  // exact: every sample sees the whole sun
        }
        for (int k = 0; k < 3; ++k) {
            CHECK(got[k] <= sharp[k] * (1 + 1e-12));  // rounding of 4000 terms
            taken.add(compare_relative("penumbra", {{"way", way}, {"channel", double(k)}}, got[k], sharp[k]));
        }
    }
    taken.print("against the sharp shadow");
    CHECK_WORST(taken, 0.01L);  // what docs/theory/sun.md says of it
}

TEST_SUITE_END();
