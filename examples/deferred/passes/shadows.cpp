#include "shadows.hpp"

#include <algorithm>
#include <cmath>

namespace deferred {
namespace {

constexpr double farthest = 60e3;  // [m] from the camera that shadows of the landscape are looked for

struct Sphere {
    glm::dvec3 centre;  ///< [m] from the camera
    double radius;
};

/// The smallest around the stretch of the view from `nearest` to `end`; its size hangs on the angle of view
/// alone, so that turning the camera changes no texel.
Sphere around_stretch(const Frame& frame, double nearest, double end) {
    const glm::dvec3 across(frame.ray_across);
    const glm::dvec3 up(frame.ray_up);
    const glm::dvec3 forward = glm::normalize(glm::cross(up, across));
    const double half_width = 0.5 * frame.width * glm::length(across);
    const double half_height = 0.5 * frame.height * glm::length(up);
    const double slope = half_width * half_width + half_height * half_height;
    // The point on the axis with the same distance to the near and the far corners, no further than the far
    // end.
    const double middle = std::min(0.5 * (nearest + end) * (1 + slope), end);
    const double radius = std::sqrt((end - middle) * (end - middle) + end * end * slope);
    return Sphere{middle * forward, radius};
}

}  // namespace

std::array<Cascade, cascade_count> cascades_of(const View& view, double landscape_radius, int size) {
    const LightAxes light = mapped_light_axes(view.frame);

    const double length = std::max(farthest, 2 * view.altitude);
    const double first = std::clamp(0.6 * view.above_ground, 60.0, length / 30);
    std::array<Cascade, cascade_count> cascades{};
    double nearest = 0;
    for (int i = 0; i < cascade_count; ++i) {
        const double end = first * std::pow(length / first, double(i) / (cascade_count - 1));
        Sphere sphere = around_stretch(view.frame, nearest, end);
        if (sphere.radius > landscape_radius) {
            sphere = Sphere{-view.position, landscape_radius};
        }
        nearest = 0.9 * end;

        // In whole texels of the landscape's own coordinates.
        const double texel = 2 * sphere.radius / (size - 2);
        const glm::dvec3 middle = view.position + sphere.centre;
        const auto snapped = [&](const glm::dvec3& axis) {
            return std::round(glm::dot(middle, axis) / texel) * texel - glm::dot(view.position, axis);
        };
        const double width = texel * size;
        // Deep enough for the landscape that shades the box and the air behind it.
        const double depth = 2 * (sphere.radius + landscape_radius);
        const double back = glm::dot(sphere.centre, light.to_light) + 0.5 * depth;
        Cascade& cascade = cascades[std::size_t(i)];
        cascade.across =
            glm::vec4(glm::vec3(light.across / width), float(0.5 - snapped(light.across) / width));
        cascade.up = glm::vec4(glm::vec3(light.up / width), float(0.5 - snapped(light.up) / width));
        cascade.depth = glm::vec4(glm::vec3(-light.to_light / depth), float(back / depth));
        cascade.texel = glm::vec4(float(texel), 0, 0, 0);
    }
    return cascades;
}

ShadowPass::ShadowPass(const Terrain& terrain, int size)
    : landscape_radius_(terrain.radius()), size_(size), block_(Block::shadows) {
    program_ = read_program("shadow.vert", "shadow.frag", clip_define());
    GLuint name = 0;
    glGenTextures(1, &name);
    maps_ = support::Texture(name);
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps_);
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_DEPTH_COMPONENT32F, size, size, cascade_count);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glGenTextures(1, &name);
    heights_ = support::Texture(name);
    glTextureView(heights_, GL_TEXTURE_2D_ARRAY, maps_, GL_DEPTH_COMPONENT32F, 0, 1, 0, cascade_count);
    glBindTexture(GL_TEXTURE_2D_ARRAY, heights_);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (int i = 0; i < cascade_count; ++i) {
        targets_[std::size_t(i)] = support::create_framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, targets_[std::size_t(i)]);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_, 0, i);
        glDrawBuffer(GL_NONE);
    }
}

void ShadowPass::draw(const View& view, const Geometry& geometry, bool on) {
    ShadowBlock bytes{};
    bytes.cascades = cascades_of(view, landscape_radius_, size_);
    range_ = glm::length(view.position) + landscape_radius_;
    bytes.range = float(range_);
    bytes.on = on;
    block_.upload(bytes);
    if (!on) {
        return;
    }
    const support::Uniforms program(program_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    // What stands between the sun and the box shades it from its near side.
    glEnable(GL_DEPTH_CLAMP);
    glViewport(0, 0, size_, size_);
    for (int i = 0; i < cascade_count; ++i) {
        glBindFramebuffer(GL_FRAMEBUFFER, targets_[std::size_t(i)]);
        glClear(GL_DEPTH_BUFFER_BIT);
        program.set("cascade", i);
        geometry.draw_terrain();
        geometry.draw_objects();
    }
    glDisable(GL_DEPTH_CLAMP);
}

void ShadowPass::bind(const support::Uniforms& program, int unit) const {
    bind_texture(unit, maps_, GL_TEXTURE_2D_ARRAY);
    program.set("shadow_maps", unit);
}

void ShadowPass::bind_heights(const support::Uniforms& program, int unit) const {
    bind_texture(unit, heights_, GL_TEXTURE_2D_ARRAY);
    program.set("shadow_heights", unit);
}

}  // namespace deferred
