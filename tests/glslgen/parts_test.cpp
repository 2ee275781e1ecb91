// The parts of glslgen that the pairs do not show: diff, files, names, the manifest.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "diff.hpp"
#include "files.hpp"
#include "generate.hpp"
#include "names.hpp"
#include "type.hpp"

namespace {

namespace fs = std::filesystem;

fs::path fresh_folder(const std::string& name) {
    const fs::path folder = fs::temp_directory_path() / ("glslgen_test_" + name);
    fs::remove_all(folder);
    return folder;
}

glslgen::Generated generate(const std::string& header) {
    glslgen::ReadOptions options;
    options.root = header;
    options.include_folders = {AIRLIGHT_INCLUDE};
    options.system_folders = {AIRLIGHT_GLM_INCLUDE};
    return glslgen::generate(options);
}

}  // namespace

TEST_CASE("a diff of equal texts is empty") {
    CHECK(glslgen::unified_diff("a\nb\n", "a\nb\n", "x", "y") == "");
}

TEST_CASE("a diff shows a changed line between three lines of context, with its line numbers") {
    CHECK(glslgen::unified_diff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n", "x", "y") ==
          "--- x\n+++ y\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
}

TEST_CASE("changes far apart stand in hunks of their own, and the second knows of the first") {
    const std::string before = "a\n1\n2\n3\n4\n5\n6\n7\nb\n";
    const std::string after = "a\nnew\n1\n2\n3\n4\n5\n6\n7\n";
    CHECK(glslgen::unified_diff(before, after, "x", "y") ==
          "--- x\n+++ y\n@@ -1,4 +1,5 @@\n a\n+new\n 1\n 2\n 3\n@@ -6,4 +7,3 @@\n 5\n 6\n 7\n-b\n");
}

TEST_CASE("a diff against nothing adds every line behind line 0") {
    CHECK(glslgen::unified_diff("", "a\nb\n", "x", "y") == "--- x\n+++ y\n@@ -0,0 +1,2 @@\n+a\n+b\n");
}

TEST_CASE("a diff tells a text without a last newline from one with it") {
    CHECK(glslgen::unified_diff("a", "a\n", "x", "y") != "");
}

TEST_CASE("names follow the one rule that links both languages") {
    CHECK(glslgen::glsl_name("rayleigh_phase") == "airlight_rayleigh_phase");
    CHECK(glslgen::glsl_name("detail::Half") == "airlight_detail_Half");
    CHECK(glslgen::macro_name("mie_phase") == "AIRLIGHT_MIE_PHASE");
    CHECK(glslgen::macro_name("Visibility") == "AIRLIGHT_VISIBILITY");
    CHECK(glslgen::macro_name("TransmittanceToSpace") == "AIRLIGHT_TRANSMITTANCE_TO_SPACE");
}

TEST_CASE("a file is written once and not touched again while its text stays") {
    const fs::path folder = fresh_folder("files");
    const std::string path = (folder / "deeper" / "text").string();
    CHECK(glslgen::write_text(path, "one\n"));
    const fs::file_time_type written = fs::last_write_time(path);
    CHECK_FALSE(glslgen::write_text(path, "one\n"));
    CHECK(fs::last_write_time(path) == written);
    CHECK(glslgen::write_text(path, "two\n"));
    CHECK(glslgen::read_text(path).value_or("") == "two\n");
    CHECK_FALSE(fs::exists(path + ".part"));
    fs::remove_all(folder);
}

TEST_CASE("a file that cannot be written says so and leaves nothing behind") {
    const fs::path folder = fresh_folder("unwritable");
    fs::create_directories(folder);
    std::ofstream(folder / "file") << "no folder\n";
    CHECK_THROWS_AS(glslgen::write_text((folder / "file" / "text").string(), "x"), glslgen::Failure);
    CHECK(glslgen::read_text((folder / "file").string()).value_or("") == "no folder\n");
    fs::remove_all(folder);
}

TEST_CASE("a header that is not there is a failure that names it") {
    CHECK_THROWS_WITH_AS(generate("/nowhere/at_all.hpp"),
                         "cannot read /nowhere/at_all.hpp: give the path of an existing header",
                         glslgen::Failure);
}

TEST_CASE("the manifest lists flags, hooks and calls, those reached through calls included") {
    const glslgen::Generated generated = generate(std::string(AIRLIGHT_GLSLGEN_TESTS) + "/accept/hook.hpp");
    REQUIRE(generated.refusals.empty());
    const nlohmann::json manifest = nlohmann::json::parse(generated.files.at("manifest.json"));
    const nlohmann::json parameters = nlohmann::json::parse(
        R"([{"type": "vec3", "name": "origin"}, {"type": "vec3", "name": "direction"},
            {"type": "float", "name": "length"}])");
    REQUIRE(manifest["functions"].size() == 2);
    const nlohmann::json& caller = manifest["functions"][1];
    CHECK(caller["name"] == "dark_length");
    CHECK(caller["glsl"] == "airlight_dark_length");
    CHECK(caller["file"] == "airlight/hook.glsl");
    CHECK(caller["parameters"] == parameters);
    CHECK(caller["result"] == "float");
    CHECK(caller["flags"] == nlohmann::json({"steps"}));
    CHECK(caller["hooks"] == nlohmann::json({"Visibility"}));
    CHECK(caller["calls"] == nlohmann::json({"lit_length"}));
    CHECK(manifest["hooks"] ==
          nlohmann::json::parse(R"([{"name": "Visibility", "macro": "AIRLIGHT_VISIBILITY",
                                                          "parameters": ["position"], "default": "1.0"}])"));
    CHECK(manifest["flags"][1] ==
          nlohmann::json::parse(R"({"name": "ozone", "macro": "AIRLIGHT_OZONE", "type": "int",
                                    "default": "AIRLIGHT_OZONE_TENT",
                                    "choices": ["AIRLIGHT_OZONE_NONE", "AIRLIGHT_OZONE_TENT",
                                                "AIRLIGHT_OZONE_LORENTZIAN"]})"));
}
