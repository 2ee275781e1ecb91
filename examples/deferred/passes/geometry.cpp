#include "geometry.hpp"

#include <cstddef>

namespace deferred {
namespace {

struct Attribute {
    GLint size;
    std::size_t offset;
};

Triangles make_triangles(std::size_t stride, const std::vector<Attribute>& attributes) {
    Triangles made{support::create_buffer(), support::create_buffer(), support::create_vertex_array(), 0};
    glBindVertexArray(made.array);
    glBindBuffer(GL_ARRAY_BUFFER, made.vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.indices);
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        glEnableVertexAttribArray(GLuint(i));
        glVertexAttribPointer(GLuint(i), attributes[i].size, GL_FLOAT, GL_FALSE, GLsizei(stride),
                              reinterpret_cast<const void*>(attributes[i].offset));
    }
    glBindVertexArray(0);
    return made;
}

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

void draw(const Triangles& triangles) {
    glBindVertexArray(triangles.array);
    glDrawElements(GL_TRIANGLES, triangles.index_count, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace

Geometry::Geometry(const World& world, const Terrain& terrain, bool objects)
    : world_(world), terrain_(terrain), objects_(objects) {
    terrain_triangles_ = make_triangles(sizeof(TerrainVertex), {{3, offsetof(TerrainVertex, position)},
                                                                {3, offsetof(TerrainVertex, normal)},
                                                                {1, offsetof(TerrainVertex, height)}});
    // The roughness follows the albedo, as one attribute of four.
    object_triangles_ = make_triangles(sizeof(ObjectVertex), {{3, offsetof(ObjectVertex, position)},
                                                              {3, offsetof(ObjectVertex, normal)},
                                                              {4, offsetof(ObjectVertex, albedo)}});
}

void Geometry::place(const View& view) {
    if (placed_ && camera_position_ == view.position) {
        return;
    }
    placed_ = true;
    camera_position_ = view.position;
    const double ground_radius = double(world_.atmosphere.ground_radius);
    upload(terrain_triangles_, terrain_.mesh(ground_radius, view.position));
    if (objects_) {
        upload(object_triangles_, object_mesh(terrain_, ground_radius, view.position));
    }
}

void Geometry::draw_terrain() const {
    draw(terrain_triangles_);
}

void Geometry::draw_objects() const {
    if (object_triangles_.index_count > 0) {
        draw(object_triangles_);
    }
}

}  // namespace deferred
