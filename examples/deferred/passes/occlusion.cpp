#include "occlusion.hpp"

namespace deferred {

OcclusionPass::OcclusionPass(int width, int height) : width_(width), height_(height) {
    horizons_program_ = read_screen_program("occlusion_horizons.frag");
    mean_program_ = read_screen_program("occlusion_mean.frag");
    noisy_ = support::create_texture(GL_R16F, width, height);
    share_ = support::create_texture(GL_R16F, width, height);
    noisy_target_ = make_target({noisy_});
    share_target_ = make_target({share_});
}

void OcclusionPass::draw(GLuint depth, GLuint normal) {
    bind_texture(0, depth);
    bind_texture(1, normal);
    bind_texture(2, noisy_);
    const support::Uniforms horizons(horizons_program_);
    horizons.set("depth_texture", 0);
    horizons.set("normal_texture", 1);
    draw_screen(noisy_target_, width_, height_);

    const support::Uniforms mean(mean_program_);
    mean.set("depth_texture", 0);
    mean.set("normal_texture", 1);
    mean.set("share_texture", 2);
    draw_screen(share_target_, width_, height_);
}

}  // namespace deferred
