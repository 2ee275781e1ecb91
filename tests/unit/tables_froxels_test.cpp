#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/tables/froxels.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

#include "error_metrics.hpp"
#include "promises.hpp"
#include "samplers.hpp"

using namespace airlight;
using namespace airlight_test;

namespace {

/// A camera 100 m up that looks along y, with the sun aside.
struct Shot {
    Atmosphere<double> air = earth<double>();
    Viewpoint<double> eye{100, vec3<double>(0, 0, 1)};
    CameraRays<double> camera{vec3<double>(0, 1, 0), vec3<double>(0.8, 0, 0), vec3<double>(0, 0, 0.45)};
    vec3<double> to_sun{0.8, 0, 0.6};
    double reach = 64e3;
};

struct FroxelErrors {
    ErrorMetrics light;
    ErrorMetrics passed;
};

/// Errors of green light and of what passes, relative, on surfaces in the air or on the ground.
template <typename LookUp>
FroxelErrors froxel_errors(const Shot& shot, bool on_ground, const LookUp& look_up) {
    Random random(91);
    std::vector<double> light;
    std::vector<double> passed;
    for (int i = 0; i < 6000; ++i) {
        const vec2<double> screen(random.unit(), random.unit());
        const double drawn = i % 2 == 0 ? random.uniform(10, shot.reach) : random.log_uniform(10, shot.reach);
        const vec3<double> direction = camera_direction(shot.camera, screen);
        const ViewPath<double> path = view_path(shot.air, shot.eye, direction, drawn);
        if (path.reaches_ground != on_ground) {
            continue;
        }
        const double distance = on_ground ? path.end : drawn;
        const Scattered<double> known =
            single_scattering<double>(shot.air, shot.eye, direction, shot.to_sun, distance);
        const Scattered<double> got = look_up(screen, distance);
        light.push_back(std::fabs(got.radiance.y / known.radiance.y - 1));
        passed.push_back(std::fabs(got.transmittance.y / known.transmittance.y - 1));
    }
    return FroxelErrors{error_metrics(light), error_metrics(passed)};
}

}  // namespace

TEST_SUITE_BEGIN("tables_froxels");

TEST_CASE("the air in front of a camera, by size") {
    const Shot shot;
    const auto measure = [&](int depth, int slices, bool on_ground) {
        const FroxelSize size = {32, 32, depth, slices};
        const Froxels<double> froxels =
            bake_froxels(shot.air, shot.eye, shot.camera, shot.to_sun, shot.reach, size);
        const FroxelErrors errors =
            froxel_errors(shot, on_ground, [&](const vec2<double>& screen, double distance) {
                return froxel_light_of(froxels, screen, distance);
            });
        std::printf(
            "froxels 32 x 32 x %d, %s, surfaces %s: light median %.1e p95 %.1e max %.1e, passed p95 %.1e\n",
            depth, slices == slices_linear ? "linear" : "quadratic",
            on_ground ? "on the ground" : "in the air", errors.light.median, errors.light.p95,
            errors.light.largest, errors.passed.p95);
        return errors;
    };
    // The printed errors with a fifth to spare.
    const FroxelErrors squares = measure(32, slices_quadratic, false);
    CHECK(squares.light.median <= 4e-4);
    CHECK(squares.light.p95 <= 2e-3);
    CHECK(squares.passed.p95 <= 1.3e-3);
    const FroxelErrors ground = measure(32, slices_quadratic, true);
    CHECK(ground.light.p95 <= 0.025);
    CHECK(ground.passed.p95 <= 1e-3);
    CHECK(measure(16, slices_quadratic, false).light.median > squares.light.median);
    CHECK(measure(32, slices_linear, false).light.median > squares.light.median);
}

TEST_CASE("filtering light linearly between slices, which is simpler, is worse") {
    const Shot shot;
    const Froxels<double> froxels = bake_froxels(shot.air, shot.eye, shot.camera, shot.to_sun, shot.reach);
    const FroxelErrors plain = froxel_errors(shot, false, [&](const vec2<double>& screen, double distance) {
        const vec3<double> uvw =
            froxel_uvw(screen, distance, froxels.max_distance, froxels.slices, 32, 32, 32);
        return Scattered<double>{sample(froxels.radiance, uvw), glm::exp(-sample(froxels.depth, uvw))};
    });
    const FroxelErrors ours = froxel_errors(shot, false, [&](const vec2<double>& screen, double distance) {
        return froxel_light_of(froxels, screen, distance);
    });
    std::printf("froxels 32 x 32 x 32, plain filtering: light p95 %.1e\n", plain.light.p95);
    CHECK(ours.light.p95 * 10 <= plain.light.p95);
}

TEST_CASE_TEMPLATE("sizes of 1, no air and cameras anywhere give amounts and shares", T, float, double) {
    Atmosphere<T> none = earth<T>();
    none.top_altitude = T(0);
    Random random(92);
    for (const Atmosphere<T>& air : {earth<T>(), mars<T>(), none}) {
        for (const int size : {1, 2, 4}) {
            for (const T altitude : {T(-5), T(0), T(3e3L), T(1e8L)}) {
                const Viewpoint<T> eye{altitude, vec3<T>(T(0), T(0), T(1))};
                const CameraRays<T> camera = {random.direction<T>(), random.direction<T>(),
                                              random.direction<T>()};
                const FroxelSize froxel_size = {size, size, size, random.below(2)};
                const Froxels<T> froxels = bake_froxels(air, eye, camera, random.direction<T>(),
                                                        T(random.log_uniform(1, 1e7)), froxel_size);
                for (int i = 0; i < 20; ++i) {
                    const vec2<T> screen(T(random.unit()), T(random.unit()));
                    const Scattered<T> light = froxel_light_of(
                        froxels, screen, i == 0 ? no_surface<T>() : T(random.log_uniform(1e-3, 1e9)));
                    CHECK_UNARY(is_amount(light.radiance));
                    CHECK_UNARY(is_share(light.transmittance));
                }
            }
        }
    }
}

TEST_SUITE_END();
