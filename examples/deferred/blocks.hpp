#pragma once

#include <cstddef>

#include <airlight/atmosphere.hpp>
#include <airlight/types.hpp>

#include "support/gl_objects.hpp"

// What the shaders get as std140 uniform blocks, byte by byte.

namespace deferred {

/// Which binding point has which block.
enum class Block { atmosphere, frame, shadows, epipolar };

/// airlight_Atmosphere as std140 has it: a vec3 on 16 bytes, the scalars after it where there is room.
struct AtmosphereBlock {
    float ground_radius;
    float top_altitude;
    alignas(16) airlight::vec3<float> rayleigh_scattering;
    float rayleigh_scale_height;
    alignas(16) airlight::vec3<float> mie_scattering;
    alignas(16) airlight::vec3<float> mie_absorption;
    float mie_scale_height;
    float mie_g;
    alignas(16) airlight::vec3<float> ozone_absorption;
    float ozone_altitude;
    float ozone_half_width;
    alignas(16) airlight::vec3<float> ground_albedo;

    explicit AtmosphereBlock(const airlight::Atmosphere<float>& a)
        : ground_radius(a.ground_radius),
          top_altitude(a.top_altitude),
          rayleigh_scattering(a.rayleigh_scattering),
          rayleigh_scale_height(a.rayleigh_scale_height),
          mie_scattering(a.mie_scattering),
          mie_absorption(a.mie_absorption),
          mie_scale_height(a.mie_scale_height),
          mie_g(a.mie_g),
          ozone_absorption(a.ozone_absorption),
          ozone_altitude(a.ozone_altitude),
          ozone_half_width(a.ozone_half_width),
          ground_albedo(a.ground_albedo) {}
};

static_assert(offsetof(AtmosphereBlock, rayleigh_scattering) == 16 &&
                  offsetof(AtmosphereBlock, rayleigh_scale_height) == 28 &&
                  offsetof(AtmosphereBlock, mie_scattering) == 32 &&
                  offsetof(AtmosphereBlock, mie_absorption) == 48 &&
                  offsetof(AtmosphereBlock, mie_scale_height) == 60 &&
                  offsetof(AtmosphereBlock, mie_g) == 64 &&
                  offsetof(AtmosphereBlock, ozone_absorption) == 80 &&
                  offsetof(AtmosphereBlock, ozone_altitude) == 92 &&
                  offsetof(AtmosphereBlock, ozone_half_width) == 96 &&
                  offsetof(AtmosphereBlock, ground_albedo) == 112 && sizeof(AtmosphereBlock) == 128,
              "AtmosphereBlock must lie as std140 has airlight_Atmosphere");

/// A block's bytes on the GPU, at its binding point.
template <typename Bytes>
class BlockBuffer {
  public:
    explicit BlockBuffer(Block block) : block_(block), buffer_(support::create_buffer()) {}

    void bind() const {
        glBindBufferBase(GL_UNIFORM_BUFFER, GLuint(block_), buffer_);
    }

    void upload(const Bytes& bytes) const {
        bind();
        glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(sizeof(Bytes)), &bytes, GL_DYNAMIC_DRAW);
    }

  private:
    Block block_;
    support::Buffer buffer_;
};

}  // namespace deferred
