#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <string>

#include "cost.hpp"
#include "radv.hpp"
#include "spirv.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "table.hpp"
#include "variants.hpp"

namespace {

using namespace shader_cost;

std::unique_ptr<Radv> radv;

/// A shader that does `body` to a number x it has read.
std::string shader(const std::string& body) {
    return "#version 450 core\n"
           "layout(local_size_x = 64) in;\n"
           "layout(std430, binding = 0) readonly buffer Inputs { float in_data[]; };\n"
           "layout(std430, binding = 1) writeonly buffer Results { float out_data[]; };\n"
           "void main() {\n"
           "    int i = int(gl_GlobalInvocationID.x);\n"
           "    float x = in_data[i];\n" +
           body + "    out_data[i] = x;\n}\n";
}

Compiled compiled(const std::string& body) {
    return radv->compile(compile_glsl(shader(body), "a test"));
}

Row row(const std::string& method, double instructions) {
    Row out{method, "2", "default", {}, "none"};
    out.price.counts.instructions = instructions;
    return out;
}

}  // namespace

TEST_CASE("two square roots are two transcendental instructions more") {
    const Compiled none = compiled("");
    const Compiled two = compiled("x = sqrt(x); x = sqrt(x + 1.0);\n");
    CHECK(two.counts.transcendental - none.counts.transcendental == 2);
    CHECK(two.counts.vector - none.counts.vector == 3);  // and one addition
    CHECK(two.counts.instructions > none.counts.instructions);
}

TEST_CASE("a loop that is left rolled hides its passes, and is reported") {
    const auto loop = [](int passes) {
        return "for (int k = 0; k < " + std::to_string(passes) +
               "; ++k) { x = exp2(x) + sqrt(x); x = x > 1.0 ? x * 0.5 : x + log2(x); }\n";
    };
    const Compiled a = compiled(loop(100));
    const Compiled b = compiled(loop(120));
    CHECK(a.has_loops());
    CHECK(a.counts.instructions == b.counts.instructions);
}

TEST_CASE("measure counts every pass, however many there are") {
    const auto job = [](int passes) {
        return Job{"loop", "", "default", {passes}, [](const std::vector<int>& counts) {
                       return shader("for (int k = 0; k < " + std::to_string(counts.at(0)) +
                                     "; ++k) { x = exp2(x) + sqrt(x); }\n");
                   }};
    };
    for (const int passes : {3, 50, 300}) {  // 300 are not unrolled but counted from fewer
        CAPTURE(passes);
        const Row measured = Pricing(*radv).measure(job(passes));
        CHECK(measured.price.counts.transcendental == 2 * passes);
        CHECK(measured.loops == (passes == 3 ? "none" : passes == 50 ? "unrolled" : "extrapolated"));
    }
}

TEST_CASE("loops within loops count as the product of their passes") {
    const Job job{"loops", "", "default", {40, 30}, [](const std::vector<int>& counts) {
                      return shader("for (int k = 0; k < " + std::to_string(counts.at(0)) +
                                    "; ++k) { x = sqrt(x + 1.0); for (int l = 0; l < " +
                                    std::to_string(counts.at(1)) + "; ++l) { x = exp2(x + float(l)); } }\n");
                  }};
    const Row measured = Pricing(*radv).measure(job);
    CHECK(measured.price.counts.transcendental == 40 * (1 + 30));
    CHECK(measured.loops == "extrapolated");
}

TEST_CASE("a loop whose body grows with the passes counts as a square") {
    const Job job{"square",
                  "",
                  "default",
                  {40},
                  [](const std::vector<int>& counts) {
                      const std::string n = std::to_string(counts.at(0));
                      return shader("for (int k = 0; k < " + n +
                                    "; ++k) { x = sqrt(x + 1.0); for (int l = 0; l < " + n +
                                    "; ++l) { x = exp2(x + float(l)); } }\n");
                  },
                  2};
    CHECK(Pricing(*radv).measure(job).price.counts.transcendental == 40 * (1 + 40));
}

TEST_CASE("of loops over pieces, what a test guards counts once for each piece") {
    const auto nodes = [](const std::vector<int>&) {
        return shader(
            "for (int leg = 0; leg < 2; ++leg) {\n"
            "    for (int i = 0; i < 4; ++i) {\n"
            "        if (x > float(leg + 3 * i)) {\n"
            "            for (int j = 0; j < 5; ++j) { x = exp2(x + float(j + 1)); }\n"
            "        }\n"
            "    }\n"
            "}\n");
    };
    Job job{"pieces", "", "default", {}, nodes, 1, {2, 4}, 1};
    const Price one = Pricing(*radv).measure(job).price;
    CHECK(one.counts.transcendental == 5);
    job.pieces = 3;
    const Price three = Pricing(*radv).measure(job).price;
    CHECK(three.counts.transcendental == 15);
    CHECK(three.counts.vector - one.counts.vector == 2 * 10);  // an addition and an exp at each node
    CHECK(three.inverse_throughput == 8 * 15);                 // cycles of an exp on RDNA
    job.piece_passes = {};
    CHECK(Pricing(*radv).measure(job).price.counts.transcendental == 2 * 4 * 5);
}

