#include "air.hpp"

namespace deferred {

AirPass::AirPass(const World& world, const GpuTables& tables, int width, int height, bool clouds)
    : tables_(tables), width_(width), height_(height) {
    program_ = read_screen_program(
        "air.frag", scene_defines(world) + tables.defines() + (clouds ? "#define CLOUDS\n" : ""));
    radiance_ = support::create_texture(GL_RGBA32F, width, height);
    target_ = make_target({radiance_});
}

void AirPass::draw(const SurfacePass& surfaces, const LightingPass& lighting, GLuint lost,
                   const std::optional<CloudPass>& clouds) {
    const support::Uniforms program(program_);
    program.set("depth_texture", 0);
    program.set("behind_texture", 1);
    program.set("lost_texture", 2);
    program.set("any_lost", int(lost != 0));
    bind_texture(0, surfaces.depth());
    bind_texture(1, lighting.radiance());
    bind_texture(2, lost);
    if (clouds) {
        program.set("cloud_texture", 3);
        program.set("cloud_distance_texture", 4);
        bind_texture(3, clouds->light());
        bind_texture(4, clouds->distance());
    }
    tables_.bind(program);
    draw_screen(target_, width_, height_);
}

}  // namespace deferred
