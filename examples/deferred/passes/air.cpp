#include "air.hpp"

namespace deferred {

AirPass::AirPass(const World& world, const GpuTables& tables, int width, int height)
    : tables_(tables), width_(width), height_(height) {
    program_ = read_screen_program("air.frag", scene_defines(world) + tables.defines());
    radiance_ = support::create_texture(GL_RGBA32F, width, height);
    target_ = make_target({radiance_});
}

void AirPass::draw(const SurfacePass& surfaces, const LightingPass& lighting, GLuint lost) {
    const support::Uniforms program(program_);
    program.set("depth_texture", 0);
    program.set("behind_texture", 1);
    program.set("lost_texture", 2);
    program.set("any_lost", int(lost != 0));
    bind_texture(0, surfaces.depth());
    bind_texture(1, lighting.radiance());
    bind_texture(2, lost);
    tables_.bind(program);
    draw_screen(target_, width_, height_);
}

}  // namespace deferred
