#include "support/gl_objects.hpp"

#include <sstream>

#include "support/error.hpp"

namespace support {
namespace {

void delete_shader(GLuint name) {
    glDeleteShader(name);
}

using Shader = GlName<delete_shader>;

/// "2:17(5): error" or "2(17) : error" becomes "viewpoint.glsl:17...", for the logs of Mesa and NVIDIA.
std::string with_file_names(const std::string& log, const std::vector<std::string>& names) {
    std::string text;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t digits = line.find_first_not_of("0123456789");
        const bool is_place = digits != std::string::npos && digits > 0 && digits < 6 &&
                              (line[digits] == ':' || line[digits] == '(');
        const std::size_t number = is_place ? std::stoul(line) : names.size();
        text += (number < names.size() ? names[number] + line.substr(digits) : line) + "\n";
    }
    return text;
}

}  // namespace

void delete_buffer(GLuint name) {
    glDeleteBuffers(1, &name);
}

void delete_framebuffer(GLuint name) {
    glDeleteFramebuffers(1, &name);
}

void delete_program(GLuint name) {
    glDeleteProgram(name);
}

void delete_texture(GLuint name) {
    glDeleteTextures(1, &name);
}

void delete_vertex_array(GLuint name) {
    glDeleteVertexArrays(1, &name);
}

Buffer create_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return Buffer(name);
}

Framebuffer create_framebuffer() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return Framebuffer(name);
}

VertexArray create_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return VertexArray(name);
}

Texture create_texture(GLenum internal_format, int width, int height) {
    GLuint name = 0;
    glGenTextures(1, &name);
    Texture texture(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, internal_format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

Program link_program(const std::vector<ShaderSource>& sources) {
    Program program(glCreateProgram());
    std::vector<Shader> shaders;
    for (const ShaderSource& source : sources) {
        shaders.emplace_back(glCreateShader(source.stage));
        const GLuint shader = shaders.back();
        const char* const text = source.text.c_str();
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        GLint done = GL_FALSE;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
        if (done != GL_TRUE) {
            std::string log(65536, '\0');
            GLsizei length = 0;
            glGetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
            log.resize(std::size_t(length));
            throw Error("a shader does not compile:\n" + with_file_names(log, source.names));
        }
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    GLint done = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (done != GL_TRUE) {
        std::string log(65536, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program, GLsizei(log.size()), &length, log.data());
        log.resize(std::size_t(length));
        throw Error("a shader program does not link:\n" + log);
    }
    return program;
}

}  // namespace support
