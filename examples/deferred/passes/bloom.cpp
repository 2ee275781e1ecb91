#include "bloom.hpp"

#include <algorithm>

namespace deferred {
namespace {

constexpr int least_texels = 4;  // of the coarsest level's shorter side: it glows over a third of the picture
constexpr float coarser_weight = 0.5f;  // of a level beside the next finer one

}  // namespace

BloomPass::BloomPass(int width, int height) {
    down_program_ = read_screen_program("bloom_down.frag");
    up_program_ = read_screen_program("bloom_up.frag");
    do {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
        Level level{width, height, {}, {}, {}, {}};
        level.reduced = support::create_texture(GL_RGBA32F, width, height);
        set_linear_filter(level.reduced);
        level.glow = support::create_texture(GL_RGBA32F, width, height);
        level.reduced_target = make_target({level.reduced});
        level.glow_target = make_target({level.glow});
        levels_.push_back(std::move(level));
    } while (std::min(width, height) >= 2 * least_texels);
}

void BloomPass::reduce(GLuint radiance) {
    const support::Uniforms down(down_program_);
    down.set("finer_texture", 0);
    for (const Level& level : levels_) {
        bind_texture(0, radiance);
        draw_screen(level.reduced_target, level.width, level.height);
        radiance = level.reduced;
    }
}

void BloomPass::spread() {
    const support::Uniforms up(up_program_);
    up.set("level_texture", 0);
    up.set("coarser_texture", 1);
    GLuint coarser = levels_.back().reduced;
    float weights = 1;  // of all levels from this one on, beside its own
    for (std::size_t i = levels_.size() - 1; i-- > 0;) {
        const Level& level = levels_[i];
        weights = 1 + coarser_weight * weights;
        up.set("coarser_share", 1 - 1 / weights);
        bind_texture(0, level.reduced);
        bind_texture(1, coarser);
        draw_screen(level.glow_target, level.width, level.height);
        coarser = level.glow;
    }
}

}  // namespace deferred
