#include "visibility.hpp"

namespace deferred {

VisibilityPass::VisibilityPass(int width, int height, bool clouds) : width_(width), height_(height) {
    program_ = read_screen_program("visibility.frag", clouds ? "#define CLOUDS\n" : "");
    shares_ = support::create_texture(GL_RGBA16F, width, height);
    target_ = make_target({shares_});
}

void VisibilityPass::draw(const SurfacePass& surfaces, const ShadowPass& shadows, GLuint sky_share) {
    const support::Uniforms program(program_);
    program.set("depth_texture", 0);
    program.set("normal_texture", 1);
    program.set("sky_share_texture", 3);
    program.set("any_occlusion", int(sky_share != 0));
    bind_texture(0, surfaces.depth());
    bind_texture(1, surfaces.normal());
    bind_texture(3, sky_share);
    shadows.bind(program, 2);
    draw_screen(target_, width_, height_);
}

}  // namespace deferred
