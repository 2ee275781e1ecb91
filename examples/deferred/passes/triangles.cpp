#include "triangles.hpp"

namespace deferred {

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

void draw(const Triangles& triangles) {
    glBindVertexArray(triangles.array);
    glDrawElements(GL_TRIANGLES, triangles.index_count, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace deferred
