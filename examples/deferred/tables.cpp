#include "tables.hpp"

#include <epoxy/gl.h>

#include <cstddef>

#include "support/gl_table.hpp"
#include "support/rows.hpp"
#include "support/table_file.hpp"

namespace deferred {
namespace {

// Of the diffuse table: docs/tables.md has its errors by size.
constexpr int diffuse_width = 64;
constexpr int diffuse_height = 16;
constexpr int diffuse_orders = 5;
constexpr int hillaire_size = 32;
constexpr int scattering_orders = 4;
// The passes bind their own textures below it.
constexpr int first_table_unit = 8;

template <typename Scene>
AirTables baked(TableKind kind, const airlight::Atmosphere<float>& air,
                const std::function<bool(double)>& tell) {
    const auto rows_of = [&](const char* name) {
        return tell ? support::Rows(tell) : support::Rows(std::string(name));
    };
    AirTables out{};
    out.kind = kind;
    out.inscatter_shape.atmosphere = out.bruneton_shape.atmosphere = air;
    out.inscatter_shape.lowest_sun = out.bruneton_shape.lowest_sun = airlight::lowest_sun_cosine(air);
    if (kind == TableKind::transmittance) {
        out.slants = airlight::bake_slants<float, Scene>(air);
    } else if (kind == TableKind::hillaire) {
        out.hillaire = airlight::bake_hillaire<float, Scene>(air, hillaire_size, hillaire_size, {},
                                                             rows_of("Hillaire's table"));
    } else if (kind == TableKind::diffuse) {
        const support::Rows rows = rows_of("diffuse table");
        rows.expect_passes(diffuse_orders);
        out.diffuse = airlight::bake_diffuse_table<float, Scene>(air, diffuse_width, diffuse_height,
                                                                 diffuse_orders, rows);
    } else if (kind == TableKind::inscatter3d || kind == TableKind::bruneton) {
        // Half of Bruneton's texels along the view and the altitude: half a minute instead of minutes.
        out.bruneton_shape.views = 64;
        out.bruneton_shape.altitudes = 16;
        const support::Rows rows =
            rows_of(kind == TableKind::bruneton ? "table of four dimensions" : "table of three dimensions");
        rows.expect_passes(airlight::passes_of_bake(scattering_orders));
        out.scattering = kind == TableKind::bruneton
                             ? airlight::bake_scattering<Scene>(out.bruneton_shape, scattering_orders, rows)
                             : airlight::bake_scattering<Scene>(out.inscatter_shape, scattering_orders, rows);
    }
    return out;
}

template <typename Texel>
support::Texture texture_of(const airlight::Table<Texel>& table) {
    const support::TableSize size{table.width, table.height, table.depth};
    support::Texture texture = support::create_table_texture(GL_RGBA32F, size);
    support::upload_table(texture, size, support::numbers_of(table), Texel::length());
    return texture;
}

}  // namespace

const std::vector<std::string>& table_names() {
    static const std::vector<std::string> names = {"none",     "transmittance", "inscatter3d",
                                                   "hillaire", "bruneton",      "diffuse"};
    return names;
}

AirTables bake_tables(TableKind kind, const World& world, const std::function<bool(double)>& tell) {
    return world.lorentzian_ozone ? baked<LorentzianScene>(kind, world.atmosphere, tell)
                                  : baked<airlight::DefaultScene>(kind, world.atmosphere, tell);
}

GpuTables::GpuTables(const AirTables& tables)
    : kind_(tables.kind),
      scattering_size_(tables.bruneton_shape.nus, tables.bruneton_shape.suns, tables.bruneton_shape.height(),
                       tables.bruneton_shape.altitudes) {
    if (tables.kind == TableKind::transmittance) {
        textures_.push_back(texture_of(tables.slants));
    } else if (tables.kind == TableKind::hillaire) {
        textures_.push_back(texture_of(tables.hillaire));
    } else if (tables.kind == TableKind::diffuse) {
        textures_.push_back(texture_of(tables.diffuse.texels));
    } else if (tables.kind != TableKind::none) {
        textures_.push_back(texture_of(tables.scattering.rayleigh));
        textures_.push_back(texture_of(tables.scattering.mie));
        textures_.push_back(texture_of(tables.scattering.multiple));
    }
}

void GpuTables::bind(const support::Uniforms& program) const {
    for (std::size_t i = 0; i < textures_.size(); ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + first_table_unit + int(i)));
        glBindTexture(GL_TEXTURE_3D, textures_[i]);
        program.set("table_" + std::to_string(i), first_table_unit + int(i));
    }
    program.set("scattering_size", scattering_size_);
}

std::string GpuTables::defines() const {
    return "#define TABLES " + std::to_string(int(kind_)) + "\n";
}

}  // namespace deferred
