#include "difference.hpp"

namespace deferred {

DifferencePass::DifferencePass(int width, int height) : width_(width), height_(height) {
    program_ = read_screen_program("difference.frag");
    colors_ = support::create_texture(GL_RGBA8, width, height);
    target_ = make_target({colors_});
}

void DifferencePass::draw(GLuint radiance, GLuint reference, float floor, const DifferenceScale& scale) {
    const support::Uniforms program(program_);
    program.set("radiance_texture", 0);
    program.set("reference_texture", 1);
    program.set("floor_radiance", floor);
    program.set("blue_at", scale.blue_at);
    program.set("decades", scale.decades);
    bind_texture(0, radiance);
    bind_texture(1, reference);
    draw_screen(target_, width_, height_);
}

}  // namespace deferred
