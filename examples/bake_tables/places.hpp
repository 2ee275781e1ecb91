#pragma once

// Where tables are read to see how far they are off: as a scene would read them, not as texels lie.

#include <airlight/constants.hpp>
#include <airlight/table_mapping.hpp>
#include <cmath>
#include <cstdint>
#include <optional>

namespace bake_tables {

/// The numbers of one place, even over many places, and the same in every run.
class Draws {
  public:
    /// `sun_elevation` in degrees is taken where it is given.
    Draws(int index, std::optional<double> sun_elevation)
        : index_(std::uint64_t(index) + 1), sun_elevation_(sun_elevation) {}

    /// The next coordinate of this place, in [0, 1), in a low-discrepancy sequence (Kronecker, roots of
    /// primes).
    double unit() {
        static constexpr int primes[8] = {2, 3, 5, 7, 11, 13, 17, 19};
        const double x = double(index_) * std::sqrt(double(primes[next_++ % 8]));
        return x - std::floor(x);
    }

    /// Half of them even in altitude, half even in its logarithm, from a hundred-thousandth of the air up.
    double altitude(const airlight::Atmosphere<double>& air) {
        const double u = unit();
        return air.top_altitude * (u < 0.5 ? 2.0 * u : std::pow(1e-5, 2.0 * u - 1.0));
    }
    /// Above the horizon, even in the angle.
    double sky_cosine(const airlight::Atmosphere<double>& air, double altitude) {
        return std::cos(unit() * std::acos(airlight::horizon_cosine(air.ground_radius, altitude)));
    }
    /// Of a sun between the zenith and 18 degrees below the horizontal, even in the angle.
    double sun_cosine() {
        const double degrees = sun_elevation_ ? 90.0 - *sun_elevation_ : 108.0 * unit();
        return std::cos(degrees * airlight::pi<double> / 180.0);
    }
    /// Of the angle over the ground between view and sun, even.
    double azimuth_cosine() {
        return std::cos(unit() * airlight::pi<double>);
    }

  private:
    std::uint64_t index_;
    int next_ = 0;
    std::optional<double> sun_elevation_;
};

}  // namespace bake_tables
