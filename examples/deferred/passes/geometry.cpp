#include "geometry.hpp"

#include <cstddef>

namespace deferred {

Geometry::Geometry(const World& world, const Terrain& terrain) : world_(world), terrain_(terrain) {
    vertices_ = support::create_buffer();
    indices_ = support::create_buffer();
    array_ = support::create_vertex_array();
    glBindVertexArray(array_);
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
}

void Geometry::place(const View& view) {
    if (placed_ && camera_position_ == view.position) {
        return;
    }
    placed_ = true;
    camera_position_ = view.position;
    const TerrainMesh mesh = terrain_.mesh(double(world_.atmosphere.ground_radius), view.position);
    index_count_ = int(mesh.indices.size());
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(TerrainVertex)),
                 mesh.vertices.data(), GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(std::uint32_t)),
                 mesh.indices.data(), GL_STREAM_DRAW);
    glBindVertexArray(0);
}

void Geometry::draw_terrain() const {
    glBindVertexArray(array_);
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace deferred
