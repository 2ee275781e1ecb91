// Whether airlight::sample is what OpenGL makes of the same texels: linear filtering, clamped to the edge.

#include <airlight/tables/table.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "samplers.hpp"
#include "support/gl_table.hpp"
#include "support/gl_test.hpp"
#include "support/table_file.hpp"

namespace {

using airlight::Table;
using airlight::vec2;
using airlight::vec3;
using vec4 = airlight::vec4<float>;

constexpr int places = 16384;

/// The texture at each of the places, by a compute shader.
std::vector<vec4> filtered_by_gl(GLuint texture, bool flat, const std::vector<vec4>& uvw) {
    const std::string text =
        std::string("#version 430 core\n") +
        "layout(local_size_x = 64) in;\n"
        "layout(std430, binding = 0) readonly buffer Places { vec4 uvw[]; };\n"
        "layout(std430, binding = 1) writeonly buffer Results { vec4 result[]; };\n" +
        (flat ? "uniform sampler2D table;\n" : "uniform sampler3D table;\n") +
        "void main() {\n    uint n = gl_GlobalInvocationID.x;\n    result[n] = textureLod(table, uvw[n]." +
        (flat ? "xy" : "xyz") + ", 0.0);\n}\n";
    const support::Program program = support::link_program({{GL_COMPUTE_SHADER, text, {"filtering"}}});
    support::Buffer buffers[2] = {support::create_buffer(), support::create_buffer()};
    for (GLuint n = 0; n < 2; ++n) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, n, buffers[n]);
        glBufferData(GL_SHADER_STORAGE_BUFFER, GLsizeiptr(uvw.size() * sizeof(vec4)),
                     n == 0 ? uvw.data() : nullptr, GL_STATIC_DRAW);
    }
    glUseProgram(program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(flat ? GL_TEXTURE_2D : GL_TEXTURE_3D, texture);
    glDispatchCompute(GLuint(uvw.size() / 64), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<vec4> result(uvw.size());
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(result.size() * sizeof(vec4)), result.data());
    support::check_gl("filtering");
    return result;
}

/// Places in and around the table: anywhere, on centres, on the lines between them, outside.
std::vector<vec4> drawn_places(const support::TableSize& size, airlight_test::Random& random) {
    const int sizes[3] = {size.width, size.height, size.depth};
    std::vector<vec4> uvw(places, vec4(0));
    for (vec4& place : uvw) {
        for (int axis = 0; axis < 3; ++axis) {
            const float texel = 1.0F / float(sizes[axis]);
            switch (random.below(4)) {
                case 0:
                    place[axis] = (float(random.below(sizes[axis])) + 0.5F) * texel;
                    break;
                case 1:
                    place[axis] = float(random.below(sizes[axis] + 1)) * texel;
                    break;
                default:
                    place[axis] = float(random.uniform(-0.2, 1.2));
            }
        }
    }
    return uvw;
}

/// Prints the largest difference, as a share of the table's range, and whether it is within what the driver's
/// filter weights can explain.
bool compare(const std::string& name, GLenum format, const support::TableSize& size, bool flat,
             bool software) {
    airlight_test::Random random(17);
    Table<vec4> table = airlight::make_table<vec4>(size.width, size.height, size.depth);
    airlight::bake_table(table, [&](int, int, int) {
        vec4 texel;
        for (int c = 0; c < 4; ++c) {
            texel[c] = float(random.unit());
            if (format == GL_RGBA16F) {
                texel[c] = support::rounded_to_half(texel[c]);  // what the texture is going to hold
            }
        }
        return texel;
    });
    const support::TableShape shape = flat ? support::TableShape::flat : support::TableShape::volume;
    const support::Texture texture = support::create_table_texture(format, size, shape);
    support::upload_table(texture, size, support::numbers_of(table), 4, shape);
    if (support::download_table(texture, size, 4, shape) != support::numbers_of(table)) {
        std::printf("%s: the texture does not hold what was written\n", name.c_str());
        return false;
    }

    const std::vector<vec4> uvw = drawn_places(size, random);
    const std::vector<vec4> by_gl = filtered_by_gl(texture, flat, uvw);
    double worst = 0;
    vec4 where(0);
    for (int n = 0; n < places; ++n) {
        const vec4& at = uvw[std::size_t(n)];
        const vec4 by_cpu = flat ? airlight::sample(table, vec2<float>(at.x, at.y))
                                 : airlight::sample(table, vec3<float>(at.x, at.y, at.z));
        for (int c = 0; c < 4; ++c) {
            const double off = std::fabs(double(by_gl[std::size_t(n)][c]) - double(by_cpu[c]));
            if (!(off <= worst)) {
                worst = off;
                where = at;
            }
        }
    }
    // Software GL mixes in float: a coordinate times a size rounds to half an ulp of at most 1.2 * 33 texels,
    // a weight of 4e-6, for each axis. Hardware keeps as few as 8 bits of a weight: 2^-9 for each axis.
    // Texels are in [0, 1].
    const int axes = flat ? 2 : 3;
    const double bound = axes * (software ? 4e-6 : 1.0 / 512.0 + 4e-6);
    std::printf("%s: worst %.3g of the table's range at (%.9g, %.9g, %.9g), bound %.3g, %d places: %s\n",
                name.c_str(), worst, double(where.x), double(where.y), double(where.z), bound, places,
                worst <= bound ? "passed" : "FAILED");
    return worst <= bound;
}

}  // namespace

int main() {
    try {
        const std::unique_ptr<support::GlContext> context = support::open_context();
        if (context == nullptr) {
            return support::skipped;
        }
        const bool software = support::is_software(context->renderer());
        std::printf("%s\n", context->renderer().c_str());
        bool passed = true;
        passed = compare("two dimensions, 32 bits", GL_RGBA32F, {33, 16, 1}, true, software) && passed;
        passed = compare("two dimensions, 16 bits", GL_RGBA16F, {33, 16, 1}, true, software) && passed;
        passed = compare("three dimensions, 32 bits", GL_RGBA32F, {16, 9, 5}, false, software) && passed;
        passed = compare("three dimensions, 16 bits", GL_RGBA16F, {16, 9, 5}, false, software) && passed;
        return passed ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "filtering_test: " << error.what() << "\n";
        return 1;
    }
}
