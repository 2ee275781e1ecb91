#include "stars.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <airlight/color.hpp>
#include <airlight/constants.hpp>

namespace deferred {
namespace {

struct Star {
    glm::vec3 direction;
    glm::vec3 light;  // of a star of magnitude 0
};

/// The same numbers on every machine, in [0, 1).
class Chance {
  public:
    double next() {
        state_ += 0x9e3779b9u;
        std::uint32_t x = state_;
        x = (x ^ (x >> 16)) * 0x7feb352du;
        x = (x ^ (x >> 15)) * 0x846ca68bu;
        return double(x ^ (x >> 16)) / 4294967296.0;
    }

  private:
    std::uint32_t state_ = 1;
};

std::vector<Star> star_field() {
    // Real sky: 9000 stars down to magnitude 6.5, each magnitude 3.3 times as many as the one before.
    constexpr int count = 20000;
    constexpr double decades_per_magnitude = 0.516;
    constexpr double brighter_than_0 = 4.2;
    Chance chance;
    std::vector<Star> stars;
    for (int i = 0; i < count; ++i) {
        const double z = 2 * chance.next() - 1;
        const double azimuth = 2 * airlight::pi<double> * chance.next();
        const double level = std::sqrt(1 - z * z);
        const double magnitude = std::log10((i + 1) / brighter_than_0) / decades_per_magnitude;
        // From reddish to bluish, as bright all the same.
        const float cool = float(chance.next() - 0.5);
        const glm::vec3 tint(1 + 0.7f * cool, 1, 1 - 0.9f * cool);
        const float light = float(std::pow(10, -0.4 * magnitude));
        stars.push_back(Star{glm::vec3(glm::dvec3(level * std::cos(azimuth), level * std::sin(azimuth), z)),
                             light / airlight::luminance(tint) * tint});
    }
    return stars;
}

}  // namespace

StarPass::StarPass(int width, int height) : width_(width), height_(height) {
    const std::vector<Star> stars = star_field();
    count_ = int(stars.size());
    program_ = read_program("star.vert", "star.frag", clip_define());
    buffer_ = support::create_buffer();
    array_ = support::create_vertex_array();
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(stars.size() * sizeof(Star)), stars.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(Star),
                              reinterpret_cast<const void*>(i * offsetof(Star, light)));
    }
    glBindVertexArray(0);
}

void StarPass::draw(GLuint target) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, width_, height_);
    glUseProgram(program_);
    // They lie at depth 0, infinitely far, and leave it there.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(array_);
    glDrawArrays(GL_POINTS, 0, count_);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    glDisable(GL_PROGRAM_POINT_SIZE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
}

}  // namespace deferred
