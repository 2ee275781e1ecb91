#include "pass.hpp"

#include "blocks.hpp"
#include "support/error.hpp"
#include "support/glsl_source.hpp"

// Set by CMakeLists.txt: where the generated GLSL and this example's shaders lie.
#ifndef AIRLIGHT_GLSL_FOLDER
#error "AIRLIGHT_GLSL_FOLDER is not defined"
#endif
#ifndef DEFERRED_SHADER_FOLDER
#error "DEFERRED_SHADER_FOLDER is not defined"
#endif

namespace deferred {
namespace {

std::filesystem::path& shader_folder() {
    static std::filesystem::path folder = DEFERRED_SHADER_FOLDER;
    return folder;
}

support::ShaderSource read_shader(GLenum stage, const std::string& file, const std::string& defines) {
    const std::vector<std::filesystem::path> folders = {shader_folder(), AIRLIGHT_GLSL_FOLDER};
    const std::string text = "#version 430 core\n" + defines + "#include \"" + file + "\"\n";
    const support::ExpandedGlsl source = support::expand_includes(text, "preamble of " + file, folders);
    return support::ShaderSource{stage, source.text, source.names};
}

void bind_block(GLuint program, const char* name, Block block) {
    const GLuint index = glGetUniformBlockIndex(program, name);
    if (index != GL_INVALID_INDEX) {
        glUniformBlockBinding(program, index, GLuint(block));
    }
}

}  // namespace

void set_shader_folder(const std::filesystem::path& folder) {
    shader_folder() = folder;
}

support::Program read_program(const std::string& vertex_file, const std::string& fragment_file,
                              const std::string& defines) {
    support::Program program =
        support::link_program({read_shader(GL_VERTEX_SHADER, vertex_file, defines),
                               read_shader(GL_FRAGMENT_SHADER, fragment_file, defines)});
    bind_block(program, "AtmosphereBlock", Block::atmosphere);
    bind_block(program, "FrameBlock", Block::frame);
    bind_block(program, "ShadowBlock", Block::shadows);
    bind_block(program, "EpipolarBlock", Block::epipolar);
    return program;
}

support::Program read_screen_program(const std::string& fragment_file, const std::string& defines) {
    return read_program("screen.vert", fragment_file, defines);
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

void bind_texture(int unit, GLuint texture, GLenum target) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(target, texture);
}

void set_linear_filter(GLuint texture) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void draw_screen(GLuint target, int width, int height, bool depth_test) {
    draw_screen(target, 0, 0, width, height, depth_test);
}

void draw_screen(GLuint target, int x, int y, int width, int height, bool depth_test) {
    // The core profile wants a vertex array though no vertex has an attribute.
    const support::VertexArray no_attributes = support::create_vertex_array();
    glBindVertexArray(no_attributes);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(x, y, width, height);
    if (!depth_test) {
        glDisable(GL_DEPTH_TEST);
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

void copy_to(GLuint target, int width, int height, GLuint source, int source_width, int source_height) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
    const bool same_size = width == source_width && height == source_height;
    glBlitFramebuffer(0, 0, source_width, source_height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      same_size ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
}

bool has_clip_control() {
    return epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control");
}

std::string clip_define() {
    return std::string("#define CLIP_CONTROL ") + (has_clip_control() ? "1" : "0") + "\n";
}

std::vector<float> read_texture(GLuint texture, GLenum format, std::size_t count) {
    std::vector<float> values(count);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexImage(GL_TEXTURE_2D, 0, format, GL_FLOAT, values.data());
    return values;
}

std::vector<float> read_samples(GLuint texture, int width, int height, int columns, int rows) {
    const support::Framebuffer source = make_target({texture});
    const support::Texture small = support::create_texture(GL_RGBA32F, columns, rows);
    const support::Framebuffer target = make_target({small});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
    glBlitFramebuffer(0, 0, width, height, 0, 0, columns, rows, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return read_texture(small, GL_RGB, 3 * std::size_t(columns) * std::size_t(rows));
}

}  // namespace deferred
