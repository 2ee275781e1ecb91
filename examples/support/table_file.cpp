#include "support/table_file.hpp"

#include <half.h>

#include <airlight/table_storage.hpp>
#include <cmath>
#include <cstdio>

#include "support/error.hpp"
#include "support/image.hpp"

namespace support {
namespace {

const std::string prefix = "airlight.";

std::string size_text(const TableDescription& about) {
    return std::to_string(about.width) + " x " + std::to_string(about.height) + " x " +
           std::to_string(about.depth);
}

/// What the header of the file says, world and all.
std::map<std::string, std::string> header_of(const TableDescription& about) {
    std::map<std::string, std::string> header = {
        {prefix + "version", AIRLIGHT_VERSION}, {prefix + "kind", about.kind},
        {prefix + "mapping", about.mapping},    {prefix + "payload", about.payload},
        {prefix + "units", about.units},        {prefix + "storage", about.storage},
        {prefix + "size", size_text(about)}};
    for (const auto& [name, value] : about.world) {
        header[prefix + "world." + name] = value;
    }
    return header;
}

/// Why the numbers cannot be a table's, or nothing.
std::string bad_number(const TableDescription& about, const std::vector<float>& texels) {
    const std::size_t channels = about.channels.size();
    for (std::size_t n = 0; n < texels.size(); ++n) {
        if (!std::isfinite(texels[n]) || (texels[n] < 0.0F && !about.may_be_negative)) {
            const std::size_t texel = n / channels;
            const auto width = std::size_t(about.width);
            const auto height = std::size_t(about.height);
            return "channel " + about.channels[n % channels] + " of texel (" + std::to_string(texel % width) +
                   ", " + std::to_string(texel / width % height) + ", " +
                   std::to_string(texel / width / height) + ") is " + number_text(double(texels[n]));
        }
    }
    return "";
}

std::size_t number_count(const TableDescription& about) {
    return std::size_t(about.width) * std::size_t(about.height) * std::size_t(about.depth) *
           about.channels.size();
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why,
                         const std::string& advice) {
    throw Error("'" + path.string() + "' " + why + "; " + advice);
}

/// The first thing in which a file's header differs from what is wanted.
void check_header(const std::filesystem::path& path, const std::map<std::string, std::string>& found,
                  const TableDescription& wanted) {
    const std::string bake = "bake it anew with bake_tables";
    const auto value = [&](const std::string& name) {
        const auto entry = found.find(prefix + name);
        return entry == found.end() ? std::string() : entry->second;
    };
    if (value("kind").empty()) {
        refuse(path, "is an OpenEXR picture but no table of airlight", "bake one with bake_tables");
    }
    if (value("version") != AIRLIGHT_VERSION) {
        refuse(path, "is by airlight " + value("version") + ", and this is " + AIRLIGHT_VERSION, bake);
    }
    if (value("kind") != wanted.kind) {
        refuse(path, "holds a table of " + value("kind") + ", not of " + wanted.kind, "give another file");
    }
    if (value("mapping") != wanted.mapping) {
        refuse(path, "is read by " + value("mapping") + ", not by " + wanted.mapping, bake);
    }
    if (value("storage") != wanted.storage) {
        refuse(path, "holds " + value("storage") + " numbers, not " + wanted.storage + " ones",
               "bake it anew with bake_tables --format, or ask for what it holds");
    }
    if (value("size") != size_text(wanted)) {
        refuse(path, "has " + value("size") + " texels, not " + size_text(wanted),
               "bake it anew with bake_tables --size, or ask for that size");
    }
    std::map<std::string, std::string> differing = header_of(wanted);
    for (const auto& [name, text] : found) {
        if (name.compare(0, prefix.size() + 6, prefix + "world.") == 0) {
            differing.insert({name, ""});
        }
    }
    for (const auto& [name, text] : differing) {
        const auto entry = found.find(name);
        const std::string there = entry == found.end() ? "" : entry->second;
        if (there != text) {
            refuse(path,
                   "was made for another world (" + name.substr(prefix.size()) + " is " +
                       (there.empty() ? "missing" : there) + " there, " + (text.empty() ? "nothing" : text) +
                       " here)",
                   bake + " for this one");
        }
    }
}

}  // namespace

std::string number_text(double number) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}

