#include "lighting.hpp"

namespace deferred {

LightingPass::LightingPass(const World& world, const GpuTables& tables, int width, int height)
    : tables_(tables), width_(width), height_(height) {
    program_ = read_screen_program("lighting.frag", scene_defines(world) + tables.defines());
    radiance_ = support::create_texture(GL_RGBA32F, width, height);
    target_ = make_target({radiance_});
}

void LightingPass::draw(const SurfacePass& surfaces, const VisibilityPass& visibility) {
    const support::Uniforms program(program_);
    program.set("depth_texture", 0);
    program.set("albedo_texture", 1);
    program.set("normal_texture", 2);
    program.set("shares_texture", 3);
    bind_texture(0, surfaces.depth());
    bind_texture(1, surfaces.albedo());
    bind_texture(2, surfaces.normal());
    bind_texture(3, visibility.shares());
    tables_.bind(program);
    draw_screen(target_, width_, height_);
}

}  // namespace deferred
