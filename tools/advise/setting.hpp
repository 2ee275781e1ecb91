#pragma once

#include <airlight/scene.hpp>

namespace advise {

/// The flags of a Scene, chosen while the program runs.
struct Setting {
    bool mie = true;
    int ozone = airlight::ozone_tent;
    int mie_phase = airlight::phase_cornette_shanks;
    bool planet_shadow = true;
    int nodes = 24;
};

}  // namespace advise
