// What the study's figures rest on: its quadrature, its truth, its counting, its tables.

#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <table.hpp>

#include "../adaptive.hpp"
#include "../counting.hpp"
#include "../csv.hpp"
#include "../reports.hpp"
#include "../texture.hpp"
#include "../truth.hpp"
#include "support/error.hpp"

namespace {

using airlight::vec2;
using airlight::vec3;
using study::Estimate;
using study::Real;
using study::Three;

TEST_CASE("the rule of 15 points is exact for polynomials up to degree 22, that of 7 up to 13") {
    for (int degree = 0; degree <= 22; ++degree) {
        const auto power = [&](Real x) {
            const Real y = std::pow(x, static_cast<Real>(degree));
            return Three{y, 2 * y, -y};
        };
        const Estimate e = study::gauss_kronrod(power, 0.0L, 2.0L);
        const Real exact = std::pow(2.0L, degree + 1) / (degree + 1);
        CAPTURE(degree);
        // 50 roundoffs of long double: 15 products and sums, each a few roundoffs.
        const Real rounding = 50 * std::numeric_limits<Real>::epsilon() * exact;
        CHECK(std::fabs(e.value[0] - exact) <= rounding);
        CHECK(std::fabs(e.value[1] - 2 * exact) <= 2 * rounding);
        CHECK(std::fabs(e.value[2] + exact) <= rounding);
        if (degree <= 13) {
            CHECK(study::size(e.doubt) <= 2 * rounding);
        } else {
            CHECK(study::size(e.doubt) > 2 * rounding);
        }
    }
}

TEST_CASE("halving follows a peak a thousandth as wide as the interval") {
    const auto peak = [](Real x) {
        const Real y = 1e-3L / (1e-6L + x * x);
        return Three{y, 0, 0};
    };
    const Three sum = study::integral(peak, -1.0L, 2.0L,
                                      [](const Estimate& part) { return study::size(part.doubt) <= 1e-12L; });
    const Real exact = std::atan(2000.0L) + std::atan(1000.0L);
    CHECK(std::fabs(sum[0] - exact) <= 1e-11L);  // some ten parts, each sure to 1e-12
}

TEST_CASE("the truth is what mpmath finds with 30 digits") {
    for (const airlight_test::Row& row : airlight_test::read_table(STUDY_TESTS "/truth.csv")) {
        const std::string world = row.text("world");
        std::size_t index = 0;
        while (index < study::worlds().size() && study::worlds()[index].name != world) {
            ++index;
        }
        REQUIRE(index < study::worlds().size());
        const auto at = [&](const char* column) { return row.input<double>(column); };
        const bool open = row.text("distance") == "none";
        const study::View view = {"",
                                  row.text("view"),
                                  index,
                                  {{at("altitude"), vec3<double>(0.0, 0.0, 1.0)},
                                   vec3<double>(at("dx"), at("dy"), at("dz")),
                                   vec3<double>(at("sx"), at("sy"), at("sz")),
                                   open ? std::numeric_limits<double>::infinity() : at("distance")}};
        const study::Truth truth = study::true_radiance(view);
        const vec3<double> expected(static_cast<double>(row.expected("r0")),
                                    static_cast<double>(row.expected("r1")),
                                    static_cast<double>(row.expected("r2")));
        const double largest = std::max({expected.x, expected.y, expected.z});
        CAPTURE(view.name);
        for (int k = 0; k < 3; ++k) {
            CAPTURE(k);
            MESSAGE(view.name << " channel " << k << ": off by "
                              << std::abs(truth.radiance[k] - expected[k]) / largest);
            // The quadrature halves until it is sure to 1e-10; it is then far better than that.
            CHECK(std::abs(truth.radiance[k] - expected[k]) <= 1e-12 * largest);
        }
    }
}

TEST_CASE("the suite has its views in every world, and every name once") {
    const std::vector<study::View> all = study::suite();
    CHECK(all.size() == 125 * study::worlds().size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(std::abs(glm::length(all[i].ray.direction) - 1.0) <= 4e-16);  // rounding of sine and cosine
        for (std::size_t j = 0; j < i; ++j) {
            CHECK_FALSE((all[i].world == all[j].world && all[i].name == all[j].name));
        }
    }
}

TEST_CASE("random rays are the same every time, of unit length, and more of them begin with the same") {
    const std::vector<study::View> few = study::random_views(50);
    const std::vector<study::View> many = study::random_views(100);
    REQUIRE(many.size() == 100);
    for (std::size_t i = 0; i < few.size(); ++i) {
        CHECK(few[i].ray.direction == many[i].ray.direction);  // the same arithmetic on the same numbers
        CHECK(few[i].ray.eye.altitude == many[i].ray.eye.altitude);
        CHECK(std::abs(glm::length(few[i].ray.direction) - 1.0) <= 1e-15);  // rounding of sine and cosine
        CHECK(std::abs(glm::length(few[i].ray.to_sun) - 1.0) <= 1e-15);     // rounding of sine and cosine
    }
}

TEST_CASE("a march of n steps through air without a layer takes the exponentials that it is written with") {
    // Leenman, n by m: two densities at each of n + n m places, three channels at each of n and of the whole.
    std::vector<study::View> views;
    for (const study::View& view : study::suite()) {
        if (study::worlds()[view.world].name == "cs562" && view.kind == "ground") {
            views.push_back(view);
        }
    }
    REQUIRE(!views.empty());
    const study::Operations counted = study::operations({study::Method::leenman, 16, 6}, views);
    CHECK(counted.exponentials == 16 * (2 + 6 * 2 + 3) + 3);  // counted, not rounded: a mean of equal numbers
    CHECK(counted.roots > 16 * (1 + 6));                      // an altitude at each place, besides the ends
}

TEST_CASE("a table gives its texels at their centres, lines between them, and its edge beyond") {
    const study::Texture<double> table(3, 2,
                                       {vec3<double>(0.0), vec3<double>(1.0), vec3<double>(4.0),
                                        vec3<double>(10.0), vec3<double>(20.0), vec3<double>(30.0)});
    const auto at = [&](double u, double v) { return table(vec2<double>(u, v)).x; };
    // Sixths and quarters are rounded, so the texels are met to rounding.
    CHECK(at(0.5 / 3, 0.25) == doctest::Approx(0.0).epsilon(1e-14));
    CHECK(at(1.5 / 3, 0.25) == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(at(2.0 / 3, 0.25) == doctest::Approx(2.5).epsilon(1e-14));
    CHECK(at(2.5 / 3, 0.75) == doctest::Approx(30.0).epsilon(1e-14));
    CHECK(at(0.5, 0.5) == doctest::Approx(10.5).epsilon(1e-14));
    CHECK(at(-1.0, -1.0) == doctest::Approx(0.0).epsilon(1e-14));
    CHECK(at(2.0, 3.0) == doctest::Approx(30.0).epsilon(1e-14));
}

TEST_CASE("a quick table that differs from the recorded one is told, in both directions") {
    study::Csv recorded;
    recorded.columns = {"method", "setting", "max", "p95", "median", "rms"};
    recorded.rows = {{"a", "1", "0.5", "0.25", "0.1", "0.2"}, {"a", "2", "0.5", "0.25", "0.1", "0.2"}};
    study::Csv fresh = recorded;
    CHECK(study::differences(fresh, recorded).empty());
    fresh.rows[0][3] = "0.25001";
    CHECK(study::differences(fresh, recorded).size() == 1);
    fresh.rows[0][3] = "nan";
    CHECK(study::differences(fresh, recorded).size() == 1);
    fresh.rows.pop_back();
    CHECK(study::differences(fresh, recorded).size() == 2);
    CHECK(study::differences(recorded, fresh).size() == 2);
}

TEST_CASE("a CSV comes back as it was written, and a torn one is refused") {
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "airlight_study_test.csv";
    study::Csv csv;
    csv.comments = {"said above"};
    csv.columns = {"name", "number"};
    csv.rows = {{"x", "1.5"}, {"y", "-2e-3"}};
    study::write_csv(path, csv);
    const study::Csv back = study::read_csv(path);
    CHECK(back.comments == csv.comments);
    CHECK(back.columns == csv.columns);
    CHECK(back.rows == csv.rows);
    CHECK(back.number(1, "number") == -2e-3);  // the same text gives the same number
    CHECK(back.find({{"name", "y"}}) == 1);
    CHECK(back.find({{"name", "z"}}) == 2);
    CHECK_THROWS_AS(back.cell(0, "none"), support::Error);
    CHECK_THROWS_AS(back.number(0, "name"), support::Error);
    csv.rows.push_back({"too few"});
    study::write_csv(path, csv);
    CHECK_THROWS_AS(study::read_csv(path), support::Error);
    std::filesystem::remove(path);
}

}  // namespace
