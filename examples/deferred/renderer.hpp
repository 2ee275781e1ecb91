#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gpu_picture.hpp"
#include "passes/air.hpp"
#include "passes/bloom.hpp"
#include "passes/clouds.hpp"
#include "passes/epipolar.hpp"
#include "passes/flare.hpp"
#include "passes/geometry.hpp"
#include "passes/lighting.hpp"
#include "passes/occlusion.hpp"
#include "passes/shadows.hpp"
#include "passes/shafts.hpp"
#include "passes/stars.hpp"
#include "passes/surfaces.hpp"
#include "passes/timer.hpp"
#include "passes/tone.hpp"
#include "passes/visibility.hpp"
#include "settings.hpp"
#include "tables.hpp"
#include "terrain.hpp"
#include "view.hpp"
#include "world.hpp"

namespace deferred {

/// Draws a world and its landscape: a list of passes, each with a file of its own in passes/. Needs an OpenGL
/// 4.3 context that is current. Made for the clouds, the kind of shafts and their resolution, the objects and
/// the shadow maps' size of its settings; all else may be drawn otherwise each time.
class Renderer {
  public:
    Renderer(const World& world, const AirTables& tables, const Terrain& terrain, const Settings& settings,
             int width, int height);

    /// All passes but those of lens and display.
    void draw(const View& view, const Settings& settings);

    /// What draw() left, with its G-buffer.
    GpuPicture read() const;

    /// The last passes: what draw() left, with bloom and flare, as bytes of a display, 3 per pixel, the lower
    /// row first.
    std::vector<std::uint8_t> display(const Settings& settings, float exposure);

    /// The last pass into a framebuffer of this size, 0 for the window's, stretched to fill it.
    void show(const Settings& settings, float exposure, GLuint framebuffer, int width, int height);

    /// Other tables of the same kind.
    void use(const AirTables& tables);

    int width() const {
        return width_;
    }
    int height() const {
        return height_;
    }
    GLuint radiance() const {
        return air_.radiance();
    }  ///< the texture that draw() left
    PassTimers& timers() {
        return timers_;
    }

  private:
    void encode(const Settings& settings, float exposure);

    const World& world_;
    int width_;
    int height_;
    BlockBuffer<AtmosphereBlock> atmosphere_block_;
    BlockBuffer<Frame> frame_block_;
    GpuTables tables_;
    Geometry geometry_;
    ShadowPass shadows_;
    SurfacePass surfaces_;
    StarPass stars_;
    OcclusionPass occlusion_;
    VisibilityPass visibility_;
    LightingPass lighting_;
    std::optional<CloudPass> clouds_;
    std::optional<ShaftPass> shafts_;
    std::optional<EpipolarPass> epipolar_;
    AirPass air_;
    BloomPass bloom_;
    FlarePass flare_;
    TonePass tone_;
    mutable PassTimers timers_;
    GLuint lost_ = 0;  // texture of light that shadows keep from the air, 0 for none
};

}  // namespace deferred
