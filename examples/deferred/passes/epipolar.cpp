#include "epipolar.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <airlight/constants.hpp>

namespace deferred {
namespace {

constexpr int tree_columns = 1024;

/// Along the border of the screen: all rays of a view between them.
std::vector<glm::dvec3> border_rays(const Frame& frame) {
    constexpr int steps = 64;
    std::vector<glm::dvec3> rays;
    const auto ray = [&frame](double x, double y) {
        return glm::normalize(glm::dvec3(frame.ray_corner) + x * frame.width * glm::dvec3(frame.ray_across) +
                              y * frame.height * glm::dvec3(frame.ray_up));
    };
    for (int i = 0; i <= steps; ++i) {
        const double share = double(i) / steps;
        rays.insert(rays.end(), {ray(share, 0), ray(share, 1), ray(0, share), ray(1, share)});
    }
    return rays;
}

bool on_screen(const Frame& frame, const glm::dvec3& direction) {
    const glm::dvec3 across(frame.ray_across);
    const glm::dvec3 up(frame.ray_up);
    const double facing = glm::dot(direction, glm::normalize(glm::cross(up, across)));
    if (facing <= 0) {
        return false;
    }
    const glm::dvec3 ray = direction / facing - glm::dvec3(frame.ray_corner);
    const double x = glm::dot(ray, across) / glm::dot(across, across);
    const double y = glm::dot(ray, up) / glm::dot(up, up);
    return x >= -1 && y >= -1 && x <= frame.width + 1 && y <= frame.height + 1;
}

}  // namespace

EpipolarBlock epipolar_block(const Frame& frame, double columns_end, int slices, int samples, int columns) {
    const LightAxes light = mapped_light_axes(frame);
    const glm::dvec3 to_sun = light.to_light;
    const auto around = [&light](const glm::dvec3& ray) {
        return std::atan2(glm::dot(ray, light.up), glm::dot(ray, light.across));
    };

    const std::vector<glm::dvec3> rays = border_rays(frame);
    const glm::dvec3 middle = glm::cross(glm::dvec3(frame.ray_up), glm::dvec3(frame.ray_across));
    const double turn = 2 * airlight::pi<double>;
    double first_slice = 0;
    double last_slice = 0;
    double first_angle = airlight::pi<double>;
    double last_angle = 0;
    for (const glm::dvec3& ray : rays) {
        const double slice = std::remainder(around(ray) - around(middle), turn);
        first_slice = std::min(first_slice, slice);
        last_slice = std::max(last_slice, slice);
        const double angle = std::atan2(glm::length(glm::cross(ray, to_sun)), glm::dot(ray, to_sun));
        first_angle = std::min(first_angle, angle);
        last_angle = std::max(last_angle, angle);
    }
    const bool sun = on_screen(frame, to_sun);
    const bool opposite = on_screen(frame, -to_sun);
    EpipolarBlock block{};
    block.slice_x = vec3(light.across);
    block.slice_y = vec3(light.up);
    block.whole_circle = sun || opposite;
    block.first_slice = block.whole_circle != 0 ? 0 : float(first_slice + around(middle));
    block.slice_range = block.whole_circle != 0 ? float(turn) : float(last_slice - first_slice);
    block.first_angle = sun ? 0 : float(first_angle);
    block.angle_range = float((opposite ? airlight::pi<double> : last_angle) - (sun ? 0 : first_angle));
    block.columns_end = float(columns_end);
    block.slices = slices;
    block.samples = samples;
    block.columns = columns;
    return block;
}

EpipolarPass::EpipolarPass(const World& world, const Settings& settings, int width, int height)
    : width_(width),
      height_(height),
      slices_(settings.shaft_slices),
      samples_(settings.shaft_samples),
      columns_(tree_columns),
      block_(Block::epipolar) {
    heights_program_ = read_screen_program("epipolar_heights.frag");
    tree_program_ = read_screen_program("epipolar_tree.frag");
    march_program_ = read_screen_program("epipolar_march.frag", scene_defines(world));
    gather_program_ = read_screen_program("epipolar_gather.frag", scene_defines(world));
    tree_ = support::create_texture(GL_RG32F, 2 * columns_, slices_);
    half_tree_ = support::create_texture(GL_RG32F, 2 * columns_, slices_);
    marched_ = support::create_texture(GL_RGBA32F, samples_, slices_);
    lost_ = support::create_texture(GL_RGBA32F, width, height);
    tree_target_ = make_target({tree_});
    half_tree_target_ = make_target({half_tree_});
    marched_target_ = make_target({marched_});
    lost_target_ = make_target({lost_});
}

void EpipolarPass::draw(const View& view, const SurfacePass& surfaces, const ShadowPass& shadows,
                        const Settings& settings) {
    block_.upload(epipolar_block(view.frame, shadows.range(), slices_, samples_, columns_));

    const support::Uniforms heights(heights_program_);
    shadows.bind_heights(heights, 0);
    draw_screen(tree_target_, columns_, slices_);

    const support::Uniforms tree(tree_program_);
    tree.set("tree_texture", 0);
    int from = 0;
    for (int texels = columns_ / 2; texels >= 1; texels /= 2) {
        const int begin = from + 2 * texels;
        tree.set("from_begin", from);
        tree.set("begin", begin);
        bind_texture(0, tree_);
        // Written beside what is read, then copied: no pass may read its own target.
        draw_screen(half_tree_target_, begin, 0, texels, slices_);
        glCopyImageSubData(half_tree_, GL_TEXTURE_2D, 0, begin, 0, 0, tree_, GL_TEXTURE_2D, 0, begin, 0, 0,
                           texels, slices_, 1);
        from = begin;
    }

    const support::Uniforms march(march_program_);
    march.set("depth_texture", 0);
    march.set("tree_texture", 1);
    march.set("pieces", settings.shaft_pieces);
    bind_texture(0, surfaces.depth());
    bind_texture(1, tree_);
    draw_screen(marched_target_, samples_, slices_);

    const support::Uniforms gather(gather_program_);
    gather.set("depth_texture", 0);
    gather.set("tree_texture", 1);
    gather.set("marched_texture", 2);
    gather.set("pieces", settings.shaft_pieces);
    bind_texture(0, surfaces.depth());
    bind_texture(1, tree_);
    bind_texture(2, marched_);
    draw_screen(lost_target_, width_, height_);
}

}  // namespace deferred
