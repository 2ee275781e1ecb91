#include "tone.hpp"

namespace deferred {

TonePass::TonePass(int width, int height) : width_(width), height_(height) {
    program_ = read_screen_program("tone.frag");
    encoded_ = support::create_texture(GL_RGBA8, width, height);
    target_ = make_target({encoded_});
}

void TonePass::draw(GLuint radiance, GLuint shares, const BloomPass& bloom, const FlarePass& flare,
                    const Settings& settings, float exposure) {
    const support::Uniforms program(program_);
    program.set("radiance_texture", 0);
    program.set("shares_texture", 1);
    program.set("glow_texture", 2);
    program.set("flare_texture", 3);
    program.set("glow_share", settings.bloom ? BloomPass::share : 0.0f);
    program.set("any_flare", int(settings.flare));
    program.set("exposure", exposure);
    program.set("use_exposure", int(settings.use_exposure));
    program.set("use_gamma", int(settings.use_gamma));
    program.set("cascade_colors", int(settings.cascade_colors && settings.shadows));
    bind_texture(0, radiance);
    bind_texture(1, shares);
    bind_texture(2, bloom.glow());
    bind_texture(3, flare.radiance());
    draw_screen(target_, width_, height_);
}

std::vector<std::uint8_t> TonePass::read() const {
    std::vector<std::uint8_t> bytes(3 * std::size_t(width_) * std::size_t(height_));
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
}

}  // namespace deferred
