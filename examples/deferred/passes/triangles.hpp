#pragma once

#include <cstddef>
#include <vector>

#include "pass.hpp"

namespace deferred {

/// A mesh on the GPU.
struct Triangles {
    support::Buffer vertices;
    support::Buffer indices;
    support::VertexArray array;
    int index_count = 0;
};

/// A part of a vertex, of floats.
struct Attribute {
    GLint size;
    std::size_t offset;  ///< [bytes]
};

/// An empty mesh whose vertices take `stride` bytes each.
Triangles make_triangles(std::size_t stride, const std::vector<Attribute>& attributes);

/// Fills it with a mesh's `vertices` and `indices`.
template <typename Mesh>
void upload(Triangles& triangles, const Mesh& mesh) {
    triangles.index_count = int(mesh.indices.size());
    glBindVertexArray(triangles.array);
    glBindBuffer(GL_ARRAY_BUFFER, triangles.vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof mesh.vertices[0]),
                 mesh.vertices.data(), GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof mesh.indices[0]),
                 mesh.indices.data(), GL_STREAM_DRAW);
    glBindVertexArray(0);
}

void draw(const Triangles& triangles);

}  // namespace deferred
