#pragma once

// Tables of light as OpenEXR files that say what they hold and for which air.

#include <airlight/atmosphere.hpp>
#include <airlight/scene.hpp>
#include <airlight/tables/table.hpp>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace support {

/// How a file stores the numbers of its texels.
enum class TableFormat { half_float, single_float };

/// Names and values of everything that texels depend on, as text that keeps every digit.
using TableWorld = std::map<std::string, std::string>;

/// What a table is. Two tables with the same description hold the same light.
struct TableDescription {
    std::string kind;     ///< "transmittance"
    std::string mapping;  ///< the function that says where it is read: "transmittance_uv"
    std::string payload;  ///< what a texel holds, in words
    std::string units;
    int width;
    int height;
    int depth;
    std::vector<std::string> channels;  ///< "R", or "mie.R"
    bool may_be_negative;               ///< whether a texel below 0 is no error
    std::string storage;                ///< "plain", or "square root", see airlight/table_storage.hpp
    TableWorld world;
};

/// A description and its texels: x fastest, the channels of a texel side by side.
struct StoredTable {
    TableDescription about;
    std::vector<float> texels;
};

/// Exact: reading it gives the same number.
std::string number_text(double number);

/// The numbers of an atmosphere and the flags of a scene.
TableWorld table_world(const airlight::Atmosphere<double>& atmosphere);

template <typename Scene>
TableWorld table_world(const airlight::Atmosphere<double>& atmosphere) {
    TableWorld world = table_world(atmosphere);
    world["scene.mie"] = std::to_string(Scene::mie);
    world["scene.ozone"] = std::to_string(Scene::ozone);
    world["scene.mie_phase"] = std::to_string(Scene::mie_phase);
    world["scene.planet_shadow"] = std::to_string(Scene::planet_shadow);
    return world;
}

/// The same table in square roots, as airlight::stored_light makes them.
StoredTable in_roots(const StoredTable& table);

/// The number that is left when a texel is stored as half; infinite beyond 65504.
float rounded_to_half(float number);

/// Slices lie below each other in the picture. Writes a temporary, then renames it: whoever else writes the
/// same file at the same time, it is always one whole table. Throws Error, also for numbers that are not
/// finite, negative without leave, or too large for the format.
void write_table(const std::filesystem::path& path, const StoredTable& table, TableFormat format);

/// Reads the table that `wanted` describes, and no other: throws Error, in one line with what to do, for a
/// file that is not OpenEXR, not whole, not a table, of another kind, size, atmosphere, scene or version of
/// airlight, and for texels that are not finite, or negative without leave.
StoredTable read_table(const std::filesystem::path& path, const TableDescription& wanted);

/// The numbers of tables of one size, whose texels are vec2, vec3 or vec4: table after table in each texel.
template <typename First, typename... Others>
std::vector<typename First::value_type> numbers_of(const airlight::Table<First>& first,
                                                   const airlight::Table<Others>&... others) {
    std::vector<typename First::value_type> numbers;
    const auto append = [&](const auto& texel) {
        for (int c = 0; c < texel.length(); ++c) {
            numbers.push_back(texel[c]);
        }
    };
    for (std::size_t n = 0; n < first.texels.size(); ++n) {
        append(first.texels[n]);
        (append(others.texels[n]), ...);
    }
    return numbers;
}

/// The inverse for one table, also of another type that is nothing but floats. The description's channels
/// must be as many as a texel has numbers.
template <typename Texel>
airlight::Table<Texel> table_of(const StoredTable& stored) {
    static_assert(sizeof(Texel) % sizeof(float) == 0);
    airlight::Table<Texel> table{stored.about.width, stored.about.height, stored.about.depth, {}};
    const auto* first = reinterpret_cast<const Texel*>(stored.texels.data());
    table.texels.assign(first, first + stored.texels.size() / (sizeof(Texel) / sizeof(float)));
    return table;
}

}  // namespace support
