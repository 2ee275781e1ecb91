#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "support/gl_objects.hpp"
#include "support/uniforms.hpp"

// What the passes of a frame have in common. Each pass is a class with its own textures: draw() reads those
// of the passes before it and leaves its own.

namespace deferred {

/// Where this example's shaders are read from instead of its sources.
void set_shader_folder(const std::filesystem::path& folder);

/// A program of two of this example's shaders, with the library's GLSL behind their includes and its blocks
/// at their binding points. `defines` are lines before the first include. Throws support::Error, with file
/// and line, when one is missing or does not compile.
support::Program read_program(const std::string& vertex_file, const std::string& fragment_file,
                              const std::string& defines = "");

/// A program of screen.vert and a fragment shader.
support::Program read_screen_program(const std::string& fragment_file, const std::string& defines = "");

/// Where a pass draws to: one texture per colour output, and depth when it is not 0.
support::Framebuffer make_target(const std::vector<GLuint>& colors, GLuint depth = 0);

void bind_texture(int unit, GLuint texture, GLenum target = GL_TEXTURE_2D);

/// Lets shaders read a texture between its texels.
void set_linear_filter(GLuint texture);

/// Runs the program in use over every pixel of the target, with or without the depth test.
void draw_screen(GLuint target, int width, int height, bool depth_test = false);

/// Over a part of the target.
void draw_screen(GLuint target, int x, int y, int width, int height, bool depth_test = false);
/// Copies the bytes of one framebuffer to another, stretched to its size.
void copy_to(GLuint target, int width, int height, GLuint source, int source_width, int source_height);

/// Whether the driver has depth from 0 to 1 before rasterisation (ARB_clip_control, OpenGL 4.5). Without it
/// projections map to [-1, 1], and reversed depth keeps its digits as gl_FragDepth only.
bool has_clip_control();

/// What shaders that project are compiled with.
std::string clip_define();

std::vector<float> read_texture(GLuint texture, GLenum format, std::size_t count);

/// What a texture holds at columns x rows places spread over it evenly, 3 each, without reading all of it.
std::vector<float> read_samples(GLuint texture, int width, int height, int columns, int rows);

}  // namespace deferred