TableWorld table_world(const airlight::Atmosphere<double>& atmosphere) {
    TableWorld world;
    const auto scalar = [&](const std::string& name, double number) {
        world["atmosphere." + name] = number_text(number);
    };
    const auto spectrum = [&](const std::string& name, const airlight::vec3<double>& numbers) {
        scalar(name + ".r", numbers.x);
        scalar(name + ".g", numbers.y);
        scalar(name + ".b", numbers.z);
    };
    scalar("ground_radius", atmosphere.ground_radius);
    scalar("top_altitude", atmosphere.top_altitude);
    spectrum("rayleigh_scattering", atmosphere.rayleigh_scattering);
    scalar("rayleigh_scale_height", atmosphere.rayleigh_scale_height);
    spectrum("mie_scattering", atmosphere.mie_scattering);
    spectrum("mie_absorption", atmosphere.mie_absorption);
    scalar("mie_scale_height", atmosphere.mie_scale_height);
    scalar("mie_g", atmosphere.mie_g);
    spectrum("ozone_absorption", atmosphere.ozone_absorption);
    scalar("ozone_altitude", atmosphere.ozone_altitude);
    scalar("ozone_half_width", atmosphere.ozone_half_width);
    spectrum("ground_albedo", atmosphere.ground_albedo);
    return world;
}

StoredTable in_roots(const StoredTable& table) {
    StoredTable roots = table;
    roots.about.storage = "square root";
    for (float& number : roots.texels) {
        number = airlight::stored_light(airlight::vec3<float>(number)).x;
    }
    return roots;
}

float rounded_to_half(float number) {
    return float(half(number));
}

void write_table(const std::filesystem::path& path, const StoredTable& table, TableFormat format) {
    const TableDescription& about = table.about;
    if (table.texels.size() != number_count(about)) {
        throw Error("cannot write '" + path.string() + "': " + std::to_string(table.texels.size()) +
                    " numbers are not a table of " + size_text(about) + " texels of " +
                    std::to_string(about.channels.size()) + "; this is an error of the program");
    }
    std::vector<float> texels = table.texels;
    if (format == TableFormat::half_float) {
        for (float& number : texels) {
            number = rounded_to_half(number);
        }
    }
    const std::string bad = bad_number(about, texels);
    if (!bad.empty()) {
        throw Error(
            "cannot write '" + path.string() + "': " + bad +
            (format == TableFormat::half_float ? "; try the format float" : "; check the atmosphere"));
    }

    ExrImage image{about.width, about.height * about.depth, {}, header_of(about)};
    image.half_float = format == TableFormat::half_float;
    const std::size_t channels = about.channels.size();
    for (std::size_t c = 0; c < channels; ++c) {
        ExrChannel channel{about.channels[c], std::vector<float>(texels.size() / channels)};
        for (std::size_t n = 0; n < channel.pixels.size(); ++n) {
            channel.pixels[n] = texels[n * channels + c];
        }
        image.channels.push_back(std::move(channel));
    }
    write_exr(path, image);
}

StoredTable read_table(const std::filesystem::path& path, const TableDescription& wanted) {
    const ExrImage image = read_exr(path);
    check_header(path, image.attributes, wanted);
    if (image.width != wanted.width || image.height != wanted.height * wanted.depth) {
        refuse(path, "has another size than its header says", "bake it anew with bake_tables");
    }
    StoredTable table{wanted, std::vector<float>(number_count(wanted))};
    const std::size_t channels = wanted.channels.size();
    for (std::size_t c = 0; c < channels; ++c) {
        const ExrChannel* const found = find_channel(image, wanted.channels[c]);
        if (found == nullptr || image.channels.size() != channels) {
            refuse(path, "has other channels than a table of " + wanted.kind,
                   "bake it anew with bake_tables");
        }
        for (std::size_t n = 0; n < found->pixels.size(); ++n) {
            table.texels[n * channels + c] = found->pixels[n];
        }
    }
    const std::string bad = bad_number(wanted, table.texels);
    if (!bad.empty()) {
        refuse(path, "is damaged: " + bad, "bake it anew with bake_tables");
    }
    return table;
}

}  // namespace support
