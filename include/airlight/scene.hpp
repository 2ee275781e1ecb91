#pragma once

#include <airlight/types.hpp>

namespace airlight {

/// No absorbing layer.
inline constexpr int ozone_none = 0;
/// An absorbing layer whose density is a tent over altitude.
inline constexpr int ozone_tent = 1;
/// An absorbing layer whose density is a Lorentz curve times the Rayleigh density.
inline constexpr int ozone_lorentzian = 2;

/// Aerosol scatters by Cornette and Shanks; Atmosphere::mie_g is their parameter g.
inline constexpr int phase_cornette_shanks = 0;
/// Aerosol scatters by Henyey and Greenstein; Atmosphere::mie_g is the mean cosine.
inline constexpr int phase_henyey_greenstein = 1;
/// Water droplets; Atmosphere::mie_g is then the droplet diameter in micrometres.
inline constexpr int phase_fog = 2;

/// The terms a scene is compiled with; one that is off costs nothing. In C++ derive from it and
/// redefine what differs.
struct DefaultScene {
    static constexpr bool mie = true;                        ///< aerosol
    static constexpr int ozone = ozone_tent;                 ///< profile of the absorbing layer
    static constexpr int mie_phase = phase_cornette_shanks;  ///< phase function of the aerosol
    static constexpr bool planet_shadow = true;              ///< the ground sphere hides the sun
    static constexpr int nodes = 8;  ///< per lit piece of a view ray: 4, 5, 6, 8, 10, 12, 16 or 24
};

/// Hook: the share of sunlight that reaches `position` (relative to the eye), in [0, 1].
struct AlwaysLit {
    template <typename T>
    constexpr T operator()([[maybe_unused]] const vec3<T>& position) const {
        return T(1);
    }
};

}  // namespace airlight
