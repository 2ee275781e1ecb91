#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>
#include <vector>

namespace support {

/// An OpenGL object name that is deleted with its owner.
template <void (*Delete)(GLuint)>
class GlName {
  public:
    GlName() = default;
    explicit GlName(GLuint name) : name_(name) {}
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (name_ != 0) {
            Delete(name_);
        }
    }

    operator GLuint() const {
        return name_;
    }

  private:
    GLuint name_ = 0;
};

void delete_buffer(GLuint name);
void delete_framebuffer(GLuint name);
void delete_program(GLuint name);
void delete_texture(GLuint name);
void delete_vertex_array(GLuint name);

using Buffer = GlName<delete_buffer>;
using Framebuffer = GlName<delete_framebuffer>;
using Program = GlName<delete_program>;
using Texture = GlName<delete_texture>;
using VertexArray = GlName<delete_vertex_array>;

Buffer create_buffer();
Framebuffer create_framebuffer();
VertexArray create_vertex_array();

/// One level, nearest neighbour, clamped: what a pixel of a frame is stored in.
Texture create_texture(GLenum internal_format, int width, int height);

/// The text of one shader stage. `names` says, for each source number of a #line directive, which file that
/// is, so that an error log can be read.
struct ShaderSource {
    GLenum stage;
    std::string text;
    std::vector<std::string> names;
};

/// Compiles and links. Throws Error with the driver's log, its source numbers replaced by file names.
Program link_program(const std::vector<ShaderSource>& sources);

}  // namespace support
