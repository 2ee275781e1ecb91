#include "clouds.hpp"

namespace deferred {

CloudPass::CloudPass(const World& world, const GpuTables& tables, int width, int height)
    : tables_(tables), width_(width), height_(height) {
    program_ = read_screen_program("clouds.frag", scene_defines(world) + tables.defines());
    light_ = support::create_texture(GL_RGBA32F, width, height);
    distance_ = support::create_texture(GL_R32F, width, height);
    target_ = make_target({light_, distance_});
}

void CloudPass::draw(const SurfacePass& surfaces) {
    const support::Uniforms program(program_);
    program.set("depth_texture", 0);
    bind_texture(0, surfaces.depth());
    tables_.bind(program);
    draw_screen(target_, width_, height_);
}

}  // namespace deferred
