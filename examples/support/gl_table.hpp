#pragma once

// Tables as OpenGL textures.

#include <vector>

#include "support/gl_objects.hpp"

namespace support {

/// How large a table is, in texels.
struct TableSize {
    int width;
    int height;
    int depth;
};

/// A table's texture: four numbers a texel, GL_RGBA32F or GL_RGBA16F, filtered linearly, clamped to the edge.
/// Three-dimensional; `flat` makes it two-dimensional, depth is then 1.
Texture create_table_texture(GLenum internal_format, const TableSize& size, bool flat = false);

/// Fills it with texels of `channels` numbers each; missing ones are 0.
void upload_table(GLuint texture, const TableSize& size, const std::vector<float>& numbers, int channels,
                  bool flat = false);

/// The first `channels` numbers of every texel.
std::vector<float> download_table(GLuint texture, const TableSize& size, int channels, bool flat = false);

}  // namespace support
