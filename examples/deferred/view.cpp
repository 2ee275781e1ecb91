#include "view.hpp"

#include <algorithm>
#include <cmath>

#include <airlight/constants.hpp>
#include <airlight/occultation.hpp>
#include <airlight/sun.hpp>

#include "support/error.hpp"

namespace deferred {
namespace {

constexpr double degree = airlight::pi<double> / 180;
constexpr double sun_magnitude = -26.74;
constexpr double moon_sin_radius = 0.00452;
constexpr double moon_albedo = 0.12;   // geometric: how bright the full moon is
constexpr double near_distance = 0.1;  // [m] a person's nose is further away

/// Light of a sphere that scatters as Lommel and Seeliger's dust, of its light when full; the angle is that
/// between sun and eye, seen from it (Seeliger 1887).
double phase_law(double cosine) {
    const double half = 0.5 * std::acos(std::clamp(cosine, -1.0, 1.0));
    if (half < 1e-6 || half > 1.570796) {
        return half < 1 ? 1 : 0;
    }
    return 1 - std::sin(half) * std::tan(half) * std::log(1 / std::tan(0.5 * half));
}

/// What the moon leaves of the sun in an eclipse.
double sun_beside_moon(const glm::dvec3& to_sun, const glm::dvec3& to_moon) {
    if (glm::dot(to_sun, to_moon) <= 0) {
        return 1;
    }
    const double apart = glm::length(glm::cross(to_sun, to_moon));
    const double sun_sin_radius = airlight::solar_sin_radius<double>;
    constexpr double mean_limb_exponent = 0.5;
    return airlight::visible_share_of_light(
        airlight::Occultation<double>{(apart - moon_sin_radius) / sun_sin_radius,
                                      sun_sin_radius / moon_sin_radius},
        mean_limb_exponent);
}

}  // namespace

const std::vector<Camera>& named_cameras() {
    // Ground: a walker's eyes on a summit. Valley: a drone over the valley of the fault. 10km: an airliner
    // east of the ridges. Orbit: a space station, the landscape below and the limb ahead.
    // Shafts: over the same valley, with the slabs before a low sun.
    static const std::vector<Camera> cameras = {
        {"ground", -3034, -10928, 2, true, 265, 1, 35}, {"valley", 1492, 1071, 40, true, 250, 6, 40},
        {"10km", 14e3, 9e3, 10e3, false, 240, -14, 50}, {"orbit", 560e3, 230e3, 400e3, false, 250, -22, 50},
        {"shafts", 1492, 1071, 30, true, 250, 7, 30},
    };
    return cameras;
}

void aim(Frame& frame, const glm::dvec3& forward, const glm::dvec3& up, double field_of_view, int width,
         int height) {
    const glm::dvec3 right = glm::cross(forward, up);
    const double half_height = std::tan(field_of_view / 2 * degree);
    const double pixel = 2 * half_height / height;
    frame.width = width;
    frame.height = height;
    frame.ray_across = vec3(pixel * right);
    frame.ray_up = vec3(pixel * up);
    frame.ray_corner = vec3(forward - half_height * up - 0.5 * width * pixel * right);
    frame.near_distance = float(near_distance);
}

View make_view(const Camera& camera, const Picturing& picturing, double ground_radius,
               const Terrain& terrain) {
    const double ground = terrain.height(camera.east, camera.north);
    const double altitude = camera.altitude + (camera.above_landscape ? ground : 0);
    if (altitude - ground < 2 * near_distance) {
        throw support::Error("camera " + camera.name + " at " + std::to_string(altitude) +
                             " m is below the ground at " + std::to_string(ground) +
                             " m; give a larger --altitude or --height");
    }
    const Place place = place_on_sphere(ground_radius, camera.east, camera.north, altitude);
    const auto compass = [&](double heading, double elevation) {
        const glm::dvec3 level =
            std::sin(heading * degree) * place.east + std::cos(heading * degree) * place.north;
        return std::cos(elevation * degree) * level + std::sin(elevation * degree) * place.up;
    };
    const glm::dvec3 forward = compass(camera.heading, camera.pitch);
    const glm::dvec3 up = compass(camera.heading, camera.pitch + 90);
    const double pixel = 2 * std::tan(camera.field_of_view / 2 * degree) / picturing.height;

    Frame frame{};
    aim(frame, forward, up, camera.field_of_view, picturing.width, picturing.height);
    frame.eye_position = vec3(place.position);
    frame.to_sun = vec3(compass(picturing.sun_azimuth, picturing.sun_elevation));
    frame.solar_irradiance = vec3(1);
    frame.sun_sin_radius = airlight::solar_sin_radius<float>;
    frame.sun_sin_edge = float(pixel / 2);
    frame.marched = picturing.marched;
    frame.steps = picturing.steps;
    frame.sky_steps = picturing.sky_steps;
    frame.air = picturing.settings.air;
    frame.phong = picturing.settings.phong;
    frame.lommel_seeliger = picturing.settings.lommel_seeliger;
    const glm::dvec3 to_sun = compass(picturing.sun_azimuth, picturing.sun_elevation);
    const glm::dvec3 to_moon = compass(picturing.settings.moon_azimuth, picturing.settings.moon_elevation);
    frame.star_radiance =
        picturing.settings.stars ? float(std::pow(10, 0.4 * sun_magnitude) / (pixel * pixel)) : 0.0f;
    frame.lights = picturing.settings.moon ? 2 : 1;
    frame.to_moon = vec3(to_moon);
    frame.moon_sin_radius = float(moon_sin_radius);
    frame.moon_irradiance =
        float(moon_albedo * moon_sin_radius * moon_sin_radius * phase_law(-glm::dot(to_sun, to_moon)));
    frame.sun_seen = picturing.settings.moon ? float(sun_beside_moon(to_sun, to_moon)) : 1.0f;
    // The sun's shadows while any of its light reaches the ground in sight, then the moon's.
    const double sight = std::acos(ground_radius / (ground_radius + std::max(altitude, 0.0))) / degree;
    frame.mapped_light = picturing.settings.moon && picturing.sun_elevation < -1 - sight ? 1 : 0;
    return View{place.position, altitude, altitude - ground, frame};
}

}  // namespace deferred
