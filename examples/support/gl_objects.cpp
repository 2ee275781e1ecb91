#include "support/gl_objects.hpp"

#include <cstdio>
#include <sstream>

#include "support/error.hpp"

namespace support {
namespace {

void delete_shader(GLuint name) {
    glDeleteShader(name);
}

using Shader = GlName<delete_shader>;

// Mesa 22 says source number 0 for most errors that are not of syntax. So lines carry the number too: line 17
// of source 2 is compiled as line 200017.
constexpr std::size_t lines_per_source = 100000;

std::string with_sources_in_lines(const std::string& text) {
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::size_t number = 0;
        std::size_t source = 0;
        if (std::sscanf(line.c_str(), "#line %zu %zu", &number, &source) == 2) {
            line =
                "#line " + std::to_string(source * lines_per_source + number) + " " + std::to_string(source);
        }
        result += line + "\n";
    }
    return result;
}

/// "2:200017(5): error" or "2(200017) : error" becomes "viewpoint.glsl:17...", for the logs of Mesa and
/// NVIDIA.
std::string with_file_names(const std::string& log, const std::vector<std::string>& names) {
    std::string text;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        std::size_t source = 0;
        std::size_t number = 0;
        char separator = 0;
        int length = 0;
        if (std::sscanf(line.c_str(), "%zu%c%zu%n", &source, &separator, &number, &length) == 3 &&
            (separator == ':' || separator == '(') && number / lines_per_source < names.size()) {
            line = names[number / lines_per_source] + separator + std::to_string(number % lines_per_source) +
                   line.substr(std::size_t(length));
        }
        text += line + "\n";
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
        const std::string numbered = with_sources_in_lines(source.text);
        const char* const text = numbered.c_str();
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
