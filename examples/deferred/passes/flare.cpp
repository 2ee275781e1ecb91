#include "flare.hpp"

namespace deferred {
namespace {

constexpr int most_rows = 256;  // of the level that bright parts are taken from: enough for their edges
constexpr float aperture_of_height = 0.04f;  // radius of the aperture's image

}  // namespace

FlarePass::FlarePass(const BloomPass& bloom) {
    bright_program_ = read_screen_program("flare_bright.frag");
    ghosts_program_ = read_screen_program("flare_ghosts.frag");
    while (bloom.levels()[level_].height > most_rows && level_ + 1 < bloom.levels().size()) {
        ++level_;
    }
    const BloomPass::Level& level = bloom.levels()[level_];
    const BloomPass::Level& half = bloom.levels().front();
    bright_ = support::create_texture(GL_RGBA32F, level.width, level.height);
    set_linear_filter(bright_);
    flare_ = support::create_texture(GL_RGBA32F, half.width, half.height);
    set_linear_filter(flare_);
    bright_target_ = make_target({bright_});
    flare_target_ = make_target({flare_});
}

void FlarePass::draw(const BloomPass& bloom) {
    const BloomPass::Level& level = bloom.levels()[level_];
    const BloomPass::Level& half = bloom.levels().front();
    const support::Uniforms bright(bright_program_);
    bright.set("radiance_texture", 0);
    bright.set("radius", aperture_of_height * float(level.height));
    bind_texture(0, level.reduced);
    draw_screen(bright_target_, level.width, level.height);

    const support::Uniforms ghosts(ghosts_program_);
    ghosts.set("bright_texture", 0);
    ghosts.set("heights", 1.0f / float(half.height));
    ghosts.set("shape", float(half.width) / float(half.height));
    bind_texture(0, bright_);
    draw_screen(flare_target_, half.width, half.height);
}

}  // namespace deferred
