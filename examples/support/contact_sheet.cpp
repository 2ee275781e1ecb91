// Many pictures on one sheet, each with its file's name under it.

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "support/error.hpp"
#include "support/image.hpp"

namespace {

constexpr int gap = 8;           // [pixels] around each picture
constexpr int letter_width = 6;  // [pixels] with the space after it
constexpr int letter_height = 7;
constexpr int label_height = letter_height + 6;
constexpr std::uint8_t paper = 24;
constexpr std::uint8_t ink = 220;

/// Letters of 5 x 7 dots: a row is a number below 32, its highest bit the leftmost dot.
const std::map<char, std::array<int, letter_height>>& letters() {
    static const std::map<char, std::array<int, letter_height>> all = {
        {'a', {0, 0, 14, 1, 15, 17, 15}},    {'b', {16, 16, 30, 17, 17, 17, 30}},
        {'c', {0, 0, 14, 17, 16, 17, 14}},   {'d', {1, 1, 15, 17, 17, 17, 15}},
        {'e', {0, 0, 14, 17, 31, 16, 14}},   {'f', {6, 9, 8, 28, 8, 8, 8}},
        {'g', {0, 0, 15, 17, 15, 1, 14}},    {'h', {16, 16, 30, 17, 17, 17, 17}},
        {'i', {4, 0, 12, 4, 4, 4, 14}},      {'j', {2, 0, 6, 2, 2, 18, 12}},
        {'k', {16, 16, 18, 20, 24, 20, 18}}, {'l', {12, 4, 4, 4, 4, 4, 14}},
        {'m', {0, 0, 26, 21, 21, 21, 21}},   {'n', {0, 0, 30, 17, 17, 17, 17}},
        {'o', {0, 0, 14, 17, 17, 17, 14}},   {'p', {0, 0, 30, 17, 30, 16, 16}},
        {'q', {0, 0, 15, 17, 15, 1, 1}},     {'r', {0, 0, 22, 25, 16, 16, 16}},
        {'s', {0, 0, 15, 16, 14, 1, 30}},    {'t', {8, 8, 28, 8, 8, 9, 6}},
        {'u', {0, 0, 17, 17, 17, 17, 15}},   {'v', {0, 0, 17, 17, 17, 10, 4}},
        {'w', {0, 0, 17, 21, 21, 21, 10}},   {'x', {0, 0, 17, 10, 4, 10, 17}},
        {'y', {0, 0, 17, 17, 15, 1, 14}},    {'z', {0, 0, 31, 2, 4, 8, 31}},
        {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
        {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {14, 17, 1, 6, 1, 17, 14}},
        {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
        {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 4, 4, 4}},
        {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
        {'+', {0, 4, 4, 31, 4, 4, 0}},       {'-', {0, 0, 0, 31, 0, 0, 0}},
        {'_', {0, 0, 0, 0, 0, 0, 31}},       {'.', {0, 0, 0, 0, 0, 12, 12}},
    };
    return all;
}

class Sheet {
  public:
    Sheet(int width, int height)
        : picture{width, height,
                  std::vector<std::uint8_t>(3 * std::size_t(width) * std::size_t(height), paper)} {}

    void set(int x, int y, int channel, std::uint8_t value) {
        if (x >= 0 && x < picture.width && y >= 0 && y < picture.height) {
            picture.pixels[3 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) +
                           std::size_t(channel)] = value;
        }
    }

    void write(int left, int top, int width, const std::string& text) {
        const std::size_t room = std::size_t(std::max(width / letter_width, 0));
        for (std::size_t i = 0; i < std::min(text.size(), room); ++i) {
            const auto letter = letters().find(char(std::tolower(static_cast<unsigned char>(text[i]))));
            for (int y = 0; letter != letters().end() && y < letter_height; ++y) {
                for (int x = 0; x < 5; ++x) {
                    if ((letter->second[std::size_t(y)] >> (4 - x) & 1) != 0) {
                        for (int c = 0; c < 3; ++c) {
                            set(left + int(i) * letter_width + x, top + y, c, ink);
                        }
                    }
                }
            }
        }
    }

    support::Picture picture;
};

/// The picture `width` pixels wide; each pixel the mean of those it covers.
support::Picture scaled(const support::Picture& from, int width) {
    const int height = std::max(1, int(std::lround(double(from.height) * width / from.width)));
    support::Picture to{width, height,
                        std::vector<std::uint8_t>(3 * std::size_t(width) * std::size_t(height))};
    for (int y = 0; y < height; ++y) {
        const int top = int(long(y) * from.height / height);
        const int bottom = std::max(top + 1, int(long(y + 1) * from.height / height));
        for (int x = 0; x < width; ++x) {
            const int left = int(long(x) * from.width / width);
            const int right = std::max(left + 1, int(long(x + 1) * from.width / width));
            for (int c = 0; c < 3; ++c) {
                long sum = 0;
                for (int j = top; j < bottom; ++j) {
                    for (int i = left; i < right; ++i) {
                        sum += from.pixels[3 * (std::size_t(j) * std::size_t(from.width) + std::size_t(i)) +
                                           std::size_t(c)];
                    }
                }
                to.pixels[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x)) + std::size_t(c)] =
                    std::uint8_t(sum / (long(bottom - top) * (right - left)));
            }
        }
    }
    return to;
}

