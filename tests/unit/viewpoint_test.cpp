#include <cmath>
#include <cstdio>
#include <limits>

#include <doctest/doctest.h>
#include <airlight/viewpoint.hpp>

#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"

using namespace airlight_test;
using airlight::vec3;
using airlight::Viewpoint;
using airlight::viewpoint_from_centre;
using airlight::viewpoint_from_surface;

namespace {

template <typename T>
long double length_of(const vec3<T>& v) {
    const long double x = v.x;
    const long double y = v.y;
    const long double z = v.z;
    return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

TEST_SUITE_BEGIN("viewpoint");

TEST_CASE_TEMPLATE("an eye 2 m above the origin stands 2 m up, and the vertical is that of the origin", T,
                   float, double, long double) {
    const vec3<T> north = vec3<T>(T(0), T(0), T(1));
    const Viewpoint<T> eye = viewpoint_from_surface(T(6371000), vec3<T>(T(0), T(0), T(2)), north);
    // w, square root and quotient round: 2 m to within 4 ulp.
    CHECK_WITHIN(compare_ulp("viewpoint_from_surface.altitude", {{"height", 2}}, eye.altitude, 2.0L), 4.0L);
    CHECK(eye.up.x == T(0));  // exact: zeros
    CHECK(eye.up.y == T(0));
    CHECK_WITHIN(compare_ulp("viewpoint_from_surface.up.z", {{"height", 2}}, eye.up.z, 1.0L), 4.0L);
}

TEST_CASE_TEMPLATE("3000 km east and 4000 km north of the centre is 5000 km from it", T, float, double,
                   long double) {
    const Viewpoint<T> eye = viewpoint_from_centre(T(4096), vec3<T>(T(3000), T(0), T(4000)));
    CHECK(eye.altitude == T(904));                                                      // exact: integers
    CHECK_WITHIN(compare_ulp("viewpoint_from_centre.up.x", {}, eye.up.x, 0.6L), 1.0L);  // one quotient
    CHECK_WITHIN(compare_ulp("viewpoint_from_centre.up.z", {}, eye.up.z, 0.8L), 1.0L);
}

TEST_CASE_TEMPLATE("a walk of one degree drops below the tangent plane by 970 m", T, float, double,
                   long double) {
    const T radius = T(6371000);
    const vec3<T> up = vec3<T>(T(0), T(1), T(0));
    // A point of the ground sphere one degree away has altitude 0; the position is rounded, and so is the
    // answer.
    const T sine = T(0.0174524064372835128194189785163161925L);
    const T one_minus_cosine = T(0.0001523048436087608429884411860851483L);
    const vec3<T> position = vec3<T>(radius * sine, -radius * one_minus_cosine, T(0));
    const Viewpoint<T> eye = viewpoint_from_surface(radius, position, up);
    const long double walked = length_of(position);
    // 4 roundoffs of |p| + |p|^2 / 2R, the docstring's bound, and 3 for the rounded components of the
    // position.
    const long double bound = 7 * unit_roundoff<T>() * (walked + walked * walked / (2 * 6371000.0L));
    CHECK(std::fabs(static_cast<long double>(eye.altitude)) <= bound);
    CHECK(std::fabs(static_cast<long double>(eye.up.x) - 0.0174524L) <=
          5e-8L);  // half a unit of the last digit
}

TEST_CASE_TEMPLATE("up is a unit vector wherever the eye is, and points away from the centre", T, float,
                   double, long double) {
    Random random(71);
    Worst centre;
    Worst surface;
    for (int i = 0; i < 20000; ++i) {
        const T radius = T(random.log_uniform(100.0, 7e7));
        const vec3<T> towards = random.direction<T>();
        const T size = radius * T(random.log_uniform(1e-6, 1e5));
        const Viewpoint<T> a = viewpoint_from_centre(radius, towards * size);
        centre.add(compare_roundoffs(
            "viewpoint_from_centre.up",
            {{"radius", radius}, {"x", towards.x * size}, {"y", towards.y * size}, {"z", towards.z * size}},
            T(length_of(a.up)), 1.0L, 1.0L));
        CHECK_UNARY(glm::dot(a.up, towards) > T(0));
        // From a point on the ground: above it, below it, deep in the planet.
        const vec3<T> origin_up = vec3<T>(T(0), T(1), T(0));
        const Viewpoint<T> b = viewpoint_from_surface(radius, towards * size, origin_up);
        surface.add(compare_roundoffs(
            "viewpoint_from_surface.up",
            {{"radius", radius}, {"x", towards.x * size}, {"y", towards.y * size}, {"z", towards.z * size}},
            T(length_of(b.up)), 1.0L, 1.0L));
    }
    centre.print("length of up");
    surface.print("length of up");
    CHECK_WORST(centre,
                4.0L);  // square root of a sum of squares, quotient: the docstring's 3 and the length's own
    CHECK_WORST(surface, 5.0L);  // the docstring's 4 and the length's own
}

TEST_CASE_TEMPLATE("both origins tell the same about the same eye", T, float, double, long double) {
    Random random(72);
    const T radius = T(6371000);
    const vec3<T> up = vec3<T>(T(0), T(0), T(1));
    for (int i = 0; i < 2000; ++i) {
        const T size = T(random.log_uniform(1.0, 1e8));
        const vec3<T> direction = random.direction<T>();
        const vec3<T> position =
            vec3<T>(direction.x * size, direction.y * size, glm::abs(direction.z) * size);
        const Viewpoint<T> near = viewpoint_from_surface(radius, position, up);
        const vec3<T> from_centre = vec3<T>(position.x, position.y, position.z + radius);
        const Viewpoint<T> far = viewpoint_from_centre(radius, from_centre);
        const long double distance = length_of(from_centre);
        // The centre's origin rounds the position itself (1) and the distance (2), the other adds its own 4.
        CHECK_WITHIN(compare_roundoffs("viewpoint_from_surface.altitude",
                                       {{"x", position.x}, {"y", position.y}, {"z", position.z}},
                                       near.altitude, far.altitude, distance),
                     7.0L);
        CHECK(length_of(near.up - far.up) <= 7 * unit_roundoff<T>() * 3);
    }
}

TEST_CASE("in float, eyes within 100 km of the origin know their height to centimetres") {
    Random random(73);
    const long double R = 6371000.0L;
    double worst_near = 0.0;
    double worst_far = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const float radius = 6371000.0f;
        const double size = random.log_uniform(1.0, 1e5);
        const double phi = random.uniform(0.0, 6.283185307179586);
        const float height = static_cast<float>(random.log_uniform(0.1, 1e4));
        const vec3<float> position = vec3<float>(static_cast<float>(size * std::cos(phi)),
                                                 static_cast<float>(size * std::sin(phi)), height);
        const float got = viewpoint_from_surface(radius, position, vec3<float>(0.0f, 0.0f, 1.0f)).altitude;
        const long double x = position.x;
        const long double y = position.y;
        const long double z = position.z;
        const long double w = x * x + y * y + z * z + 2 * R * z;
        const long double exact = w / (R + std::sqrt(R * R + w));
        const double error = static_cast<double>(std::fabs(static_cast<long double>(got) - exact));
        (size < 1e4 && height < 100.0f ? worst_near : worst_far) =
            std::fmax(size < 1e4 && height < 100.0f ? worst_near : worst_far, error);
        // 4 roundoffs of the height and of the drop below the tangent plane.
        CHECK(error <= static_cast<double>(4 * unit_roundoff<float>() * (z + (x * x + y * y) / (2 * R)) * 2));
    }
    std::printf(
        "viewpoint_from_surface<float>: altitude within %.2g m below 100 m and 10 km out, %.2g m up to 10 km "
        "and 100 km out\n",
        worst_near, worst_far);
    CHECK(worst_near < 0.01);
    CHECK(worst_far < 0.01);
}

TEST_CASE_TEMPLATE("viewpoints scale exactly with the unit of length", T, float, double, long double) {
    const T k = 1024;  // exact: a power of two
    Random random(74);
    for (int i = 0; i < 5000; ++i) {
        const T radius = T(random.log_uniform(100.0, 7e7));
        const vec3<T> up = random.direction<T>();
        const vec3<T> position = random.direction<T>() * T(random.log_uniform(0.1, 1e9));
        const Viewpoint<T> a = viewpoint_from_centre(radius, position);
        const Viewpoint<T> b = viewpoint_from_centre(k * radius, position * k);
        CHECK_UNARY(b.altitude == k * a.altitude);
        CHECK_UNARY(b.up == a.up);
        const Viewpoint<T> c = viewpoint_from_surface(radius, position, up);
        const Viewpoint<T> d = viewpoint_from_surface(k * radius, position * k, up);
        CHECK_UNARY(d.altitude == k * c.altitude);
        CHECK_UNARY(d.up == c.up);
    }
}

TEST_CASE_TEMPLATE("viewpoints agree with 50 digits", T, float, double, long double) {
    Worst altitude[2];
    Worst up[2];
    for (const Row& row : reference("viewpoint")) {
        const T radius = row.input<T>("radius");
        const vec3<T> p = vec3<T>(row.input<T>("px"), row.input<T>("py"), row.input<T>("pz"));
        const bool from_surface = row.text("function") == "from_surface";
        const Viewpoint<T> got = from_surface ? viewpoint_from_surface(radius, p, vec3<T>(T(0), T(0), T(1)))
                                              : viewpoint_from_centre(radius, p);
        const char* name =
            from_surface ? "viewpoint_from_surface.altitude" : "viewpoint_from_centre.altitude";
        altitude[from_surface ? 1 : 0].add(
            compare_roundoffs(name, {{"radius", radius}, {"px", p.x}, {"py", p.y}, {"pz", p.z}}, got.altitude,
                              row.expected("altitude"), row.expected("condition")));
        const long double expected_up[] = {row.expected("up_x"), row.expected("up_y"), row.expected("up_z")};
        for (int i = 0; i < 3; ++i) {
            up[from_surface ? 1 : 0].add(
                compare_roundoffs(from_surface ? "viewpoint_from_surface.up" : "viewpoint_from_centre.up",
                                  {{"radius", radius}, {"px", p.x}, {"py", p.y}, {"pz", p.z}}, got.up[i],
                                  expected_up[i], 1.0L));
        }
    }
    for (int i = 0; i < 2; ++i) {
        altitude[i].print("against 50 digits");
        up[i].print("against 50 digits");
    }
    CHECK_WORST(altitude[0], 2.0L + table_rounding<T>());  // the docstrings' bounds
    CHECK_WORST(altitude[1], 4.0L + table_rounding<T>());
    CHECK_WORST(up[0], 3.0L + table_rounding<T>());
    CHECK_WORST(up[1], 4.0L + table_rounding<T>());
}

TEST_CASE_TEMPLATE("below the ground the altitude is negative; at the centre up is still a unit vector", T,
                   float, double, long double) {
    const vec3<T> north = vec3<T>(T(0), T(0), T(1));
    CHECK(viewpoint_from_centre(T(6371), vec3<T>(T(0), T(6000), T(0))).altitude ==
          T(-371));  // exact: integers
    CHECK(viewpoint_from_surface(T(6371), vec3<T>(T(0), T(0), T(-1)), north).altitude < T(0));
    const Viewpoint<T> centre = viewpoint_from_centre(T(6371), vec3<T>(T(0)));
    CHECK(centre.altitude == T(-6371));
    CHECK(centre.up == north);  // as the docstring promises
    const Viewpoint<T> same = viewpoint_from_surface(T(6371), vec3<T>(T(0), T(0), T(-6371)), north);
    CHECK(same.altitude == T(-6371));
    CHECK(same.up == north);
}

TEST_CASE_TEMPLATE("near the planet's centre up is still a unit vector", T, float, double, long double) {
    Random random(75);
    Worst worst;
    for (int i = 0; i < 5000; ++i) {
        const T radius = T(6371000);
        const vec3<T> offset = random.direction<T>() * T(random.log_uniform(1e-3, 1e5));
        const vec3<T> position = vec3<T>(offset.x, offset.y, offset.z - radius);
        const Viewpoint<T> eye = viewpoint_from_surface(radius, position, vec3<T>(T(0), T(0), T(1)));
        CHECK_UNARY(std::isfinite(eye.altitude));
        worst.add(compare_roundoffs("viewpoint_from_surface.up",
                                    {{"x", position.x}, {"y", position.y}, {"z", position.z}},
                                    T(length_of(eye.up)), 1.0L, 1.0L));
    }
    worst.print("length of up near the centre");
    CHECK_WORST(worst, 5.0L);  // the docstring's 4 and the length's own
}

TEST_SUITE_END();
