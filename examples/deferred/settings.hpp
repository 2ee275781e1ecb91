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
    bool objects = false;  ///< slabs and an arch in the valley, a station and a ball in orbit
    bool clouds = false;
    bool stars = false;
    bool moon = false;             ///< the moon's disc, and surfaces and air in its light
    double moon_elevation = 35;    ///< [degrees] above the horizontal under the camera
    double moon_azimuth = 120;     ///< [degrees] clockwise from north
    bool ambient_occlusion = true;  ///< surfaces hide some of the sky from each other
    bool cascade_colors = false;    ///< each cascade's ground in a colour of its own
    bool phong = false;             ///< the glint of surfaces after Phong, else of microfacets
    bool lommel_seeliger = false;   ///< ground after Lommel and Seeliger, else after Lambert
    Shafts shafts = Shafts::none;
    int shaft_pieces = 12;     ///< stretches of a ray between which the air's light is interpolated
    int shaft_looks = 8;       ///< looks at the shadow map in each
    bool half_shafts = false;  ///< at half the resolution, then brought up along edges of depth
    int shadow_size = 2048;    ///< texels of a cascade each way
    bool bloom = true;         ///< a share of the light spreads, as in an eye
    bool flare = false;        ///< ghosts of the sun, as in a lens
    bool use_exposure = true;  ///< 1 - exp(-k c), else k c cut at 1
    bool use_gamma = true;     ///< encode as sRGB, else leave linear
};

}  // namespace deferred
