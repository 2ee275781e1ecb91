#pragma once

// CPU only. A table of light: texels, the way OpenGL filters them, and the loop that fills them. Threads and
// files are the caller's.

#include <airlight/types.hpp>
#include <cstddef>
#include <vector>

namespace airlight {

/// Texels in the order in which OpenGL takes them, x fastest. Depth 1 makes it two-dimensional.
template <typename Texel>
struct Table {
    int width;
    int height;
    int depth;
    std::vector<Texel> texels;

    /// The texel in column i, row j, slice k; no check.
    const Texel& texel(int i, int j, int k) const {
        return texels[(static_cast<std::size_t>(k) * static_cast<std::size_t>(height) +
                       static_cast<std::size_t>(j)) *
                          static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(i)];
    }
    Texel& texel(int i, int j, int k) {
        return const_cast<Texel&>(static_cast<const Table&>(*this).texel(i, j, k));
    }
};

/// A table of that size with every texel Texel(0).
///
/// Units:    sizes in texels.
/// Domain:   sizes >= 1; a size of 0 makes an empty table, which sample reads as Texel(0).
/// Accuracy: exact.
/// Errors:   std::bad_alloc where it does not fit into memory.
/// Source:   none.
template <typename Texel>
Table<Texel> make_table(int width, int height, int depth = 1) {
    const std::size_t count =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(depth);
    return Table<Texel>{width, height, depth, std::vector<Texel>(count, Texel(0))};
}

namespace detail {

/// The two texels along one axis that linear filtering mixes.
template <typename T>
struct AxisTexels {
    int first;
    int second;
    T weight;  // of the second
};

/// Clamped to the edge. The comparison is the one that NaN fails.
template <typename T>
AxisTexels<T> axis_texels(T u, int size) {
    const T at = u * T(size) - T(0.5);
    const T last = T(size - 1);
    if (!(at > T(0))) {
        return AxisTexels<T>{0, 0, T(0)};
    }
    if (at >= last) {
        return AxisTexels<T>{size - 1, size - 1, T(0)};
    }
    const int first = static_cast<int>(at);
    return AxisTexels<T>{first, first + 1, at - T(first)};
}

template <typename Texel, typename T>
Texel mixed(const Texel& a, const Texel& b, T weight) {
    return a * (T(1) - weight) + b * weight;
}

template <typename Texel, typename T>
Texel sample_slice(const Table<Texel>& table, const AxisTexels<T>& x, const AxisTexels<T>& y, int k) {
    return mixed(mixed(table.texel(x.first, y.first, k), table.texel(x.second, y.first, k), x.weight),
                 mixed(table.texel(x.first, y.second, k), table.texel(x.second, y.second, k), x.weight),
                 y.weight);
}

}  // namespace detail

/// The table at texture coordinates, filtered as OpenGL does it: GL_LINEAR, GL_CLAMP_TO_EDGE. The scalar of
/// the texels is that of uv. Two coordinates read the first slice.
///
/// Units:    uv and uvw [1]; result that of the texels.
/// Domain:   every number; a table as make_table returns it.
/// Accuracy: 3 roundoffs of the largest texel for each axis, and a roundoff of the size in the place.
/// Errors:   NaN reads the first texel; an empty table Texel(0).
/// Source:   the OpenGL specification, texture minification by GL_LINEAR.
template <typename Texel, typename T>
Texel sample(const Table<Texel>& table, const vec2<T>& uv) {
    if (table.texels.empty()) {
        return Texel(0);
    }
    return detail::sample_slice(table, detail::axis_texels(uv.x, table.width),
                                detail::axis_texels(uv.y, table.height), 0);
}

template <typename Texel, typename T>
Texel sample(const Table<Texel>& table, const vec3<T>& uvw) {
    if (table.texels.empty()) {
        return Texel(0);
    }
    const detail::AxisTexels<T> x = detail::axis_texels(uvw.x, table.width);
    const detail::AxisTexels<T> y = detail::axis_texels(uvw.y, table.height);
    const detail::AxisTexels<T> z = detail::axis_texels(uvw.z, table.depth);
    return detail::mixed(detail::sample_slice(table, x, y, z.first),
                         detail::sample_slice(table, x, y, z.second), z.weight);
}

/// Texture coordinates of a texel's centre.
///
/// Units:    i, j, k and sizes in texels; result [1].
/// Domain:   a table whose sizes are >= 1; i, j, k from 0 to the size less 1.
/// Accuracy: 1 roundoff.
/// Errors:   none in the domain.
/// Source:   none.
template <typename T, typename Texel>
vec3<T> texel_centre(const Table<Texel>& table, int i, int j, int k = 0) {
    return vec3<T>((T(i) + T(0.5)) / T(table.width), (T(j) + T(0.5)) / T(table.height),
                   (T(k) + T(0.5)) / T(table.depth));
}

/// How bake_table goes through the rows if it is told nothing: on this thread, in order.
struct OneAfterAnother {
    template <typename Body>
    void operator()(int count, const Body& body) const {
        for (int row = 0; row < count; ++row) {
            body(row);
        }
    }
};

/// Fills a table: texel_at(i, j, k) returns what belongs there. rows(count, body) has to call body(row) once
/// for every row from 0 to count - 1, in any order and on any threads: a caller's place for threads and
/// progress. Rows run through all slices.
///
/// Units:    those of texel_at.
/// Domain:   a table as make_table returns it.
/// Accuracy: that of texel_at.
/// Errors:   none; an empty table stays so.
/// Source:   none.
template <typename Texel, typename TexelAt, typename Rows = OneAfterAnother>
void bake_table(Table<Texel>& table, const TexelAt& texel_at, const Rows& rows = Rows{}) {
    rows(table.height * table.depth, [&](int row) {
        const int k = row / table.height;
        const int j = row % table.height;
        for (int i = 0; i < table.width; ++i) {
            table.texel(i, j, k) = texel_at(i, j, k);
        }
    });
}

}  // namespace airlight
