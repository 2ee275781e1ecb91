#include "gpu_frame.hpp"

#include <epoxy/gl.h>

#include <chrono>
#include <cstddef>
#include <string>

#include "support/error.hpp"
#include "support/gl_context.hpp"
#include "support/glsl_source.hpp"
#include "support/uniforms.hpp"

// Set by CMakeLists.txt: where the generated GLSL and this example's shaders lie.
#ifndef AIRLIGHT_GLSL_FOLDER
#error "AIRLIGHT_GLSL_FOLDER is not defined"
#endif
#ifndef DEFERRED_SHADER_FOLDER
#error "DEFERRED_SHADER_FOLDER is not defined"
#endif

namespace deferred {
namespace {

support::ShaderSource read_shader(GLenum stage, const std::string& file, const std::string& defines) {
    const std::vector<std::filesystem::path> folders = {DEFERRED_SHADER_FOLDER, AIRLIGHT_GLSL_FOLDER};
    const std::string text = "#version 430 core\n" + defines + "#include \"" + file + "\"\n";
    const support::ExpandedGlsl source = support::expand_includes(text, "preamble of " + file, folders);
    return support::ShaderSource{stage, source.text, source.names};
}

support::Program read_program(const std::string& vertex_file, const std::string& fragment_file,
                              const std::string& defines) {
    return support::link_program({read_shader(GL_VERTEX_SHADER, vertex_file, defines),
                                  read_shader(GL_FRAGMENT_SHADER, fragment_file, defines)});
}

/// A frame too.
class Uniforms : public support::Uniforms {
  public:
    using support::Uniforms::set;
    using support::Uniforms::Uniforms;

    void set(const std::string& name, const Frame& f) const {
        set(name + ".width", f.width);
        set(name + ".height", f.height);
        set(name + ".ray_corner", f.ray_corner);
        set(name + ".ray_across", f.ray_across);
        set(name + ".ray_up", f.ray_up);
        set(name + ".near_distance", f.near_distance);
        set(name + ".eye_position", f.eye_position);
        set(name + ".to_sun", f.to_sun);
        set(name + ".solar_irradiance", f.solar_irradiance);
        set(name + ".sun_sin_radius", f.sun_sin_radius);
        set(name + ".sun_sin_edge", f.sun_sin_edge);
        set(name + ".marched", f.marched ? 1 : 0);
        set(name + ".steps", f.steps);
        set(name + ".sky_steps", f.sky_steps);
    }
};

void bind_texture(int unit, GLuint texture) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, texture);
}

support::Framebuffer make_target(const std::vector<GLuint>& colors, GLuint depth) {
    support::Framebuffer target = support::create_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    std::vector<GLenum> outputs;
    for (const GLuint color : colors) {
        outputs.push_back(GLenum(GL_COLOR_ATTACHMENT0 + outputs.size()));
        glFramebufferTexture2D(GL_FRAMEBUFFER, outputs.back(), GL_TEXTURE_2D, color, 0);
    }
    glDrawBuffers(GLsizei(outputs.size()), outputs.data());
    if (depth != 0) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw support::Error("the driver does not take these render targets; try a smaller --size");
    }
    return target;
}

std::vector<float> read_texture(GLuint texture, GLenum format, std::size_t count) {
    std::vector<float> values(count);
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, values.data());
    return values;
}

}  // namespace

