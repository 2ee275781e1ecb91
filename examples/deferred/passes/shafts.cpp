#include "shafts.hpp"

namespace deferred {

ShaftPass::ShaftPass(const World& world, int width, int height, bool half)
    : width_(width),
      height_(height),
      march_width_(half ? (width + 1) / 2 : width),
      march_height_(half ? (height + 1) / 2 : height) {
    march_program_ = read_screen_program("shafts_march.frag", scene_defines(world));
    reference_program_ = read_screen_program("shafts_reference.frag", scene_defines(world));
    gather_program_ = read_screen_program("shafts_gather.frag", scene_defines(world));
    marched_ = support::create_texture(GL_RGBA32F, march_width_, march_height_);
    lost_ = support::create_texture(GL_RGBA32F, width, height);
    marched_target_ = make_target({marched_});
    lost_target_ = make_target({lost_});
}

void ShaftPass::draw(const SurfacePass& surfaces, const ShadowPass& shadows, const Settings& settings) {
    if (settings.shafts == Shafts::reference) {
        const support::Uniforms reference(reference_program_);
        reference.set("depth_texture", 0);
        reference.set("steps", settings.reference_steps);
        bind_texture(0, surfaces.depth());
        shadows.bind(reference, 1);
        draw_screen(lost_target_, width_, height_);
        return;
    }
    const int scale = march_width_ < width_ ? 2 : 1;
    const auto set_up = [&](const support::Uniforms& program) {
        program.set("depth_texture", 0);
        program.set("scale", scale);
        program.set("pieces", settings.shaft_pieces);
        program.set("looks", settings.shaft_looks);
        bind_texture(0, surfaces.depth());
        shadows.bind(program, 1);
    };
    set_up(support::Uniforms(march_program_));
    draw_screen(marched_target_, march_width_, march_height_);

    const support::Uniforms gather(gather_program_);
    set_up(gather);
    gather.set("marched_texture", 2);
    bind_texture(2, marched_);
    draw_screen(lost_target_, width_, height_);
}

}  // namespace deferred
