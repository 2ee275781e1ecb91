#include <airlight/tables/froxels.hpp>
#include <airlight/tables/sky_view.hpp>
#include <cmath>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::vec2;
using airlight::vec3;

constexpr double froxel_distance = 128000;  // [m]

double sun_cosine(const Request& request) {
    return std::sin(request.sun_elevation * airlight::pi<double> / 180.0);
}

template <typename T>
vec3<T> to_sun(const Request& request) {
    const double mu_s = sun_cosine(request);
    return vec3<T>(vec3<double>(std::sqrt((1 - mu_s) * (1 + mu_s)), 0.0, mu_s));
}

template <typename T>
airlight::Viewpoint<T> eye_of(const Request& request) {
    return {T(request.eye_altitude), vec3<T>(T(0), T(0), T(1))};
}

/// Level, towards the sun, 90 degrees wide and 60 high.
template <typename T>
airlight::CameraRays<T> camera() {
    return {vec3<T>(T(1), T(0), T(0)), vec3<T>(T(0), T(-1), T(0)),
            vec3<T>(T(0), T(0), T(0.57735026918962576L))};
}

Kind sky_view() {
    Kind kind{"sky_view",
              "the sky around one eye, light scattered once",
              {192, 108, 1},
              "sky_view_uv",
              "radiance of the air to its end or to the ground",
              "1/sr, per unit of solar irradiance above the air",
              {"R", "G", "B"}};
    kind.of_frame = true;
    kind.small_size = {17, 10, 1};
    kind.size_rule = "give an even height: half of the rows look at the ground";
    kind.takes_size = even_height;
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const support::Rows& rows) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        return support::numbers_of(airlight::bake_sky_view<T, decltype(scene)>(
            air, T(request.eye_altitude), T(sun_cosine(request)), request.size.width, request.size.height,
            airlight::NoDiffuseLight{}, rows));
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        const GpuTable table = gpu.make_table(request.size);
        gpu.pass("sky_view", {&table}, {},
                 {{"eye_altitude", float(request.eye_altitude)}, {"mu_s", float(sun_cosine(request))}});
        return numbers_of(table, 3);
    };
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const double mu = std::cos(draws.unit() * airlight::pi<double>);
        const vec3<double> up(0.0, 0.0, 1.0);
        const vec3<double> direction =
            airlight::sky_direction(up, to_sun<double>(request), mu, draws.azimuth_cosine());
        const airlight::Viewpoint<double> eye = eye_of<double>(request);
        const vec2<double> at = airlight::sky_view_place(air, eye, direction, to_sun<double>(request),
                                                         request.size.width, request.size.height);
        add(all, look_up(vec3<double>(at, 0.5)),
            airlight::single_scattering<double, decltype(scene)>(air, eye, direction, to_sun<double>(request),
                                                                 airlight::no_surface<double>())
                .radiance);
    });
    kind.remark =
        "For an eye 200 m up and a sun 20 degrees high, over "
        "directions even in both angles.";
    return kind;
}

Kind froxels() {
    Kind kind{"froxels",
              "the air in front of one camera up to 128 km, light scattered once",
              {32, 32, 32},
              "froxel_uvw",
              "radiance that the air adds [1/sr]; its optical depth [1]",
              "1/sr per unit of solar irradiance above the air, and 1",
              {"radiance.R", "radiance.G", "radiance.B", "depth.R", "depth.G", "depth.B"}};
    kind.of_frame = true;
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const support::Rows& rows) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        const airlight::FroxelSize size{request.size.width, request.size.height, request.size.depth};
        const airlight::Froxels<T> made = airlight::bake_froxels<T, decltype(scene)>(
            air, eye_of<T>(request), camera<T>(), to_sun<T>(request), T(froxel_distance), size,
            airlight::NoDiffuseLight{}, rows);
        return support::numbers_of(made.radiance, made.depth);
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        const GpuTable radiance = gpu.make_table(request.size);
        const GpuTable depth = gpu.make_table(request.size);
        const airlight::CameraRays<float> rays = camera<float>();
        gpu.pass("froxels", {&radiance, &depth}, {},
                 {{"eye.altitude", float(request.eye_altitude)},
                  {"eye.up", vec3<float>(0, 0, 1)},
                  {"camera.centre", rays.centre},
                  {"camera.right", rays.right},
                  {"camera.up", rays.up},
                  {"to_sun", to_sun<float>(request)},
                  {"max_distance", float(froxel_distance)},
                  {"slices", airlight::slices_quadratic}});
        return side_by_side({&radiance, &depth});
    };
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const double x = draws.unit();
        const vec2<double> screen(x, draws.unit());
        const vec3<double> direction = airlight::camera_direction(camera<double>(), screen);
        const airlight::Viewpoint<double> eye = eye_of<double>(request);
        double distance = 1000.0 * std::pow(froxel_distance / 1000.0, draws.unit());
        const auto path = airlight::view_path(air, eye, direction, distance);
        distance = path.reaches_ground ? path.end : distance;
        const airlight::FroxelSize size;
        const auto look_up_both = [&](const vec3<double>& uvw) {
            const std::vector<double> read = look_up(uvw);
            return airlight::FroxelAir<double>{vec3<double>(read[0], read[1], read[2]),
                                               vec3<double>(read[3], read[4], read[5])};
        };
        const auto read =
            airlight::froxel_light(screen, distance, froxel_distance, size.slices, request.size.width,
                                   request.size.height, request.size.depth, look_up_both);
        const auto exact = airlight::single_scattering<double, decltype(scene)>(
            air, eye, direction, to_sun<double>(request), distance);
        add(all, read.radiance, exact.radiance);
        add(all, read.transmittance, exact.transmittance);
    });
    kind.remark =
        "Radiance and transmittance before surfaces 1 to 128 km away; "
        "an eye 200 m up that looks level towards a "
        "sun 20 degrees\nhigh, 90 degrees wide and 60 high.";
    return kind;
}

}  // namespace

std::vector<Kind> frame_kinds() {
    return {sky_view(), froxels()};
}

}  // namespace bake_tables
