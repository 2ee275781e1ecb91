#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/nodes_for.hpp>
#include <airlight/scene.hpp>

using namespace airlight;

namespace {

struct Measured {
    int nodes;
    bool in_space;
    NodeAir air;
    double sun_mu;  ///< one of the class
    double p95;
    double max;
};

/// The rows of study/results/classes.csv.
std::vector<Measured> measured() {
    std::ifstream file(std::string(AIRLIGHT_TEST_DATA) + "/../../study/results/classes.csv");
    std::vector<Measured> out;
    for (std::string line; std::getline(file, line);) {
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) {
            cells.push_back(cell);
        }
        if (line.empty() || line[0] == '#' || cells.size() != 7 || cells[0] == "nodes") {
            continue;
        }
        const std::string& sun = cells[3];
        const double sun_mu = sun == "sun_mu >= 0.1"        ? 0.5
                              : sun == "0 <= sun_mu < 0.1"  ? 0.05
                              : sun == "-0.1 <= sun_mu < 0" ? -0.05
                                                            : -0.5;
        const NodeAir air = cells[2] == "ozone"   ? NodeAir::ozone
                            : cells[2] == "thick" ? NodeAir::thick
                                                  : NodeAir::clear;
        out.push_back({std::stoi(cells[0]), cells[1] == "space", air, sun_mu, std::stod(cells[5]),
                       std::stod(cells[6])});
    }
    return out;
}

struct Scene : DefaultScene {
    static constexpr int nodes = nodes_for(0.01, -0.05);
};

}  // namespace

TEST_SUITE_BEGIN("nodes_for");

TEST_CASE("the table is the study's, rounded up to two digits") {
    const std::vector<Measured> rows = measured();
    REQUIRE(rows.size() == 15 * 8);
    for (const Measured& row : rows) {
        CAPTURE(row.nodes);
        CAPTURE(row.sun_mu);
        CAPTURE(row.in_space);
        const double p95 = node_error(row.nodes, row.sun_mu, row.air, row.in_space, NodeError::p95);
        const double max = node_error(row.nodes, row.sun_mu, row.air, row.in_space, NodeError::max);
        // Two digits, rounded up: at most a tenth more. If this fails, run study/nodes_table.py.
        CHECK(p95 >= row.p95);
        CHECK(p95 <= 1.1 * row.p95);
        CHECK(max >= row.max);
        CHECK(max <= 1.1 * row.max);
        CHECK(p95 <= max);
    }
}

TEST_CASE("nodes_for gives the fewest nodes within the tolerance, in the compiler") {
    static_assert(nodes_for(1.0, 0.5) == 4, "any setting is within 100 %");
    static_assert(nodes_for(1e-12, 0.5) == 24, "none is within 1e-12");
    CHECK(node_error(Scene::nodes, -0.05) <= 0.01);
    for (const NodeAir air : {NodeAir::clear, NodeAir::ozone, NodeAir::thick}) {
        for (const double sun_mu : {1.0, 0.05, -0.05, -0.3}) {
            int before = 4;
            for (const double tolerance : {0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003}) {
                const int nodes = nodes_for(tolerance, sun_mu, air, false, NodeError::max);
                CHECK(nodes >= before);  // a smaller tolerance never takes fewer
                before = nodes;
                const bool kept = node_error(nodes, sun_mu, air, false, NodeError::max) <= tolerance;
                CHECK((kept || nodes == 24));
                for (const int fewer : node_counts) {
                    if (fewer < nodes) {
                        CHECK(node_error(fewer, sun_mu, air, false, NodeError::max) > tolerance);
                    }
                }
            }
        }
    }
}

TEST_CASE("a count without a rule of Gauss has no measured error") {
    CHECK(node_error(7, 0.5) == 1.0);
}

TEST_SUITE_END();
