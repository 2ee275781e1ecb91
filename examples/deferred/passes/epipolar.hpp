#pragma once

#include "blocks.hpp"
#include "pass.hpp"
#include "settings.hpp"
#include "shadows.hpp"
#include "surfaces.hpp"
#include "world.hpp"

namespace deferred {

/// The block `EpipolarBlock` of shaders/epipolar.glsl.
struct EpipolarBlock {
    alignas(16) vec3 slice_x;
    float first_slice;
    alignas(16) vec3 slice_y;
    float slice_range;
    float first_angle;
    float angle_range;
    float columns_end;
    int whole_circle;
    int slices;
    int samples;
    int columns;
};

static_assert(offsetof(EpipolarBlock, first_slice) == 12 && offsetof(EpipolarBlock, slice_y) == 16 &&
                  offsetof(EpipolarBlock, first_angle) == 32 && offsetof(EpipolarBlock, slices) == 48,
              "EpipolarBlock must lie as std140 has it, see shaders/epipolar.glsl");

/// The slices and angles that a camera sees.
EpipolarBlock epipolar_block(const Frame& frame, double columns_end, int slices, int samples, int columns);

/// Light shafts by epipolar sampling, after Engelhardt and Dachsbacher (2010) and Yusov (2013): rays in half
/// planes that hold the eye and the sun. In such a slice what shades the air is a height over a distance, and
/// a tree of least and greatest heights tells for a whole stretch of a ray that it is lit or dark. Pixels
/// take the light of the rays around them; where depth breaks they get a ray of their own.
class EpipolarPass {
  public:
    EpipolarPass(const World& world, const Settings& settings, int width, int height);

    void draw(const View& view, const SurfacePass& surfaces, const ShadowPass& shadows,
              const Settings& settings);

    GLuint lost() const {
        return lost_;
    }

  private:
    int width_;
    int height_;
    int slices_;
    int samples_;
    int columns_;
    support::Texture tree_;       // least and greatest height: all levels side by side, a slice a row
    support::Texture half_tree_;  // a level is read from one and written to the other
    support::Texture marched_;
    support::Texture lost_;
    support::Framebuffer tree_target_;
    support::Framebuffer half_tree_target_;
    support::Framebuffer marched_target_;
    support::Framebuffer lost_target_;
    support::Program heights_program_;
    support::Program tree_program_;
    support::Program march_program_;
    support::Program gather_program_;
    BlockBuffer<EpipolarBlock> block_;
};

}  // namespace deferred
