#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "folder.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/glsl_source.hpp"
#include "support/image.hpp"
#include "support/parallel.hpp"

namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("an OpenEXR file gives back its channels to the bit, and its attributes") {
    const Folder folder;
    const float infinity = std::numeric_limits<float>::infinity();
    const support::ExrImage image{
        3,
        2,
        {{"depth.Z", {0, 1e-38f, 0.1f, infinity, 6.371e6f, -2}}, {"radiance.R", {1, 2, 3, 4, 5, 6}}},
        {{"depthUnits", "metres"}}};
    support::write_exr(folder.path / "a.exr", image);
    CHECK(folder.files() == 1);  // the temporary is gone

    const support::ExrImage read = support::read_exr(folder.path / "a.exr");
    CHECK(read.width == 3);
    CHECK(read.height == 2);
    REQUIRE(read.channels.size() == 2);
    for (std::size_t c = 0; c < 2; ++c) {
        CHECK(read.channels[c].name == image.channels[c].name);      // both in alphabetical order
        CHECK(read.channels[c].pixels == image.channels[c].pixels);  // exact: 32-bit floats, lossless
    }
    CHECK(read.attributes.at("depthUnits") == "metres");
}

TEST_CASE("a truncated OpenEXR file is refused by name") {
    const Folder folder;
    const std::filesystem::path path = folder.path / "a.exr";
    support::write_exr(path, {64, 64, {{"Y", std::vector<float>(4096, 0.5f)}}, {}});
    const std::string bytes = support::read_file(path);
    for (const std::size_t size : {std::size_t(0), std::size_t(3), std::size_t(100), bytes.size() / 2}) {
        CAPTURE(size);
        support::write_file(path, bytes.substr(0, size));
        const std::string message = complaint([&] { support::read_exr(path); });
        CHECK(contains(message, "a.exr"));
        CHECK(contains(message, "not a whole OpenEXR file"));
    }
}

TEST_CASE("a PNG file gives back its pixels") {
    const Folder folder;
    const support::Picture picture{2, 2, {0, 1, 2, 3, 4, 5, 250, 251, 252, 253, 254, 255}};
    support::write_png(folder.path / "a.png", picture);
    CHECK(folder.files() == 1);
    const support::Picture read = support::read_picture_png(folder.path / "a.png");
    CHECK(read.width == 2);
    CHECK(read.height == 2);
    CHECK(read.pixels == picture.pixels);
}

TEST_CASE("a colour PNG is refused where heights are wanted") {
    const Folder folder;
    support::write_png(folder.path / "a.png", {1, 1, {1, 2, 3}});
    CHECK(contains(complaint([&] { support::read_grey_png(folder.path / "a.png"); }),
                   "is not a grey PNG of 8 or 16 bits"));
}

TEST_CASE("every truncation of a PNG file is refused, none crashes") {
    const Folder folder;
    const std::filesystem::path path = folder.path / "a.png";
    support::write_png(path, {8, 8, std::vector<std::uint8_t>(192, 77)});
    const std::string bytes = support::read_file(path);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        CAPTURE(size);
        support::write_file(path, bytes.substr(0, size));
        CHECK(contains(complaint([&] { support::read_picture_png(path); }), "not a whole PNG file"));
    }
}

TEST_CASE("a write that fails leaves the old file as it was, and no temporary") {
    const Folder folder;
    const std::filesystem::path path = folder.path / "a";
    std::filesystem::create_directories(path / "in_the_way");  // a folder cannot be replaced by a file
    CHECK(contains(complaint([&] { support::write_file(path, "new"); }), "cannot write"));
    CHECK(folder.files() == 1);
    CHECK(contains(complaint([&] { support::write_file(folder.path / "none" / "a", "new"); }),
                   "No such file or directory"));
}

TEST_CASE("a folder below a file cannot be made, and the message says so") {
    const Folder folder;
    support::write_file(folder.path / "file", "");
    CHECK(contains(complaint([&] { support::make_writable_directory(folder.path / "file" / "b"); }),
                   "choose another output folder"));
    CHECK(complaint([&] { support::make_writable_directory(folder.path / "b" / "c"); }).empty());
    CHECK(std::filesystem::is_directory(folder.path / "b" / "c"));
}

TEST_CASE("each GLSL file is included once, and line numbers stay true") {
    const Folder folder;
    support::write_file(folder.path / "a.glsl", "#include \"b.glsl\"\nfloat a;\n");
    support::write_file(folder.path / "b.glsl", "float b;\n");
    const support::ExpandedGlsl source = support::expand_includes(
        "#version 430 core\n#include \"a.glsl\"\n  #include \"b.glsl\"\nvoid main() {}\n", "main",
        {folder.path});
    CHECK(source.text ==
          "#version 430 core\n"
          "#line 1 1\n"
          "#line 1 2\n"
          "float b;\n"
          "#line 2 1\n"
          "float a;\n"
          "#line 3 0\n"
          "#line 4 0\n"
          "void main() {}\n");
    CHECK(source.names == std::vector<std::string>{"main", "a.glsl", "b.glsl"});
}

TEST_CASE("an include that is nowhere is named with the file that wants it") {
    const std::string message =
        complaint([] { support::expand_includes("#include \"none.glsl\"\n", "main", {"/"}); });
    CHECK(contains(message, "'main' includes \"none.glsl\""));
}

TEST_CASE("every row is worked on once") {
    std::vector<std::atomic<int>> visits(1000);
    support::for_each_row(int(visits.size()), [&](int y) { ++visits[std::size_t(y)]; });
    for (const std::atomic<int>& count : visits) {
        CHECK(count == 1);
    }
    support::for_each_row(0, [](int) { FAIL("there is no row"); });
}
