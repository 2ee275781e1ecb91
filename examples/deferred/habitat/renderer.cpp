#include "habitat/renderer.hpp"

#include <cstddef>

#include "support/gl_context.hpp"
#include "support/gl_table.hpp"
#include "support/rows.hpp"
#include "support/table_file.hpp"

namespace deferred::habitat {
namespace {

// The document's table, and one that needs no more for being smooth.
constexpr int light_width = 49;
constexpr int light_height = 33;
constexpr int light_depth = 33;
constexpr int indirect_width = 25;
constexpr int indirect_height = 9;
constexpr int indirect_depth = 9;
constexpr int gathered_directions = 128;
constexpr int strip_pieces = 2;

support::Texture texture_of(const airlight::Table<vec3>& table) {
    const support::TableSize size{table.width, table.height, table.depth};
    support::Texture texture = support::create_table_texture(GL_RGBA32F, size);
    support::upload_table(texture, size, support::numbers_of(table), 3);
    return texture;
}

/// A table of one texel, where there is nothing to look up.
airlight::Table<vec3> or_nothing(const airlight::Table<vec3>& table) {
    return table.texels.empty() ? airlight::make_table<vec3>(1, 1, 1) : table;
}

}  // namespace

Tables bake_tables(const World& world) {
    using airlight::DefaultScene;
    Tables tables{};
    if (world.air_light == AirLight::marched) {
        tables.straight = airlight::bake_habitat_light<float, DefaultScene>(
            world.air, world.lights, light_width, light_height, light_depth, strip_pieces,
            support::Rows("light of the strips"));
    } else if (world.air_light == AirLight::nodes) {
        tables.straight = airlight::bake_habitat_passed<float, DefaultScene>(
            world.air, world.lights, light_width, light_height, light_depth, strip_pieces,
            support::Rows("what passes"));
    }
    if (world.bounces > 0) {
        // Gathered light is smooth: what passes may be coarse.
        const airlight::Table<vec3> passed = airlight::bake_habitat_passed<float, DefaultScene>(
            world.air, world.lights, indirect_width, indirect_height, indirect_depth, strip_pieces);
        const support::Rows rows("indirect light");
        rows.expect_passes(world.bounces);
        tables.indirect = airlight::bake_habitat_indirect<float, DefaultScene>(
            world.air, world.lights, world.wall_albedo, world.bounces, indirect_width, indirect_height,
            indirect_depth, gathered_directions, airlight::HabitatPassedTable<float>{&passed}, rows);
    }
    return tables;
}

HabitatRenderer::HabitatRenderer(const World& world, const Tables& tables, const Land& land, bool plain,
                                 int width, int height)
    : world_(world),
      plain_(plain),
      width_(width),
      height_(height),
      frame_block_(Block::frame),
      straight_table_(texture_of(or_nothing(tables.straight))),
      mean_table_(texture_of(or_nothing(tables.indirect.mean))),
      irradiance_table_(texture_of(or_nothing(tables.indirect.irradiance))),
      bloom_(width, height),
      flare_(bloom_),
      tone_(width, height) {
    land_ = make_triangles(sizeof(LandVertex), {{3, offsetof(LandVertex, position)},
                                                {3, offsetof(LandVertex, normal)},
                                                {1, offsetof(LandVertex, height)}});
    upload(land_, land.mesh());
    land_program_ = read_program("habitat_land.vert", "habitat_land.frag", clip_define());
    light_program_ = read_screen_program(
        "habitat_light.frag",
        "#define AIR_LIGHT_PHASE 0\n#define AIR_LIGHT_NODES 1\n#define AIR_LIGHT_MARCHED 2\n"
        "#define AIR_LIGHT " +
            std::to_string(int(world.air_light)) + "\n#define MARCH_STEPS " + std::to_string(march_steps) +
            "\n");
    depth_ = support::create_texture(GL_DEPTH_COMPONENT32F, width, height);
    albedo_ = support::create_texture(GL_RGBA16F, width, height);
    normal_ = support::create_texture(GL_RGBA16F, width, height);
    radiance_ = support::create_texture(GL_RGBA32F, width, height);
    surface_target_ = make_target({albedo_, normal_}, depth_);
    light_target_ = make_target({radiance_});
    if (has_clip_control()) {
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    // Mesa's llvmpipe starts no timer before it has drawn to something: to the last target that was made.
    glClear(GL_COLOR_BUFFER_BIT);
    support::check_gl("making the render targets");
}

void HabitatRenderer::set_world(const support::Uniforms& program) const {
    program.set("air", world_.air);
    program.set("lights", world_.lights);
}

void HabitatRenderer::draw(const Frame& frame) {
    frame_block_.upload(frame);
    timers_.begin_frame();
    timers_.start("surfaces");
    glBindFramebuffer(GL_FRAMEBUFFER, surface_target_);
    glViewport(0, 0, width_, height_);
    // Reversed depth: 0 is infinitely far, and float has the more digits the closer to 0.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glClearDepth(0);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const support::Uniforms land(land_program_);
    set_world(land);
    land.set("plain", int(plain_));
    land.set("wall_albedo", world_.wall_albedo);
    deferred::draw(land_);

    timers_.start("light");
    const support::Uniforms light(light_program_);
    set_world(light);
    light.set("indirect", int(world_.bounces > 0));
    light.set("depth_texture", 0);
    light.set("albedo_texture", 1);
    light.set("normal_texture", 2);
    light.set("straight_table", 3);
    light.set("mean_table", 4);
    light.set("irradiance_table", 5);
    bind_texture(0, depth_);
    bind_texture(1, albedo_);
    bind_texture(2, normal_);
    bind_texture(3, straight_table_, GL_TEXTURE_3D);
    bind_texture(4, mean_table_, GL_TEXTURE_3D);
    bind_texture(5, irradiance_table_, GL_TEXTURE_3D);
    draw_screen(light_target_, width_, height_);
    timers_.stop();
    support::check_gl("drawing a picture");
}

GpuPicture HabitatRenderer::read() const {
    const std::size_t count = std::size_t(width_) * std::size_t(height_);
    GpuPicture picture{};
    picture.surfaces.depth = read_texture(depth_, GL_DEPTH_COMPONENT, count);
    picture.surfaces.albedo = read_texture(albedo_, GL_RGBA, 4 * count);
    picture.surfaces.normal = read_texture(normal_, GL_RGBA, 4 * count);
    picture.radiance = read_texture(radiance_, GL_RGB, 3 * count);
    for (const PassTime& pass : timers_.read(true)) {
        picture.milliseconds += pass.name == "light" ? pass.milliseconds : 0;
    }
    support::check_gl("reading a picture");
    return picture;
}

void HabitatRenderer::replace(const std::vector<float>& radiance) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_2D, radiance_);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGB, GL_FLOAT, radiance.data());
    support::check_gl("replacing a picture");
}

std::vector<std::uint8_t> HabitatRenderer::display(const Settings& settings, float exposure) {
    if (settings.bloom) {
        timers_.start("bloom");
        bloom_.reduce(radiance_);
        bloom_.spread();
    }
    timers_.start("tone");
    tone_.draw(radiance_, albedo_, bloom_, flare_, settings, exposure);
    timers_.stop();
    std::vector<std::uint8_t> bytes = tone_.read();
    support::check_gl("encoding a picture");
    return bytes;
}

}  // namespace deferred::habitat
