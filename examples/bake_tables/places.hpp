#pragma once

// Where tables are read to see how far they are off: as a scene would read them, not as texels lie.

#include <airlight/constants.hpp>
#include <airlight/table_mapping.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kinds.hpp"

namespace bake_tables {

/// Numbers in [0, 1) that fill the square evenly, always the same ones.
class Draws {
  public:
    explicit Draws(int index) : index_(std::uint64_t(index) + 1) {}

    /// The next coordinate of this place, in a low-discrepancy sequence (Kronecker, roots of primes).
    double unit() {
        static constexpr int primes[6] = {2, 3, 5, 7, 11, 13};
        const double x = double(index_) * std::sqrt(double(primes[next_++ % 6]));
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
        return std::cos(unit() * 108.0 * airlight::pi<double> / 180.0);
    }

  private:
    std::uint64_t index_;
    int next_ = 0;
};

/// `count` places, each by place(atmosphere, draws, size).
template <typename Place>
std::vector<airlight::vec3<double>> drawn_places(const Request& request, int count, const Place& place) {
    std::vector<airlight::vec3<double>> places;
    for (int n = 0; n < count; ++n) {
        Draws draws(n);
        places.push_back(place(request.preset.air, draws, request.size));
    }
    return places;
}

}  // namespace bake_tables
