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
#include "../pages.hpp"
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

TEST_CASE("with many steps every baseline comes near the truth, so all of them mean the same radiance") {
    std::vector<study::View> morning;
    for (const study::View& view : study::suite()) {
        if (view.name == "200 m; sun 45; view 20 / 0") {
            morning.push_back(view);
        }
    }
    REQUIRE(morning.size() == study::worlds().size());
    const study::Judged judged = study::judged(morning, [](std::size_t, std::size_t) {});
    using study::Method;
    struct Limit {
        study::Setting setting;
        double error;
    };
    const Limit limits[] = {
        {{Method::marched, 4000, 0}, 1e-4},  // second order: (15 km of air / 4000 steps / 1.2 km)^2 is 1e-5
        {{Method::double_loop, 400, 0}, 2e-3},  // second order, steps ten times as long
        {{Method::leenman, 2000, 400}, 5e-3},   // first order: each step dims its own light by its whole air
        {{Method::cs562, 4000, 0}, 2e-2},  // first order, a sample too many, and a table that has one too
        {{Method::hillaire, 2000, 0},
         0.15},                           // his table takes the far end of each of 40 steps: 12 % of the air
        {{Method::hdrp, 2000, 0}, 2e-3},  // his formula's 0.5 % of a small optical depth
        {{Method::schueler, 2000, 0}, 5e-2},  // his formula's 20 % of the same
    };
    for (const Limit& limit : limits) {
        const std::vector<double> errors = study::errors<double>(limit.setting, judged);
        for (std::size_t i = 0; i < errors.size(); ++i) {
            CAPTURE(study::name_of(limit.setting.method));
            CAPTURE(study::worlds()[judged.views[i].world].name);
            CHECK(errors[i] <= limit.error);
        }
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

TEST_CASE("figures have two digits that count") {
    CHECK(study::percent(0.9854) == "99");
    CHECK(study::percent(1.234) == "123");
    CHECK(study::percent(0.0123) == "1.2");
    CHECK(study::percent(0.000314) == "0.031");
    CHECK(study::percent(0.00996) == "1.0");
    CHECK(study::percent(0.0996) == "10");
    CHECK(study::percent(0.0) == "0");
}

TEST_CASE("a page's figures stand between markers, and its text stays") {
    const std::map<std::string, std::string> blocks = {{"a", "one\n"}, {"b", "two\n"}};
    const std::string page =
        "x\n<!-- study: a -->\nold\n<!-- study: end -->\ny <!-- study: b -->\n<!-- study: end -->z";
    const std::string full = study::filled(page, blocks);
    CHECK(full ==
          "x\n<!-- study: a -->\n\none\n\n<!-- study: end -->\ny <!-- study: b -->\n\ntwo\n\n<!-- study: end "
          "-->z");
    CHECK(study::filled(full, blocks) == full);
    CHECK(study::filled("no markers", blocks) == "no markers");
    CHECK_THROWS_AS(study::filled("<!-- study: c -->\n<!-- study: end -->", blocks), support::Error);
    CHECK_THROWS_AS(study::filled("<!-- study: a -->\n", blocks), support::Error);
    CHECK_THROWS_AS(study::filled("<!-- study: a -->\n<!-- study: b -->\n<!-- study: end -->", blocks),
                    support::Error);
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
