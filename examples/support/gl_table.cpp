#include "support/gl_table.hpp"

namespace support {

std::size_t texel_count(const TableSize& size) {
    return std::size_t(size.width) * std::size_t(size.height) * std::size_t(size.depth);
}

GLenum table_target(TableShape shape) {
    switch (shape) {
        case TableShape::flat:
            return GL_TEXTURE_2D;
        case TableShape::layers:
            return GL_TEXTURE_2D_ARRAY;
        default:
            return GL_TEXTURE_3D;
    }
}

Texture create_table_texture(GLenum internal_format, const TableSize& size, TableShape shape) {
    GLuint name = 0;
    glGenTextures(1, &name);
    Texture texture(name);
    const GLenum kind = table_target(shape);
    glBindTexture(kind, name);
    if (shape == TableShape::flat) {
        glTexStorage2D(kind, 1, internal_format, size.width, size.height);
    } else {
        glTexStorage3D(kind, 1, internal_format, size.width, size.height, size.depth);
    }
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis :
         {GLenum(GL_TEXTURE_WRAP_S), GLenum(GL_TEXTURE_WRAP_T), GLenum(GL_TEXTURE_WRAP_R)}) {
        glTexParameteri(kind, axis, GL_CLAMP_TO_EDGE);
    }
    return texture;
}

void upload_table(GLuint texture, const TableSize& size, const std::vector<float>& numbers, int channels,
                  TableShape shape) {
    std::vector<float> texels(4 * texel_count(size), 0.0F);
    const auto kept = std::size_t(channels);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        texels[n / kept * 4 + n % kept] = numbers[n];
    }
    glBindTexture(table_target(shape), texture);
    if (shape == TableShape::flat) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.width, size.height, GL_RGBA, GL_FLOAT, texels.data());
    } else {
        glTexSubImage3D(table_target(shape), 0, 0, 0, 0, size.width, size.height, size.depth, GL_RGBA,
                        GL_FLOAT, texels.data());
    }
}

std::vector<float> download_table(GLuint texture, const TableSize& size, int channels, TableShape shape) {
    std::vector<float> texels(4 * texel_count(size));
    glBindTexture(table_target(shape), texture);
    glGetTexImage(table_target(shape), 0, GL_RGBA, GL_FLOAT, texels.data());
    const auto kept = std::size_t(channels);
    std::vector<float> numbers(kept * texel_count(size));
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        numbers[n] = texels[n / kept * 4 + n % kept];
    }
    return numbers;
}

}  // namespace support
