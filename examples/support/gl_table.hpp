#pragma once

// Tables as OpenGL textures.

#include <cstddef>
#include <vector>

#include "support/gl_objects.hpp"

namespace support {

/// How large a table is, in texels.
struct TableSize {
    int width;
    int height;
    int depth;
};

std::size_t texel_count(const TableSize& size);

/// What kind of texture holds a table: filtered across its slices too, one slice only, or slices that are
/// layers of their own.
enum class TableShape { volume, flat, layers };

/// A table's texture: four numbers a texel, GL_RGBA32F or GL_RGBA16F, filtered linearly, clamped to the edge.
Texture create_table_texture(GLenum internal_format, const TableSize& size,
                             TableShape shape = TableShape::volume);

/// Fills it with texels of `channels` numbers each; missing ones are 0.
void upload_table(GLuint texture, const TableSize& size, const std::vector<float>& numbers, int channels,
                  TableShape shape = TableShape::volume);

/// The first `channels` numbers of every texel.
std::vector<float> download_table(GLuint texture, const TableSize& size, int channels,
                                  TableShape shape = TableShape::volume);

/// GL_TEXTURE_3D and so on.
GLenum table_target(TableShape shape);

}  // namespace support
