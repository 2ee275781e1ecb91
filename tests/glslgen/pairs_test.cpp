// Each accept/*.hpp has the GLSL that it must become, each reject/*.hpp the refusals that it must earn.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "diff.hpp"
#include "files.hpp"
#include "generate.hpp"

namespace {

namespace fs = std::filesystem;

const std::string source_folder = AIRLIGHT_GLSLGEN_TESTS;

glslgen::Generated generate(const fs::path& header) {
    glslgen::ReadOptions options;
    options.root = header.string();
    options.include_folders = {AIRLIGHT_INCLUDE, source_folder + "/headers"};
    options.system_folders = {source_folder + "/names_of_glm"};
    return glslgen::generate(options);
}

std::string as_text(const std::vector<glslgen::Refusal>& refusals) {
    std::string text;
    for (const glslgen::Refusal& refusal : refusals) {
        text += refusal.file + ":" + std::to_string(refusal.line) + ": " + refusal.reason + "\n";
    }
    return text;
}

std::vector<fs::path> headers_in(const std::string& folder) {
    std::vector<fs::path> headers;
    for (const fs::directory_entry& entry : fs::directory_iterator(source_folder + "/" + folder)) {
        if (entry.path().extension() == ".hpp") {
            headers.push_back(entry.path());
        }
    }
    std::sort(headers.begin(), headers.end());
    return headers;
}

void check_equal(const fs::path& expected_file, const std::string& got) {
    const std::optional<std::string> expected = glslgen::read_text(expected_file.string());
    REQUIRE_MESSAGE(expected.has_value(), "there is no " << expected_file.string() << "; it would hold\n"
                                                         << got);
    const std::string difference =
        glslgen::unified_diff(*expected, got, expected_file.string() + " (expected)", "generated");
    CHECK_MESSAGE(difference.empty(), difference);
}

}  // namespace

TEST_CASE("every header of accept becomes the GLSL beside it") {
    const std::vector<fs::path> headers = headers_in("accept");
    REQUIRE(headers.size() >= 20);  // an empty folder would pass
    for (const fs::path& header : headers) {
        CAPTURE(header.filename().string());
        const glslgen::Generated generated = generate(header);
        CHECK(as_text(generated.refusals) == "");
        check_equal(fs::path(header).replace_extension(".glsl"), generated.root_file);
    }
}

TEST_CASE("every header of reject is refused with file, line and the reason beside it") {
    const std::vector<fs::path> headers = headers_in("reject");
    REQUIRE(headers.size() >= 100);  // an empty folder would pass
    for (const fs::path& header : headers) {
        CAPTURE(header.filename().string());
        const glslgen::Generated generated = generate(header);
        CHECK(generated.files.empty());
        CHECK(generated.root_file.empty());
        check_equal(fs::path(header).replace_extension(".txt"), as_text(generated.refusals));
    }
}

TEST_CASE("no expectation lies around without its header") {
    for (const char* folder : {"accept", "reject"}) {
        for (const fs::directory_entry& entry : fs::directory_iterator(source_folder + "/" + folder)) {
            CAPTURE(entry.path().string());
            CHECK(fs::exists(fs::path(entry.path()).replace_extension(".hpp")));
        }
    }
}
