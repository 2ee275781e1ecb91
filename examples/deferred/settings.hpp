#pragma once

#include <string>
#include <vector>

namespace deferred {

/// How light shafts are drawn.
enum class Shafts { none, march, epipolar, reference };

/// Their names on the command line, in that order.
inline const std::vector<std::string>& shaft_names() {
    static const std::vector<std::string> names = {"none", "march", "epipolar", "reference"};
    return names;
}

/// What a picture is drawn with, apart from its camera, sun and world: every switch of the renderer.
struct Settings {
    bool air = true;
    bool shadows = true;
    bool objects = false;  ///< slabs and an arch in the valley, a station and a ball in orbit
    bool clouds = false;
    bool stars = false;
    bool moon = false;              ///< the moon's disc, and surfaces and air in its light
    double moon_elevation = 35;     ///< [degrees] above the horizontal under the camera
    double moon_azimuth = 120;      ///< [degrees] clockwise from north
    bool ambient_occlusion = true;  ///< surfaces hide some of the sky from each other
    bool cascade_colors = false;    ///< each cascade's ground in a colour of its own
    bool phong = false;             ///< the glint of surfaces after Phong, else of microfacets
    bool lommel_seeliger = false;   ///< ground after Lommel and Seeliger, else after Lambert
    Shafts shafts = Shafts::none;
    int shaft_pieces = 12;      ///< stretches of a ray between which the air's light is interpolated
    int shaft_looks = 8;        ///< looks at the shadow map in each
    int reference_steps = 800;  ///< even steps of a ray, when a reference is asked for
    int shaft_slices = 512;     ///< half planes through eye and sun, when epipolar
    int shaft_samples = 512;    ///< rays in each
    bool half_shafts = false;   ///< at half the resolution, then brought up along edges of depth
    int shadow_size = 2048;     ///< texels of a cascade each way
    bool bloom = true;          ///< a share of the light spreads, as in an eye
    bool flare = false;         ///< ghosts of the sun, as in a lens
    bool use_exposure = true;   ///< 1 - exp(-k c), else k c cut at 1
    bool use_gamma = true;      ///< encode as sRGB, else leave linear
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
        {"--objects", "Slabs and an arch in the valley, a station in orbit", &settings.objects},
        {"--clouds", "A layer of clouds 1800 m high", &settings.clouds},
        {"--stars", "A field of stars behind the air", &settings.stars},
        {"--moon", "The moon, and what it lights", &settings.moon},
        {"--ambient-occlusion", "Surfaces hide some of the sky from each other", &settings.ambient_occlusion},
        {"--cascade-colors", "Each shadow map's ground in a colour of its own", &settings.cascade_colors},
        {"--half-shafts", "Light shafts at half the resolution", &settings.half_shafts},
        {"--bloom", "A share of the light spreads in the PNG, as in an eye", &settings.bloom},
        {"--flare", "Ghosts of the sun in the PNG, as in a lens", &settings.flare},
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
        {"--shaft-slices", "Half planes through eye and sun, when epipolar", &settings.shaft_slices, 2, 8192,
         1024},
        {"--shaft-samples", "Rays in each of them", &settings.shaft_samples, 2, 8192, 1024},
        {"--shadow-size", "Texels of each shadow map each way", &settings.shadow_size, 16, 8192, 4096},
    };
}

}  // namespace deferred