void make_sheet(const std::vector<std::string>& files, int columns, int tile_width,
                const std::string& output) {
    std::vector<support::Picture> tiles;
    for (const std::string& file : files) {
        tiles.push_back(scaled(support::read_picture_png(file), tile_width));
    }
    // A row is as high as its highest picture.
    std::vector<int> row_heights;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (i % std::size_t(columns) == 0) {
            row_heights.push_back(0);
        }
        row_heights.back() = std::max(row_heights.back(), tiles[i].height);
    }
    int height = gap;
    for (const int row_height : row_heights) {
        height += row_height + label_height + gap;
    }
    const int used_columns = std::min(columns, int(tiles.size()));
    const int width = gap + used_columns * (tile_width + gap);
    if (width > support::max_image_size || height > support::max_image_size) {
        throw support::Error("the sheet would be " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels; give a smaller --tile-width");
    }

    Sheet sheet(width, height);
    int top = gap;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int column = int(i) % columns;
        const std::size_t row = i / std::size_t(columns);
        const int left = gap + column * (tile_width + gap);
        const support::Picture& tile = tiles[i];
        for (int y = 0; y < tile.height; ++y) {
            for (int x = 0; x < tile.width; ++x) {
                for (int c = 0; c < 3; ++c) {
                    sheet.set(left + x, top + y, c,
                              tile.pixels[3 * (std::size_t(y) * std::size_t(tile.width) + std::size_t(x)) +
                                          std::size_t(c)]);
                }
            }
        }
        sheet.write(left, top + row_heights[row] + 3, tile_width,
                    std::filesystem::path(files[i]).stem().string());
        if (column == columns - 1) {
            top += row_heights[row] + label_height + gap;
        }
    }
    support::write_png(output, sheet.picture);
    std::cout << output << ": " << tiles.size() << " pictures, " << width << " x " << height << "\n";
}

int whole_number(const std::string& option, const std::string& text, int least, int most) {
    char* end = nullptr;
    const long value = std::strtol(text.c_str(), &end, 10);
    if (text.empty() || *end != 0 || value < least || value > most) {
        throw support::Error(option + " '" + text + "' is out of range; give " + std::to_string(least) +
                             " to " + std::to_string(most));
    }
    return int(value);
}

const char* const usage =
    "usage: contact_sheet [--columns N] [--tile-width PIXELS] --output SHEET.png PICTURE.png...\n";

void run(const std::vector<std::string>& arguments) {
    std::vector<std::string> files;
    std::string output;
    int columns = 4;
    int tile_width = 400;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        if (argument == "--help") {
            std::cout << usage;
            return;
        }
        if (argument.compare(0, 2, "--") != 0) {
            files.push_back(argument);
            continue;
        }
        if (i + 1 == arguments.size()) {
            throw support::Error(argument + " needs a value; see --help");
        }
        const std::string& value = arguments[++i];
        if (argument == "--output") {
            output = value;
        } else if (argument == "--columns") {
            columns = whole_number(argument, value, 1, 100);
        } else if (argument == "--tile-width") {
            tile_width = whole_number(argument, value, 16, 4096);
        } else {
            throw support::Error("there is no option " + argument + "; see --help");
        }
    }
    if (output.empty() || files.empty()) {
        throw support::Error("give --output and at least one picture; see --help");
    }
    make_sheet(files, columns, tile_width, output);
}

}  // namespace

int main(int count, char** arguments) {
    try {
        run(std::vector<std::string>(arguments + 1, arguments + count));
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "contact_sheet: " << error.what() << "\n";
        return 1;
    }
}
