#pragma once

#include <airlight/scene.hpp>
#include <vector>

namespace advise {

/// The flags of a Scene, chosen while the program runs.
struct Setting {
    bool mie = true;
    int ozone = airlight::ozone_tent;
    int mie_phase = airlight::phase_cornette_shanks;
    bool planet_shadow = true;
    int nodes = 24;
};

/// Every number of nodes that a Scene may have, ascending; the last is the reference's.
inline const std::vector<int>& node_counts() {
    static const std::vector<int> all = {4, 5, 6, 8, 10, 12, 16, 24};
    return all;
}

}  // namespace advise
