#include "surfaces.hpp"

namespace deferred {

SurfacePass::SurfacePass(const World& world, int width, int height)
    : world_(world), width_(width), height_(height) {
    terrain_program_ = read_program("terrain.vert", "terrain.frag", clip_define());
    object_program_ = read_program("object.vert", "object.frag", clip_define());
    planet_program_ = read_screen_program("planet.frag", scene_defines(world));
    depth_ = support::create_texture(GL_DEPTH_COMPONENT32F, width, height);
    albedo_ = support::create_texture(GL_RGBA16F, width, height);
    normal_ = support::create_texture(GL_RGBA16F, width, height);
    target_ = make_target({albedo_, normal_}, depth_);
}

void SurfacePass::draw(const Geometry& geometry) {
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    glViewport(0, 0, width_, height_);
    // Reversed depth: 0 is infinitely far, and float has the more digits the closer to 0.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glClearDepth(0);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    const support::Uniforms terrain(terrain_program_);
    terrain.set("ground_radius", world_.atmosphere.ground_radius);
    terrain.set("bare_albedo", world_.atmosphere.ground_albedo);
    terrain.set("vegetated", int(world_.vegetated));
    geometry.draw_terrain();

    glUseProgram(object_program_);
    geometry.draw_objects();

    const support::Uniforms planet(planet_program_);
    planet.set("vegetated", int(world_.vegetated));
    draw_screen(target_, width_, height_, true);
}

}  // namespace deferred
