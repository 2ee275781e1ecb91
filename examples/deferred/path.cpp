#include "path.hpp"

#include <algorithm>
#include <cmath>

#include <airlight/constants.hpp>

namespace deferred {
namespace {

constexpr double degree = airlight::pi<double> / 180;
constexpr double lowest = 1;        // [m] above the landscape
constexpr double highest = 1e8;     // [m]
constexpr double farthest = 600e3;  // [m] along the ground: as far as an orbit's eye sees the landscape well

/// From 0 to 1 while the decimal logarithm of `height` goes from `first` to `last`.
double climbed(double height, double first, double last) {
    const double t = std::clamp((std::log10(height) - first) / (last - first), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double mix(double a, double b, double share) {
    return a + share * (b - a);
}

double azimuth_of(const glm::dvec3& direction, const Place& place) {
    return std::atan2(glm::dot(direction, place.east), glm::dot(direction, place.north)) / degree;
}

double elevation_of(const glm::dvec3& direction, const Place& place) {
    return std::asin(std::clamp(glm::dot(direction, place.up), -1.0, 1.0)) / degree;
}

glm::dvec3 direction_at(const Place& place, double azimuth, double elevation) {
    const glm::dvec3 level =
        std::sin(azimuth * degree) * place.east + std::cos(azimuth * degree) * place.north;
    return std::cos(elevation * degree) * level + std::sin(elevation * degree) * place.up;
}

}  // namespace

const std::vector<std::string>& sequence_names() {
    static const std::vector<std::string> names = {"flight", "day", "turntable"};
    return names;
}

std::vector<Moment> flight(int frames, const Moment& start, double ground_radius) {
    const Place origin = place_on_sphere(ground_radius, start.camera.east, start.camera.north, 0);
    const glm::dvec3 to_sun = direction_at(origin, start.sun_azimuth, start.sun_elevation);
    std::vector<Moment> moments;
    for (int i = 0; i < frames; ++i) {
        const double height = lowest * std::pow(highest / lowest, double(i) / std::max(frames - 1, 1));
        // Straight up at first; later the start is seen 22 degrees below the horizontal, until it is as far
        // as it gets. Never 0: it is what the camera looks back to.
        const double slope = std::max(2.5 * climbed(height, 2, 4), 1e-3);
        const double away = slope * height / std::hypot(1, slope * height / farthest);
        Moment moment = start;
        Camera& camera = moment.camera;
        camera.altitude = height;
        camera.above_landscape = true;
        camera.east -= away * std::sin(start.camera.heading * degree);
        camera.north -= away * std::cos(start.camera.heading * degree);
        const Place place = place_on_sphere(ground_radius, camera.east, camera.north, height);
        camera.heading = azimuth_of(origin.position - place.position, place);

        // The horizon a little above the middle, higher when there is a landscape to look down on.
        const double dip = std::acos(ground_radius / (ground_radius + height)) / degree;
        camera.pitch = mix(-dip - mix(3, 12, climbed(height, 1, 4)), -90, climbed(height, 6, 7.5));
        camera.field_of_view = mix(50, 16, climbed(height, 7, 8));

        moment.sun_elevation = elevation_of(to_sun, place);
        moment.sun_azimuth = azimuth_of(to_sun, place);
        moments.push_back(moment);
    }
    return moments;
}

std::vector<Moment> day(int frames, const Camera& camera, double latitude) {
    // At an equinox the sun is on the celestial equator, so west of the meridian by the hour angle there.
    std::vector<Moment> moments;
    for (int i = 0; i < frames; ++i) {
        const double hour_angle = 2 * airlight::pi<double> * (double(i) / frames - 0.5);
        const double east = -std::sin(hour_angle);
        const double north = -std::cos(hour_angle) * std::sin(latitude * degree);
        const double up = std::cos(hour_angle) * std::cos(latitude * degree);
        moments.push_back(Moment{camera, std::atan2(up, std::hypot(east, north)) / degree,
                                 std::atan2(east, north) / degree});
    }
    return moments;
}

std::vector<Moment> turntable(int frames, const Moment& start) {
    std::vector<Moment> moments(std::size_t(frames), start);
    for (int i = 0; i < frames; ++i) {
        moments[std::size_t(i)].camera.heading += 360.0 * i / frames;
    }
    return moments;
}

}  // namespace deferred
