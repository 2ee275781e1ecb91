// Radiance and transmittance from a viewpoint: float against double.

#include <algorithm>
#include <cmath>
#include <vector>

#include <airlight/airlight.hpp>

#include "converted.hpp"
#include "error_metrics.hpp"
#include "samplers.hpp"
#include "tables.hpp"

namespace float_error {
namespace {

using namespace airlight;

/// A float vector of length 1 to rounding.
vec3<float> rounded(const vec3<double>& direction) {
    const vec3<float> narrow(direction);
    return narrow / std::sqrt(dot_product(narrow, narrow));
}

struct Errors {
    airlight_test::ErrorMetrics radiance;
    double unbroken;  ///< largest of radiance, of rays on which the planet's shadow neither begins nor ends
    double transmittance;  ///< largest
};

/// Whether the planet's shadow begins or ends on a view ray.
bool meets_shadow_edge(const Atmosphere<double>& atmosphere, const Viewpoint<double>& eye,
                       const vec3<double>& direction, const vec3<double>& to_sun, double distance) {
    const AirRay<double> ray = air_ray(atmosphere, eye, direction, distance);
    const LineSpan<double> dark =
        shadow_span(atmosphere.ground_radius, ray.perigee_altitude,
                    sun_over_line(atmosphere.ground_radius, eye, direction, to_sun), 0.0);
    const auto on_ray = [&](double along) { return along > ray.along && along < ray.along + ray.extent; };
    return dark.begin < dark.end && (on_ray(dark.begin) || on_ray(dark.end));
}

/// Of views from a height along `length` of air.
Errors errors_at(double height, double length) {
    const Atmosphere<float> narrow = earth<float>();
    const Atmosphere<double> wide = airlight_test::converted<double>(narrow);
    const vec3<double> vertical(0.0, 0.0, 1.0);
    // Luminance of the zenith at noon, seen from the ground: what is darker by four decades counts as that
    // dark.
    const double noon = luminance(single_scattering<double>(wide, Viewpoint<double>{0.0, vertical}, vertical,
                                                            vertical, no_surface<double>())
                                      .radiance);

    airlight_test::Random random(2);
    std::vector<double> radiance;
    double unbroken = 0;
    double transmittance = 0;
    for (int i = 0; i < 4000; ++i) {
        // Half of the rays along the horizon or the limb, the others all over the sky or the disc.
        const vec3<double> up = random.direction<double>();
        const vec3<double> side = glm::normalize(glm::cross(up, random.direction<double>()));
        const bool limb = i % 2 == 0;
        double mu = limb ? random.uniform(-0.1, 0.1) : random.uniform(-1.0, 1.0);
        double sine = std::sqrt((1 - mu) * (1 + mu));
        if (height >= wide.top_altitude) {
            const double perigee = limb ? wide.ground_radius + random.uniform(-2e3, 60e3)
                                        : (wide.ground_radius + 60e3) * std::sqrt(random.unit());
            sine = perigee / (wide.ground_radius + height);
            mu = -std::sqrt((1 - sine) * (1 + sine));
        }
        const vec3<float> direction = rounded(side * sine + up * mu);
        const vec3<float> to_sun = rounded(random.direction<double>());
        const Viewpoint<float> eye = {static_cast<float>(height), rounded(up)};
        const Viewpoint<double> same_eye = {eye.altitude, vec3<double>(eye.up)};

        const ViewPath<double> path =
            view_path<double>(wide, same_eye, vec3<double>(direction), no_surface<double>());
        if (!path.in_air) {
            continue;
        }
        const float distance = static_cast<float>(path.begin + length);
        const Scattered<float> got = single_scattering(narrow, eye, direction, to_sun, distance);
        const Scattered<double> expected = single_scattering<double>(wide, same_eye, vec3<double>(direction),
                                                                     vec3<double>(to_sun), distance);
        const double bright = luminance(expected.radiance);
        const double error =
            std::fabs(luminance(vec3<double>(got.radiance)) - bright) / std::fmax(bright, 1e-4 * noon);
        radiance.push_back(error);
        if (!meets_shadow_edge(wide, same_eye, vec3<double>(direction), vec3<double>(to_sun), distance)) {
            unbroken = std::fmax(unbroken, error);
        }
        for (int k = 0; k < 3; ++k) {
            transmittance =
                std::fmax(transmittance, std::fabs(got.transmittance[k] - expected.transmittance[k]));
        }
    }
    return Errors{airlight_test::error_metrics(radiance), unbroken, transmittance};
}

}  // namespace

std::string view_tables() {
    const double heights[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 3e7, 1e8, 1e9, 1e10, 1e12};
    const double lengths[] = {1, 100, 1e4, static_cast<double>(no_surface<float>())};
    const std::string head = "| eye at | 1 m | 100 m | 10 km | all of it |\n|---|---:|---:|---:|---:|\n";
    std::string radiance = head;
    std::string transmittance = head;
    for (const double height : heights) {
        radiance += "| " + length_text(height);
        transmittance += "| " + length_text(height);
        for (const double length : lengths) {
            const Errors errors = errors_at(height, length);
            radiance += " | " + figure(errors.radiance.p95) + " / " + figure(errors.unbroken) + " / " +
                        figure(errors.radiance.largest);
            transmittance += " | " + figure(errors.transmittance);
        }
        radiance += " |\n";
        transmittance += " |\n";
    }
    return "### Radiance from a viewpoint, by the way through the air\n\n"
           "Relative error of the luminance that the air adds in float against double on equal inputs: 95 % "
           "of "
           "the rays / the\nworst on which the planet's shadow neither begins nor ends / the worst of all. "
           "4000 "
           "rays each: half along the horizon or\nthe limb, half all over the sky or the disc, the sun "
           "anywhere. Light below a ten thousandth of the zenith at noon counts\nas that. The surface stands "
           "after so much way through the air. A surface that is so far away that a float distance to "
           "it\nhas "
           "no metres left has the error of that distance, as has a ray that misses the air by rounding. The "
           "shadow's edge is as\nsharp as the sun's direction: a roundoff of it is half a metre of way, "
           "which "
           "is much of a ray with ten lit metres.\n\n" +
           radiance +
           "\n### Transmittance from a viewpoint, by the way through the air\n\nLargest absolute error of "
           "the same "
           "rays' transmittances.\n\n" +
           transmittance;
}

}  // namespace float_error
