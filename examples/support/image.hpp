#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace support {

/// Images larger than this on a side are refused.
inline constexpr int max_image_size = 16384;

/// 8 bits a channel, red green blue, the top row first.
struct Picture {
    int width;
    int height;
    std::vector<std::uint8_t> pixels;  ///< 3 per pixel
};

/// One channel, the top row first; 8-bit files are not stretched to 16 bits.
struct GreyImage {
    int width;
    int height;
    std::vector<std::uint16_t> pixels;
};

/// A channel of an OpenEXR file. A dot makes a layer: "normal.X".
struct ExrChannel {
    std::string name;
    std::vector<float> pixels;  ///< the top row first
};

/// Float channels of one size, with text attributes in the header (such as units).
struct ExrImage {
    int width;
    int height;
    std::vector<ExrChannel> channels;
    std::map<std::string, std::string> attributes;
    bool half_float = false;  ///< written with 16 bits a number, which rounds them; else with 32
};

/// The image's channel of this name, or null.
const ExrChannel* find_channel(const ExrImage& image, const std::string& name);

/// All of these throw Error. The writers leave either a whole file or none.
Picture read_picture_png(const std::filesystem::path& path);
GreyImage read_grey_png(const std::filesystem::path& path);
void write_png(const std::filesystem::path& path, const Picture& picture);

/// Channels stored as half or whole numbers come as float; subsampled channels are refused.
ExrImage read_exr(const std::filesystem::path& path);
void write_exr(const std::filesystem::path& path, const ExrImage& image);

}  // namespace support
