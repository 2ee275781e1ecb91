#include "visibility.hpp"

namespace deferred {

VisibilityPass::VisibilityPass(int width, int height, bool clouds) : width_(width), height_(height) {
    program_ = read_screen_program("visibility.frag", clouds ? "#define CLOUDS\n" : "");
    shares_ = support::create_texture(GL_RGBA16F, width, height);
    target_ = make_target({shares_});
}

void VisibilityPass::draw(const SurfacePass& surfaces, const ShadowPass& shadows) {
    const support::Uniforms program(program_);
    program.set("depth_texture", 0);
    program.set("normal_texture", 1);
    bind_texture(0, surfaces.depth());
    bind_texture(1, surfaces.normal());
    shadows.bind(program, 2);
    draw_screen(target_, width_, height_);
}

}  // namespace deferred
