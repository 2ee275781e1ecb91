#pragma once

// The air of one colour, as a random walk needs it.

#include <airlight/atmosphere.hpp>
#include <vector>

#include "directions.hpp"

namespace reference {

/// What the air does per metre at one place [1/m].
struct Coefficients {
    double rayleigh = 0;    ///< scattered by molecules
    double mie = 0;         ///< scattered by aerosol
    double absorption = 0;  ///< absorbed by aerosol and ozone

    double scattering() const {
        return rayleigh + mie;
    }
    double extinction() const {
        return rayleigh + mie + absorption;
    }
};

/// How a straight flight ended. Whoever meets the air may be absorbed.
enum class End { met_air, ground, escaped };

/// Where.
struct Flight {
    End end;
    Vector position;  ///< [m] from the planet's centre
};

/// One colour channel of an atmosphere, with absorbing layer `ozone` (airlight::ozone_tent and so on).
class Air {
  public:
    Air(const airlight::Atmosphere<double>& atmosphere, int ozone, int channel);

    const airlight::Atmosphere<double>& atmosphere() const {
        return atmosphere_;
    }
    double ground_radius() const {
        return atmosphere_.ground_radius;
    }
    double top_radius() const {
        return atmosphere_.ground_radius + atmosphere_.top_altitude;
    }
    double albedo() const {
        return atmosphere_.ground_albedo[channel_];
    }

    Coefficients at(double altitude) const;
    /// Phase functions mixed by what scatters there [1/sr].
    double phase(const Coefficients& air, double cos_theta) const;
    /// A direction drawn with that distribution.
    Vector scattered(const Coefficients& air, const Vector& direction, Random& random) const;

    /// Share of light that passes between a point inside the air and space, 0 behind the planet: the
    /// library's closed form.
    double to_space(const Vector& position, const Vector& direction) const;
    /// Share that passes over a distance along a straight line from a point inside the air.
    double along(const Vector& position, const Vector& direction, double distance) const;

    /// Flies until something happens: Woodcock's tracking, shell by shell, by the densities alone.
    Flight fly(Vector position, const Vector& direction, Random& random) const;

  private:
    double profile(double altitude) const;                           // of the layer's own shape
    double passed(double rayleigh, double mie, double ozone) const;  // through columns

    airlight::Atmosphere<double> atmosphere_;
    int ozone_;
    int channel_;
    std::vector<double> shells_;    // [m] radii, the ground's first, the air's top last
    std::vector<double> majorant_;  // [1/m] no extinction between shells i and i + 1 is larger
};

}  // namespace reference
