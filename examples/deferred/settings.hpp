#pragma once

#include <string>
#include <vector>

namespace deferred {

/// How light shafts are drawn.
enum class Shafts { none, march };

/// Their names on the command line, in that order.
inline const std::vector<std::string>& shaft_names() {
    static const std::vector<std::string> names = {"none", "march"};
    return names;
}

/// What a picture is drawn with, apart from its camera, sun and world: every switch of the renderer.
struct Settings {
    bool air = true;
    bool shadows = true;
    bool cascade_colors = false;   ///< each cascade's ground in a colour of its own
    bool phong = false;            ///< the glint of surfaces after Phong, else of microfacets
    bool lommel_seeliger = false;  ///< ground after Lommel and Seeliger, else after Lambert
    Shafts shafts = Shafts::none;
    int shaft_pieces = 12;     ///< stretches of a ray between which the air's light is interpolated
    int shaft_looks = 8;       ///< looks at the shadow map in each
    bool half_shafts = false;  ///< at half the resolution, then brought up along edges of depth
    int shadow_size = 2048;    ///< texels of a cascade each way
    bool use_exposure = true;  ///< 1 - exp(-k c), else k c cut at 1
    bool use_gamma = true;     ///< encode as sRGB, else leave linear
};

/// Something that is on or off: an option of the command line and a box in the window.
struct Switch {
    std::string option;
    std::string help;
    bool* value;
    std::string word = {};
};

inline std::vector<Switch> switches_of(Settings& settings) {
    return {
        {"--air", "The air, its light and what it takes from light", &settings.air},
        {"--shadows", "The landscape's shadow", &settings.shadows},
        {"--cascade-colors", "Each shadow map's ground in a colour of its own", &settings.cascade_colors},
        {"--half-shafts", "Light shafts at half the resolution", &settings.half_shafts},
        {"--use-exposure", "1 - exp(-exposure x) in the PNG, else exposure x cut at 1",
         &settings.use_exposure},
        {"--use-gamma", "The PNG encoded as sRGB, else linear", &settings.use_gamma},
    };
}

/// A whole number: an option of the command line and a slider in the window.
struct Count {
    std::string option;
    std::string help;
    int* value;
    int least;
    int most;  ///< of the option; the slider ends at
    int slider_most;
};

inline std::vector<Count> counts_of(Settings& settings) {
    return {
        {"--shaft-pieces", "Stretches of a ray at whose ends the air's light is computed",
         &settings.shaft_pieces, 1, 1000, 64},
        {"--shaft-looks", "Looks at the shadow maps in each", &settings.shaft_looks, 1, 1000, 64},
        {"--shadow-size", "Texels of each shadow map each way", &settings.shadow_size, 16, 8192, 4096},
    };
}

}  // namespace deferred