GpuRenderer::GpuRenderer(const World& world, const AirTables& tables, const Terrain& terrain, int width,
                         int height)
    : world_(world),
      terrain_(terrain),
      width_(width),
      height_(height),
      has_clip_control_(epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control")),
      tables_(tables) {
    const std::string clip_define =
        std::string("#define CLIP_CONTROL ") + (has_clip_control_ ? "1" : "0") + "\n";
    const std::string scene_define =
        world.lorentzian_ozone ? "#define AIRLIGHT_OZONE AIRLIGHT_OZONE_LORENTZIAN\n" : "";
    terrain_program_ = read_program("terrain.vert", "terrain.frag", clip_define);
    planet_program_ = read_program("screen.vert", "planet.frag", scene_define);
    lighting_program_ = read_program("screen.vert", "lighting.frag", scene_define + tables_.defines());
    display_program_ = read_program("screen.vert", "display.frag", "");

    depth_ = support::create_texture(GL_DEPTH_COMPONENT32F, width, height);
    albedo_ = support::create_texture(GL_RGBA16F, width, height);
    normal_ = support::create_texture(GL_RGBA16F, width, height);
    radiance_ = support::create_texture(GL_RGBA32F, width, height);
    encoded_ = support::create_texture(GL_RGBA8, width, height);
    surfaces_target_ = make_target({albedo_, normal_}, depth_);
    radiance_target_ = make_target({radiance_}, 0);
    encoded_target_ = make_target({encoded_}, 0);

    screen_array_ = support::create_vertex_array();
    vertices_ = support::create_buffer();
    indices_ = support::create_buffer();
    terrain_array_ = support::create_vertex_array();
    glBindVertexArray(terrain_array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    const auto attribute = [](GLuint index, GLint size, std::size_t offset) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(TerrainVertex),
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(TerrainVertex, position));
    attribute(1, 3, offsetof(TerrainVertex, normal));
    attribute(2, 1, offsetof(TerrainVertex, height));
    glBindVertexArray(0);
    support::check_gl("making the render targets");
}

void GpuRenderer::draw_surfaces(const View& view) {
    glBindFramebuffer(GL_FRAMEBUFFER, surfaces_target_);
    glViewport(0, 0, width_, height_);
    if (has_clip_control_) {
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    // Reversed depth: 0 is infinitely far, and float has the more digits the closer to 0.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glClearDepth(0);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    const TerrainMesh mesh = terrain_.mesh(world_.atmosphere.ground_radius, view.position);
    glBindVertexArray(terrain_array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(TerrainVertex)),
                 mesh.vertices.data(), GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(std::uint32_t)),
                 mesh.indices.data(), GL_STREAM_DRAW);
    const Uniforms terrain(terrain_program_);
    terrain.set("frame", view.frame);
    terrain.set("ground_radius", world_.atmosphere.ground_radius);
    terrain.set("bare_albedo", world_.atmosphere.ground_albedo);
    terrain.set("vegetated", int(world_.vegetated));
    glDrawElements(GL_TRIANGLES, GLsizei(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);

    glBindVertexArray(screen_array_);
    const Uniforms planet(planet_program_);
    planet.set("atmosphere", world_.atmosphere);
    planet.set("frame", view.frame);
    planet.set("vegetated", int(world_.vegetated));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_DEPTH_TEST);
}

GpuPicture GpuRenderer::draw(const View& view) {
    draw_surfaces(view);
    glFinish();

    const auto start = std::chrono::steady_clock::now();
    glBindFramebuffer(GL_FRAMEBUFFER, radiance_target_);
    glViewport(0, 0, width_, height_);
    const Uniforms lighting(lighting_program_);
    lighting.set("atmosphere", world_.atmosphere);
    lighting.set("frame", view.frame);
    lighting.set("depth_texture", 0);
    lighting.set("albedo_texture", 1);
    lighting.set("normal_texture", 2);
    bind_texture(0, depth_);
    bind_texture(1, albedo_);
    bind_texture(2, normal_);
    tables_.bind(lighting);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
    const std::chrono::duration<double, std::milli> duration = std::chrono::steady_clock::now() - start;

    const std::size_t count = std::size_t(width_) * std::size_t(height_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    GpuPicture picture;
    picture.surfaces.depth = read_texture(depth_, GL_DEPTH_COMPONENT, count);
    picture.surfaces.albedo = read_texture(albedo_, GL_RGBA, 4 * count);
    picture.surfaces.normal = read_texture(normal_, GL_RGBA, 4 * count);
    picture.radiance = read_texture(radiance_, GL_RGB, 3 * count);
    picture.milliseconds = duration.count();
    support::check_gl("drawing a picture");
    return picture;
}

std::vector<std::uint8_t> GpuRenderer::display(float exposure) {
    glBindFramebuffer(GL_FRAMEBUFFER, encoded_target_);
    glViewport(0, 0, width_, height_);
    glBindVertexArray(screen_array_);
    const Uniforms display(display_program_);
    display.set("radiance_texture", 0);
    display.set("exposure", exposure);
    bind_texture(0, radiance_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<std::uint8_t> bytes(3 * std::size_t(width_) * std::size_t(height_));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    support::check_gl("encoding a picture");
    return bytes;
}

}  // namespace deferred
