#pragma once

#include <functional>
#include <string>
#include <vector>

#include <airlight/tables/bruneton.hpp>
#include <airlight/tables/diffuse.hpp>
#include <airlight/tables/hillaire.hpp>
#include <airlight/tables/inscatter.hpp>
#include <airlight/tables/transmittance.hpp>

#include "support/gl_objects.hpp"
#include "support/uniforms.hpp"
#include "world.hpp"

// Where the light that single_scattering does not have comes from, on the CPU; shaders/tables.glsl says the
// same for the GPU.

namespace deferred {

/// What --tables may be, in the order of the shaders' numbers.
enum class TableKind { none, transmittance, inscatter3d, hillaire, bruneton, diffuse };

/// Their names on the command line, in that order.
const std::vector<std::string>& table_names();

/// The tables of one kind; the others are empty.
struct AirTables {
    TableKind kind;
    airlight::Table<airlight::vec2<float>> slants;
    airlight::Table<airlight::vec3<float>> hillaire;
    airlight::DiffuseTable<float> diffuse;
    airlight::InscatterShape<float> inscatter_shape;
    airlight::BrunetonShape<float> bruneton_shape;
    airlight::ScatteringTables<float> scattering;
};

/// Bakes what the kind needs, on all cores and with a bar for what takes long; or, with `tell`, without a
/// bar: it gets the share that is done, from several threads, and answers false to give up.
AirTables bake_tables(TableKind kind, const World& world,
                      const std::function<bool(double share)>& tell = nullptr);

/// The same on the GPU, for shaders/tables.glsl: textures in the order of its samplers.
class GpuTables {
  public:
    explicit GpuTables(const AirTables& tables);
    void bind(const support::Uniforms& program) const;

    /// What the shaders are compiled with.
    std::string defines() const;

  private:
    TableKind kind_;
    glm::ivec4 scattering_size_;  // of the table of four dimensions
    std::vector<support::Texture> textures_;
};

}  // namespace deferred