TEST_CASE("an RDNA GPU takes 2 cycles for a vector instruction and 8 for a transcendental one") {
    const Pricing pricing(*radv);
    CHECK(pricing.rates().vector == doctest::Approx(2).epsilon(0.01));  // a few loads and waits are in it
    CHECK(pricing.rates().transcendental == doctest::Approx(8).epsilon(0.01));
}

TEST_CASE("what is counted is what RADV counts") {
    const Compiled loop =
        compiled("for (int k = 0; k < 100; ++k) { if (x > 2.0) { x = exp2(x); } x = sqrt(x); }\n");
    double sum = 0;
    for (const Block& block : loop.blocks) {
        sum += block.counts.instructions;
    }
    CHECK(loop.counts.instructions == sum);
    CHECK(loop.reported_instructions == sum);
}

TEST_CASE("a shader that is no GLSL is refused with its name") {
    CHECK_THROWS_WITH_AS(compile_glsl("#version 450 core\nvoid main() { x = 1.0; }\n", "the broken one"),
                         doctest::Contains("the broken one"), support::Error);
}

TEST_CASE("the table that is written is the table that is read") {
    const std::vector<Row> rows = {row("one", 12), row("two", 3456789)};
    const Table read = read_csv(csv(rows, "made by a test"), "a test");
    CHECK(read.made_by == "made by a test");
    CHECK(differences(rows, read.rows, false).empty());
    CHECK_THROWS_AS(read_csv("method,setting\n", "a test"), support::Error);
    CHECK_THROWS_AS(read_csv(csv(rows, "made by a test") + "three,,default,none\n", "a test"),
                    support::Error);
}

TEST_CASE("differences name rows that are new, gone or changed") {
    const std::vector<Row> recorded = {row("same", 1), row("changed", 2), row("gone", 3)};
    const std::vector<Row> measured = {row("same", 1), row("changed", 4), row("new", 5)};
    const std::vector<std::string> found = differences(recorded, measured, false);
    REQUIRE(found.size() == 3);
    CHECK(found[0] == "changed, 2: instructions 2 -> 4");
    CHECK(found[1] == "new, 2: is not recorded");
    CHECK(found[2] == "gone, 2: is recorded, but no longer measured");
    CHECK(differences(recorded, measured, true).size() == 2);
}

TEST_CASE("a flag's value is written without what all its values share") {
    const support::Flag ozone{"ozone", "OZONE", "int", "OZONE_TENT", {"OZONE_NONE", "OZONE_TENT"}};
    CHECK(bench::flag_text(ozone, "OZONE_NONE") == "ozone=none");
    CHECK(bench::off_value(ozone) == "OZONE_NONE");
    const support::Flag mie{"mie", "MIE", "bool", "1", {}};
    CHECK(bench::flag_text(mie, "0") == "mie=0");
    CHECK(bench::off_value(mie) == "0");
    const support::Flag phase{"phase", "PHASE", "int", "PHASE_A", {"PHASE_A", "PHASE_B"}};
    CHECK(bench::off_value(phase).empty());
}

TEST_CASE("a function is measured at its steps or nodes, and with each flag at each other value") {
    support::Manifest manifest;
    manifest.flags = {
        {"mie", "MIE", "bool", "1", {}},
        {"nodes", "NODES", "int", "8", {}},
        {"ozone", "OZONE", "int", "OZONE_TENT", {"OZONE_NONE", "OZONE_TENT", "OZONE_LORENTZIAN"}}};
    support::Function function;
    CHECK(bench::settings(manifest, function).size() == 1);

    function.parameters = {{"int", "i"}};  // an index is no number of steps
    CHECK(bench::settings(manifest, function).front().counts.empty());
    function.parameters = {{"float", "distance"}, {"int", "steps"}};
    const std::vector<bench::Variant> marched = bench::settings(manifest, function);
    CHECK(marched.front().setting == "16");
    CHECK(marched.front().counts == std::vector<int>{16});

    function.parameters = {};
    function.flags = {"mie", "nodes", "ozone"};
    const std::vector<bench::Variant> nodes = bench::settings(manifest, function);
    CHECK(nodes.size() == 8);
    CHECK(nodes.front().setting == "8");
    CHECK(nodes.front().values.empty());  // the default needs no macro
    std::string flags;
    for (const bench::Variant& variant : bench::flag_variants(manifest, function, nodes.back())) {
        CHECK(variant.setting == "24");
        CHECK(variant.values.size() == 2);
        flags += variant.flags + " ";
    }
    CHECK(flags == "mie=0 ozone=none ozone=lorentzian ");
}

int main(int argc, char** argv) {
    try {
        radv = std::make_unique<Radv>("navi21");
    } catch (const NoRadv& e) {
        std::cout << (support::environment_asks({"CI", "AIRLIGHT_REQUIRE_RADV"}) ? "FAILED: " : "skipped: ")
                  << e.what() << "\n";
        return support::environment_asks({"CI", "AIRLIGHT_REQUIRE_RADV"}) ? 1 : support::skipped;
    }
    doctest::Context context(argc, argv);
    const int status = context.run();
    radv.reset();  // before the driver's own library goes
    return status;
}
