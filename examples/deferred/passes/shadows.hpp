#pragma once

#include <array>

#include "blocks.hpp"
#include "geometry.hpp"
#include "pass.hpp"
#include "terrain.hpp"
#include "view.hpp"

namespace deferred {

inline constexpr int cascade_count = 4;

/// One shadow map's place: a point relative to the camera lies at (across, up, depth) of it, each the dot
/// product of (point, 1) with one of these, in [0, 1] where the map covers it.
struct Cascade {
    glm::vec4 across;
    glm::vec4 up;
    glm::vec4 depth;
    glm::vec4 texel;  ///< [m] width of a texel; the others unused
};

/// The block `ShadowBlock`.
struct ShadowBlock {
    std::array<Cascade, cascade_count> cascades;
    float range;  ///< [m] from the camera; beyond it nothing is shaded by a map
    int on;
};

/// Where the cascades lie: boxes along the sunlight around ever longer stretches of what the camera sees,
/// none wider than the landscape. They move in whole texels, so that shadows do not swim when the camera
/// does.
std::array<Cascade, cascade_count> cascades_of(const View& view, double landscape_radius, int size);

/// Cascaded shadow maps of the landscape, seen along the sunlight.
class ShadowPass {
  public:
    ShadowPass(const Terrain& terrain, int size);

    /// Draws the maps, or when off only says that there are none.
    void draw(const View& view, const Geometry& geometry, bool on);

    /// For shaders that include shadows.glsl: the maps as `shadow_maps`, at this texture unit.
    void bind(const support::Uniforms& program, int unit) const;

    /// For shaders that include shadows_nearest.glsl: the same as plain depths, `shadow_heights`.
    void bind_heights(const support::Uniforms& program, int unit) const;

    /// How far from the camera the maps are asked [m].
    double range() const {
        return range_;
    }

  private:
    double landscape_radius_;
    double range_ = 0;
    int size_;
    support::Texture maps_;
    support::Texture heights_;  // the maps without comparison
    std::array<support::Framebuffer, cascade_count> targets_;
    support::Program program_;
    BlockBuffer<ShadowBlock> block_;
};

}  // namespace deferred
