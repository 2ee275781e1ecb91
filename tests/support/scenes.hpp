#pragma once

// Scenes with one term or setting that differs from the default.
#include <airlight/scene.hpp>

namespace airlight_test {

struct NoMie : airlight::DefaultScene {
    static constexpr bool mie = false;
};
struct NoOzone : airlight::DefaultScene {
    static constexpr int ozone = airlight::ozone_none;
};
struct Lorentzian : airlight::DefaultScene {
    static constexpr int ozone = airlight::ozone_lorentzian;
};
struct HenyeyGreenstein : airlight::DefaultScene {
    static constexpr int mie_phase = airlight::phase_henyey_greenstein;
};
struct Fog : airlight::DefaultScene {
    static constexpr int mie_phase = airlight::phase_fog;
};
struct NoShadow : airlight::DefaultScene {
    static constexpr bool planet_shadow = false;
};
struct LorentzianHenyeyGreenstein : Lorentzian {
    static constexpr int mie_phase = airlight::phase_henyey_greenstein;
};
/// Molecules only, and no ground sphere.
struct Bare : NoMie {
    static constexpr int ozone = airlight::ozone_none;
    static constexpr bool planet_shadow = false;
};
/// More or fewer nodes than by default; 3 is no rule of Gauss and gets the midpoint rule.
template <int Count>
struct Nodes : airlight::DefaultScene {
    static constexpr int nodes = Count;
};

}  // namespace airlight_test
