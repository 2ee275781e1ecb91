#include "tone.hpp"

namespace deferred {

TonePass::TonePass(int width, int height) : width_(width), height_(height) {
    program_ = read_screen_program("tone.frag");
    encoded_ = support::create_texture(GL_RGBA8, width, height);
    target_ = make_target({encoded_});
}

void TonePass::draw(GLuint radiance, const VisibilityPass& visibility, const Settings& settings,
                    float exposure) {
    const support::Uniforms program(program_);
    program.set("radiance_texture", 0);
    program.set("shares_texture", 1);
    program.set("exposure", exposure);
    program.set("use_exposure", int(settings.use_exposure));
    program.set("use_gamma", int(settings.use_gamma));
    program.set("cascade_colors", int(settings.cascade_colors && settings.shadows));
    bind_texture(0, radiance);
    bind_texture(1, visibility.shares());
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
