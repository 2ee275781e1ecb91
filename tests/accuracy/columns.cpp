// Columns from an altitude and a cosine: float against double, and against the integral itself.

#include <algorithm>
#include <cmath>
#include <vector>

#include <airlight/airlight.hpp>

#include "converted.hpp"
#include "quadrature.hpp"
#include "samplers.hpp"
#include "tables.hpp"

namespace float_error {
namespace {

using namespace airlight;
using Real = long double;

/// The optical depth of a path by quadrature of the densities, in panels of half a scale height of aerosol.
vec3<Real> integrated_depth(const Atmosphere<Real>& air, Real altitude, Real mu, Real distance) {
    const AirPath<Real> path = air_path(air, altitude, mu, distance);
    std::vector<Real> cuts = {0, path.extent};
    for (Real shell = 0; shell < air.top_altitude; shell += shell < 20e3L ? 600 : 4000) {
        for (const bool climbing : {false, true}) {
            const Real t = distance_to_shell(air.ground_radius, path, shell, climbing);
            if (t > 0 && t < path.extent) {
                cuts.push_back(t);
            }
        }
    }
    for (const Real shell : {air.ozone_altitude - air.ozone_half_width, air.ozone_altitude,
                             air.ozone_altitude + air.ozone_half_width}) {
        for (const bool climbing : {false, true}) {
            cuts.push_back(std::clamp(distance_to_shell(air.ground_radius, path, shell, climbing), Real(0),
                                      path.extent));
        }
    }
    if (path.along < 0 && -path.along < path.extent) {
        cuts.push_back(-path.along);
    }
    std::sort(cuts.begin(), cuts.end());

    Column<Real> sum = {0, 0, 0};
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const auto density = [&](Real t) {
            return relative_density<Real>(
                air, altitude_along_ray(air.ground_radius, path.begin_altitude, path.along, t));
        };
        const Real begin = cuts[i];
        const Real end = cuts[i + 1];
        if (end > begin) {
            const Real tolerance = 1e-9L;
            sum.rayleigh +=
                airlight_test::integrate([&](Real t) { return density(t).rayleigh; }, begin, end, tolerance);
            sum.mie +=
                airlight_test::integrate([&](Real t) { return density(t).mie; }, begin, end, tolerance);
            sum.ozone +=
                airlight_test::integrate([&](Real t) { return density(t).ozone; }, begin, end, tolerance);
        }
    }
    return column_optical_depth<Real>(air, sum);
}

}  // namespace

std::string column_table() {
    const double heights[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 3e7};
    const double distances[] = {1, 1e3, 1e5, static_cast<double>(no_surface<float>())};
    std::string out =
        "### Optical depth from an altitude and a cosine\n\n"
        "Largest relative error of `optical_depth` in float over 200 rays each that stay above the ground, "
        "from its "
        "three\nchannels: *against double* on equal inputs / *against the integral*, by quadrature of the "
        "densities. "
        "Half of the rays lie\nwithin 6 degrees of the horizon, those from above the air are aimed at it. "
        "Far eyes hang on digits that a float cosine\ndoes not have: from there start from a `Viewpoint`, as "
        "the "
        "next table does.\n\n"
        "| eye at | 1 m | 1 km | 100 km | to space |\n|---|---:|---:|---:|---:|\n";
    const Atmosphere<float> narrow = earth<float>();
    const Atmosphere<double> wide = airlight_test::converted<double>(narrow);
    const Atmosphere<Real> widest = airlight_test::converted<Real>(narrow);
    for (const double height : heights) {
        out += "| " + length_text(height);
        for (const double distance : distances) {
            airlight_test::Random random(1);
            double against_double = 0;
            double against_integral = 0;
            for (int i = 0; i < 200; ++i) {
                const float altitude = static_cast<float>(height);
                const double share =
                    (wide.ground_radius + random.uniform(0.0, 99e3)) / (wide.ground_radius + height);
                const float mu =
                    static_cast<float>(height < wide.top_altitude ? (i % 2 == 0 ? random.uniform(-0.1, 0.1)
                                                                                : random.uniform(-1.0, 1.0))
                                                                  : -std::sqrt((1 - share) * (1 + share)));
                // Distances count from where the ray enters the air.
                const AirPath<double> all = air_path<double>(wide, altitude, mu, no_surface<double>());
                const double entry = std::fmax(all.along - (wide.ground_radius + altitude) * mu, 0.0);
                const float length = static_cast<float>(entry + distance);
                const AirPath<double> path = air_path<double>(wide, altitude, mu, length);
                const bool through = path.along < 0 && path.along + path.extent > 0;
                const double low =
                    through ? path.perigee_altitude : std::fmin(path.begin_altitude, path.end_altitude);
                if (low < 0 || !(path.extent > 0)) {
                    continue;
                }
                const vec3<float> got = optical_depth(narrow, altitude, mu, length);
                const vec3<double> precise = optical_depth<double>(wide, altitude, mu, length);
                const vec3<Real> exact = integrated_depth(widest, altitude, mu, length);
                for (int k = 0; k < 3; ++k) {
                    against_double = std::fmax(against_double, std::fabs(got[k] - precise[k]) / precise[k]);
                    against_integral = std::fmax(
                        against_integral, static_cast<double>(std::fabs(got[k] - exact[k]) / exact[k]));
                }
            }
            out += " | " + figure(against_double) + " / " + figure(against_integral);
        }
        out += " |\n";
    }
    return out + "\n";
}

}  // namespace float_error
