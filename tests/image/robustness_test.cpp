// Strange sizes, shaders that are missing or wrong, contexts that come and go.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "passes/pass.hpp"
#include "studio.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/gl_test.hpp"

namespace {

using image::LinearPicture;
namespace fs = std::filesystem;

deferred::Settings every_pass(bool half_shafts) {
    deferred::Settings settings;
    settings.shadow_size = 64;
    settings.shafts = deferred::Shafts::march;
    settings.half_shafts = half_shafts;
    return settings;
}

const deferred::Moment moment{image::camera_called("valley"), 20, 250};

LinearPicture picture_of(int width, int height, bool half_shafts = false) {
    image::Studio studio("earth", every_pass(half_shafts), width, height, 8, deferred::TableKind::none);
    return studio.draw(moment);
}

bool sound(const LinearPicture& picture) {
    return std::all_of(picture.radiance.begin(), picture.radiance.end(),
                       [](float x) { return x >= 0 && x < 1e10f; });
}

/// The shaders copied to a folder of their own, which the renderer reads from until this is gone.
class CopiedShaders {
  public:
    CopiedShaders() : folder(fs::temp_directory_path() / ("airlight-shaders-" + std::to_string(::getpid()))) {
        fs::remove_all(folder);
        fs::copy(DEFERRED_SHADER_FOLDER, folder);
        deferred::set_shader_folder(folder);
    }
    CopiedShaders(const CopiedShaders&) = delete;
    CopiedShaders& operator=(const CopiedShaders&) = delete;
    ~CopiedShaders() {
        deferred::set_shader_folder(DEFERRED_SHADER_FOLDER);
        fs::remove_all(folder);
    }

    const fs::path folder;
};

/// What the renderer says when it cannot be made.
std::string complaint() {
    try {
        picture_of(8, 8);
    } catch (const support::Error& error) {
        return error.what();
    }
    return "nothing";
}

}  // namespace

TEST_CASE("a renderer of any size draws, and one of the first size draws the same again") {
    const support::GlContext context;
    const LinearPicture before = picture_of(32, 18);
    CHECK(sound(before));
    for (const bool half_shafts : {false, true}) {
        for (const glm::ivec2& size :
             {glm::ivec2(1, 1), glm::ivec2(1, 8192), glm::ivec2(8192, 1), glm::ivec2(3, 2)}) {
            CAPTURE(size.x);
            CAPTURE(size.y);
            CAPTURE(half_shafts);
            CHECK(sound(picture_of(size.x, size.y, half_shafts)));
        }
    }
    const LinearPicture after = picture_of(32, 18);
    CHECK(before.radiance == after.radiance);  // exact: the same program with the same input
}

TEST_CASE("a second context, after the first is gone, draws the same") {
    std::vector<float> first;
    {
        const support::GlContext context;
        first = picture_of(32, 18).radiance;
    }
    const support::GlContext context;
    CHECK(picture_of(32, 18).radiance == first);  // exact: the same program with the same input
}

TEST_CASE("a shader that is missing is named, whichever it is") {
    const support::GlContext context;
    const CopiedShaders shaders;
    CHECK(complaint() == "nothing");
    for (const char* const name : {"tone.frag", "terrain.vert", "shading.glsl"}) {
        const fs::path aside = shaders.folder / "aside";
        fs::rename(shaders.folder / name, aside);
        const std::string said = complaint();
        CAPTURE(said);
        CHECK(said.find(std::string("\"") + name + "\"") != std::string::npos);
        CHECK(said.find('\n') == std::string::npos);  // one line
        fs::rename(aside, shaders.folder / name);
    }
    CHECK(complaint() == "nothing");
}

TEST_CASE("an error in a shader is shown with its file and line") {
    const support::GlContext context;
    const CopiedShaders shaders;
    for (const char* const name : {"air.frag", "frame.glsl"}) {  // one includes, one is included
        const fs::path file = shaders.folder / name;
        const std::string text = support::read_file(file);
        support::write_file(file, text + "vec3 planted = 1;\n");
        const std::string said = complaint();
        CAPTURE(said);
        const auto line = 1 + std::count(text.begin(), text.end(), '\n');
        // Either driver's way; after a line break, for "preamble of air.frag" is another file.
        const std::string place = std::string("\n") + name;
        CHECK((said.find(place + ":" + std::to_string(line) + "(") != std::string::npos ||
               said.find(place + "(" + std::to_string(line) + ")") != std::string::npos));
        support::write_file(file, text);
    }
}

int main(int argc, char** argv) {
    if (support::open_context() == nullptr) {
        return support::skipped;
    }
    return doctest::Context(argc, argv).run();
}
