#pragma once

#include <string>
#include <vector>

#include <airlight/airlight.hpp>

namespace deferred {

/// A planet that a picture can be made of.
struct World {
    std::string name;
    airlight::Atmosphere<float> atmosphere;
    bool lorentzian_ozone;  ///< compile with ozone_lorentzian instead of ozone_tent
    bool vegetated;         ///< forests and seas, or bare ground of the atmosphere's ground_albedo
    int nodes = airlight::DefaultScene::nodes;  ///< of the shaders; the CPU has those of DefaultScene
};

/// What Scene::nodes may be.
inline const std::vector<int>& node_counts() {
    static const std::vector<int> counts = {4, 5, 6, 8, 10, 12, 16, 24};
    return counts;
}

/// The scene flags of worlds with lorentzian_ozone; the others use airlight::DefaultScene.
struct LorentzianScene : airlight::DefaultScene {
    static constexpr int ozone = airlight::ozone_lorentzian;
};

/// What the shaders of a world are compiled with.
inline std::string scene_defines(const World& world) {
    return "#define AIRLIGHT_NODES " + std::to_string(world.nodes) + "\n" +
           (world.lorentzian_ozone ? "#define AIRLIGHT_OZONE AIRLIGHT_OZONE_LORENTZIAN\n" : "");
}

inline const std::vector<World>& worlds() {
    static const std::vector<World> all = {
        {"earth", airlight::earth<float>(), false, true},
        {"cs562", airlight::cs562_earth<float>(), false, true},
        {"elek", airlight::elek_earth<float>(), false, true},
        {"leenman", airlight::leenman_earth<float>(), true, true},
        {"mars", airlight::mars<float>(), false, false},
    };
    return all;
}

}  // namespace deferred
