#include "steering.hpp"

#include <algorithm>
#include <cmath>

#include <airlight/constants.hpp>

namespace deferred {
namespace {

constexpr double degree = airlight::pi<double> / 180;
constexpr double lowest = 1.7;       // [m] above the ground: a person's eyes
constexpr double highest = 1e8;      // [m]
constexpr double slowest = 3;        // [m/s]
constexpr double farthest = 2999e3;  // [m] from the landscape: beyond, the command line takes no camera

double within(double degrees) {
    return degrees - 360 * std::floor(degrees / 360);
}

}  // namespace

Camera flown(const Camera& camera, const Steering& steering, double seconds, double ground_radius,
             const Terrain& terrain) {
    Camera moved = camera;
    const double ground = terrain.height(camera.east, camera.north);
    moved.altitude = camera.altitude + (camera.above_landscape ? ground : 0);
    moved.above_landscape = false;
    moved.name = "free";

    const Place place = place_on_sphere(ground_radius, camera.east, camera.north, moved.altitude);
    const double heading = camera.heading * degree;
    const double pitch = camera.pitch * degree;
    const glm::dvec3 level = std::sin(heading) * place.east + std::cos(heading) * place.north;
    const glm::dvec3 right = std::cos(heading) * place.east - std::sin(heading) * place.north;
    const glm::dvec3 forward = std::cos(pitch) * level + std::sin(pitch) * place.up;
    const double speed = steering.haste * std::max(slowest, moved.altitude - ground);
    const glm::dvec3 way = steering.forward * forward + steering.right * right + steering.up * place.up;
    const glm::dvec3 from_centre = place.position + speed * seconds * way + glm::dvec3(0, 0, ground_radius);

    const double distance = glm::length(from_centre);
    const double sideways = std::hypot(from_centre.x, from_centre.y);
    const double arc = std::min(ground_radius * std::atan2(sideways, from_centre.z), farthest);
    moved.east = sideways > 0 ? arc * from_centre.x / sideways : 0;
    moved.north = sideways > 0 ? arc * from_centre.y / sideways : 0;
    moved.altitude =
        std::clamp(distance - ground_radius, terrain.height(moved.east, moved.north) + lowest, highest);
    // The same way on, as the compass there has it.
    const Place there = place_on_sphere(ground_radius, moved.east, moved.north, moved.altitude);
    moved.heading = within(std::atan2(glm::dot(level, there.east), glm::dot(level, there.north)) / degree);
    return moved;
}

Camera turned(const Camera& camera, double right, double up) {
    Camera after = camera;
    after.heading = within(camera.heading + right);
    after.pitch = std::clamp(camera.pitch + up, -90.0, 90.0);
    return after;
}

SkyPlace hours_later(const SkyPlace& sun, double hours, double latitude) {
    const double elevation = sun.elevation * degree;
    const double azimuth = sun.azimuth * degree;
    // East, north, up; turned about the pole, westwards.
    const glm::dvec3 v(std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
                       std::sin(elevation));
    const glm::dvec3 pole(0, std::cos(latitude * degree), std::sin(latitude * degree));
    const double angle = -hours * 15 * degree;
    const glm::dvec3 w = v * std::cos(angle) + glm::cross(pole, v) * std::sin(angle) +
                         pole * (glm::dot(pole, v) * (1 - std::cos(angle)));
    return SkyPlace{std::asin(std::clamp(w.z, -1.0, 1.0)) / degree, within(std::atan2(w.x, w.y) / degree)};
}

}  // namespace deferred
