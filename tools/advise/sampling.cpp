#include "sampling.hpp"

#include <airlight/constants.hpp>
#include <airlight/view_path.hpp>
#include <algorithm>
#include <cmath>
#include <samplers.hpp>

namespace advise {
namespace {

using airlight_test::Random;

const Vector up(0.0, 0.0, 1.0);

double radians(double degrees) {
    return degrees * airlight::pi<double> / 180.0;
}

/// Degrees over the horizontal plane, and from the sun's azimuth.
Vector direction(double elevation, double azimuth) {
    const double e = radians(elevation);
    const double a = radians(azimuth);
    return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

/// Degrees over the horizontal plane of a ray whose closest approach to the centre has this altitude.
double elevation_past(const Atmosphere& air, double altitude, double perigee) {
    const double sine = (air.ground_radius + perigee) / (air.ground_radius + altitude);
    return -std::acos(std::clamp(sine, -1.0, 1.0)) * 180.0 / airlight::pi<double>;
}

/// One point in each of `count` equal parts of [0, 1], both ends among them, in random order.
std::vector<double> strata(Random& random, int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(i == 0 ? 0.0 : i == count - 1 ? 1.0 : (i + random.unit()) / count);
    }
    for (int i = count - 1; i > 0; --i) {
        std::swap(out[static_cast<std::size_t>(i)], out[static_cast<std::size_t>(random.below(i + 1))]);
    }
    return out;
}

/// Even in the logarithm of height + scale height: as dense near the ground as the air is.
double height_at(const Atmosphere& air, const Range& range, double u) {
    const double scale = air.mie_scale_height;
    const double low = std::max(range.low, 0.0) + scale;
    const double high = std::max(range.high, 0.0) + scale;
    return std::min(low * std::exp(u * std::log(high / low)) - scale, std::max(range.high, 0.0));
}

/// Even in the logarithm. Where the range has no end, the upper half of it is views without a surface, and
/// the lower half reaches a hundred heights of the air.
double distance_at(const Atmosphere& air, const Range& range, double u) {
    if (!std::isfinite(range.low)) {
        return airlight::no_surface<double>();
    }
    const double least = 1.0;
    const double low = std::max(range.low, least);
    if (std::isfinite(range.high)) {
        return low * std::exp(u * std::log(std::max(range.high, least) / low));
    }
    const double high = std::max(100.0 * air.rayleigh_scale_height, low);
    return u >= 0.5 ? airlight::no_surface<double>() : low * std::exp(2.0 * u * std::log(high / low));
}

enum class Look { upwards, horizon, downwards, sun };

/// Degrees over the horizontal plane.
double elevation_at(const Atmosphere& air, double altitude, Look look, double u) {
    const double horizon = -horizon_dip(air, altitude);
    if (altitude > air.top_altitude) {
        const double edge = elevation_past(air, altitude, air.top_altitude);
        switch (look) {
            case Look::upwards:
                return horizon + u * (edge - horizon);
            case Look::downwards:
                return -90.0 + u * (horizon + 90.0);
            default:
                return elevation_past(air, altitude, (u - 0.5) * air.top_altitude);
        }
    }
    switch (look) {
        case Look::upwards:
            return horizon + u * (90.0 - horizon);
        case Look::downwards:
            return -90.0 + u * (horizon + 90.0);
        default:
            return std::max(horizon + 6.0 * (u - 0.5), -90.0);
    }
}

/// A direction at some degrees from the sun.
Vector beside_sun(const Vector& to_sun, double degrees, double turn) {
    const Vector side(0.0, 1.0, 0.0);  // the sun has azimuth 0
    const Vector over = glm::cross(to_sun, side);
    const double a = radians(degrees);
    const double b = radians(turn);
    return glm::normalize(std::cos(a) * to_sun + std::sin(a) * (std::cos(b) * side + std::sin(b) * over));
}

bool meets_air(const Atmosphere& air, const View& view) {
    return airlight::air_ray(air, view.eye, view.direction, view.distance).in_air;
}

}  // namespace

double horizon_dip(const Atmosphere& air, double altitude) {
    return -elevation_past(air, std::max(altitude, 0.0), 0.0);
}

View noon_zenith() {
    return {{2.0, up}, up, up, airlight::no_surface<double>()};
}

std::vector<View> sampled(const Atmosphere& air, const Ranges& ranges, int count, std::uint64_t seed) {
    Random random(seed);
    const std::vector<double> heights = strata(random, count);
    const std::vector<double> suns = strata(random, count);
    const std::vector<double> distances = strata(random, count);
    const std::vector<double> elevations = strata(random, count);
    const std::vector<double> azimuths = strata(random, count);
    std::vector<View> out;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double altitude = height_at(air, ranges.height, heights[i]);
        const double sun = ranges.sun.low + suns[i] * (ranges.sun.high - ranges.sun.low);
        const Look look = static_cast<Look>(i % 4);
        const double azimuth = 180.0 * azimuths[i];
        View view{{altitude, up},
                  direction(elevation_at(air, altitude, look, elevations[i]), azimuth),
                  direction(sun, 0.0),
                  distance_at(air, ranges.distance, distances[i])};
        if (look == Look::sun) {
            const Vector level = view.direction;
            view.direction =
                beside_sun(view.to_sun, 0.3 * std::exp(elevations[i] * std::log(100.0)), 2.0 * azimuth);
            if (!meets_air(air, view)) {  // nothing to see there from space
                view.direction = level;
            }
        }
        // A surface in front of the air hides it: where the range has no end, look past that.
        if (!std::isfinite(ranges.distance.high) && !meets_air(air, view)) {
            view.distance = airlight::no_surface<double>();
        }
        if (meets_air(air, view)) {
            out.push_back(view);
        }
    }
    return out;
}

}  // namespace advise
