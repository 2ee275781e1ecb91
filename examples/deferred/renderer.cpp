#include "renderer.hpp"

#include "support/gl_context.hpp"

namespace deferred {

Renderer::Renderer(const World& world, const AirTables& tables, const Terrain& terrain,
                   const Settings& settings, int width, int height)
    : world_(world),
      width_(width),
      height_(height),
      atmosphere_block_(Block::atmosphere),
      frame_block_(Block::frame),
      tables_(tables),
      geometry_(world, terrain, settings.objects),
      shadows_(terrain, settings.shadow_size),
      surfaces_(world, width, height),
      stars_(width, height),
      occlusion_(width, height),
      visibility_(width, height, settings.clouds),
      lighting_(world, tables_, width, height),
      air_(world, tables_, width, height, settings.clouds),
      bloom_(width, height),
      flare_(bloom_),
      tone_(width, height) {
    if (settings.clouds) {
        clouds_.emplace(world, tables_, width, height);
    }
    if (settings.shafts == Shafts::epipolar) {
        epipolar_.emplace(world, settings, width, height);
    } else if (settings.shafts != Shafts::none) {
        shafts_.emplace(world, width, height, settings.half_shafts);
    }
    if (has_clip_control()) {
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    // Mesa's llvmpipe starts no timer before it has drawn to something: to the last target that was made.
    glClear(GL_COLOR_BUFFER_BIT);
    support::check_gl("making the render targets");
}

void Renderer::draw(const View& view, const Settings& settings) {
    // Every time: the air may be another one, and another renderer may have bound its blocks.
    atmosphere_block_.upload(AtmosphereBlock(world_.atmosphere));
    frame_block_.upload(view.frame);
    geometry_.place(view);
    timers_.begin_frame();
    timers_.start("shadow maps");
    shadows_.draw(view, geometry_, settings.shadows);
    timers_.start("surfaces");
    surfaces_.draw(geometry_);
    if (settings.stars) {
        stars_.draw(surfaces_.target());
    }
    if (settings.ambient_occlusion) {
        timers_.start("occlusion");
        occlusion_.draw(surfaces_.depth(), surfaces_.normal());
    }
    timers_.start("visibility");
    visibility_.draw(surfaces_, shadows_, settings.ambient_occlusion ? occlusion_.share() : 0);
    timers_.start("lighting");
    lighting_.draw(surfaces_, visibility_);
    if (clouds_) {
        timers_.start("clouds");
        clouds_->draw(surfaces_);
    }
    lost_ = 0;
    if (settings.shafts != Shafts::none && settings.shadows && settings.air) {
        timers_.start("shafts");
        if (settings.shafts == Shafts::epipolar) {
            epipolar_->draw(view, surfaces_, shadows_, settings);
            lost_ = epipolar_->lost();
        } else {
            shafts_->draw(surfaces_, shadows_, settings);
            lost_ = shafts_->lost();
        }
    }
    timers_.start("air");
    air_.draw(surfaces_, lighting_, lost_, clouds_);
    timers_.stop();
    support::check_gl("drawing a picture");
}

GpuPicture Renderer::read() const {
    const std::size_t count = std::size_t(width_) * std::size_t(height_);
    GpuPicture picture{};
    picture.surfaces.depth = read_texture(surfaces_.depth(), GL_DEPTH_COMPONENT, count);
    picture.surfaces.albedo = read_texture(surfaces_.albedo(), GL_RGBA, 4 * count);
    picture.surfaces.normal = read_texture(surfaces_.normal(), GL_RGBA, 4 * count);
    picture.surfaces.shares = read_texture(visibility_.shares(), GL_RGBA, 4 * count);
    if (lost_ != 0) {
        picture.surfaces.lost = read_texture(lost_, GL_RGB, 3 * count);
    }
    if (clouds_) {
        picture.surfaces.clouds = read_texture(clouds_->light(), GL_RGBA, 4 * count);
        picture.surfaces.cloud_distance = read_texture(clouds_->distance(), GL_RED, count);
    }
    picture.radiance = read_texture(air_.radiance(), GL_RGB, 3 * count);
    for (const PassTime& pass : timers_.read(true)) {
        if (pass.name == "lighting" || pass.name == "clouds" || pass.name == "shafts" || pass.name == "air") {
            picture.milliseconds += pass.milliseconds;
        }
        if (pass.name == "shafts") {
            picture.shaft_milliseconds = pass.milliseconds;
        }
    }
    support::check_gl("reading a picture");
    return picture;
}

void Renderer::encode(const Settings& settings, float exposure) {
    if (settings.bloom || settings.flare) {
        timers_.start("bloom");
        bloom_.reduce(air_.radiance());
    }
    if (settings.bloom) {
        bloom_.spread();
    }
    if (settings.flare) {
        timers_.start("flare");
        flare_.draw(bloom_);
    }
    timers_.start("tone");
    tone_.draw(air_.radiance(), visibility_.shares(), bloom_, flare_, settings, exposure);
    timers_.stop();
}

std::vector<std::uint8_t> Renderer::display(const Settings& settings, float exposure) {
    encode(settings, exposure);
    std::vector<std::uint8_t> bytes = tone_.read();
    support::check_gl("encoding a picture");
    return bytes;
}

void Renderer::show(const Settings& settings, float exposure, GLuint framebuffer, int width, int height) {
    encode(settings, exposure);
    copy_to(framebuffer, width, height, tone_.target(), width_, height_);
    support::check_gl("showing a picture");
}

void Renderer::use(const AirTables& tables) {
    tables_ = GpuTables(tables);
}

}  // namespace deferred
