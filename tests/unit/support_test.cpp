#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include <doctest/doctest.h>

#include "error_metrics.hpp"
#include "quadrature.hpp"
#include "samplers.hpp"
#include "story.hpp"
#include "table.hpp"
#include "ulp.hpp"

using namespace airlight_test;

TEST_SUITE_BEGIN("support");

TEST_CASE_TEMPLATE("neighbouring numbers are one ulp apart", T, float, double, long double) {
    for (const T x : {T(1), T(1.5), T(-3), T(1e-30), T(7e20)}) {
        const T next = std::nextafter(x, std::numeric_limits<T>::infinity());
        // Exact: spacing is a power of two. Below a power of two the lower neighbour is half as far away.
        CHECK(ulp_error(next, static_cast<long double>(x)) == 1.0L);
    }
    CHECK(ulp_error(std::nextafter(T(1), T(0)), 1.0L) == 0.5L);
}

TEST_CASE_TEMPLATE("equal numbers have no error, and special values match only themselves", T, float, double,
                   long double) {
    const T infinity = std::numeric_limits<T>::infinity();
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const long double far = std::numeric_limits<long double>::infinity();
    CHECK(ulp_error(T(2), 2.0L) == 0.0L);
    CHECK(ulp_error(T(0), 0.0L) == 0.0L);
    CHECK(ulp_error(infinity, far) == 0.0L);
    CHECK(ulp_error(-infinity, far) == far);
    CHECK(ulp_error(infinity, 1.0L) == far);
    CHECK(ulp_error(T(1), far) == far);
    CHECK(ulp_error(nan, 1.0L) == far);
    CHECK(ulp_error(T(1), std::nanl("")) == far);
    CHECK(ulp_error(nan, std::nanl("")) == 0.0L);
    CHECK(roundoff_error(nan, 1.0L, 1.0L) == far);
    CHECK(roundoff_error(T(1), 2.0L, std::nanl("")) == far);
}

TEST_CASE_TEMPLATE("errors near zero are counted in denormals", T, float, double) {
    const long double tiny = std::numeric_limits<T>::denorm_min();
    CHECK(ulp_spacing<T>(0.0L) == tiny);
    CHECK(ulp_spacing<T>(3 * tiny) == tiny);
    CHECK(ulp_error(T(0), 5 * tiny) == 5.0L);
}

TEST_CASE_TEMPLATE("one correctly rounded operation costs at most one roundoff", T, float, double,
                   long double) {
    CHECK(unit_roundoff<T>() == std::ldexp(1.0L, -std::numeric_limits<T>::digits));
    // Exact: all three numbers are powers of two, or sums of two of them.
    CHECK(roundoff_error(T(1), 1.0L + 2 * unit_roundoff<T>(), 1.0L) == 2.0L);
    CHECK(roundoff_error(T(1), 1.0L + 2 * unit_roundoff<T>(), 4.0L) == 0.5L);
}

TEST_CASE("a comparison tells its story in full precision") {
    const std::string story = compare_ulp("f", {{"x", 0.5L}, {"y", 3.0L}}, 1.0f, 2.0L).story();
    for (const char* part :
         {"f<float>", "x = ", "y = ", "(0.5)", "(3)", "expected ", "(2)", "got ", "(1)", "ulp"}) {
        CHECK_MESSAGE(story.find(part) != std::string::npos, story);
    }
}

TEST_CASE("the worst of a sweep is the one with the largest error, NaN included") {
    Worst worst;
    CHECK(worst.error() == std::numeric_limits<long double>::infinity());  // a sweep of nothing must not pass
    worst.add(compare_ulp("f", {{"x", 1.0L}}, 1.0, 1.0L));
    worst.add(compare_ulp("f", {{"x", 2.0L}}, 1.0, 1.0L + 0x1p-51L));
    worst.add(compare_ulp("f", {{"x", 3.0L}}, 1.0, 1.0L + 0x1p-52L));
    CHECK(worst.error() == 2.0L);
    CHECK(worst.count() == 3);
    worst.add(compare_ulp("f", {{"x", 4.0L}}, std::nan(""), 1.0L));
    CHECK(worst.error() == std::numeric_limits<long double>::infinity());
    CHECK(worst.story().find("(4)") != std::string::npos);
}

TEST_CASE("percentiles take the nearest rank") {
    const std::vector<double> samples = {5, 1, 4, 2, 3};
    CHECK(percentile(samples, 0.0) == 1);
    CHECK(percentile(samples, 0.5) == 3);
    CHECK(percentile(samples, 0.95) == 5);
    CHECK(percentile(samples, 0.2) == 1);
    CHECK(percentile({}, 0.5) == 0);
}

TEST_CASE("error metrics of 3 and 4") {
    const ErrorMetrics metrics = error_metrics({3, 4});
    CHECK(metrics.largest == 4);
    CHECK(metrics.p95 == 4);
    CHECK(metrics.median == 3);
    CHECK(metrics.root_mean_square == std::sqrt(12.5));
    CHECK(std::isnan(error_metrics({1, std::nan(""), 2}).largest));
}

TEST_CASE("an error that falls by 4 per doubling is of order 2") {
    CHECK(convergence_order(4.0, 1.0) == 2.0);  // exact: the logarithm of a power of two
}

TEST_CASE("the random numbers are those of SplitMix64") {
    Random random(1234567);
    // First two outputs of the reference implementation for this seed.
    CHECK(random.bits() == 6457827717110365317u);
    CHECK(random.bits() == 3203168211198807973u);
}

TEST_CASE("samples stay in their interval and fill it") {
    Random random(7);
    double sum = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const double u = random.uniform(-2.0, 6.0);
        CHECK_UNARY(u >= -2.0 && u <= 6.0);
        sum += u;
        const double l = random.log_uniform(1e-3, 1e3);
        CHECK_UNARY(l >= 1e-3 * (1 - 1e-15) && l <= 1e3 * (1 + 1e-13));  // exp and log round
        const airlight::vec3<double> d = random.direction<double>();
        CHECK_UNARY(std::fabs(glm::dot(d, d) - 1.0) <=
                    8 * 0x1p-53);  // 8 roundoffs: three squares, sine, cosine
        const int k = random.below(3);
        CHECK_UNARY(k >= 0 && k < 3);
    }
    // Mean of 1e4 uniform numbers of width 8: standard deviation 8 / sqrt(12 * 1e4) = 0.023; five of those.
    CHECK(std::fabs(sum / 10000 - 2.0) < 5 * 0.023);
}

TEST_CASE("a stratified sweep holds both ends and one point per cell") {
    Random random(8);
    std::vector<double> seen;
    for_stratified(random, 0.0, 10.0, 10, [&](double x) { seen.push_back(x); });
    REQUIRE(seen.size() == 12);
    CHECK(seen[0] == 0.0);
    CHECK(seen[1] == 10.0);
    for (int i = 0; i < 10; ++i) {
        const double x = seen[static_cast<std::size_t>(i) + 2];
        CHECK_UNARY(x >= i && x <= i + 1);
    }
}

TEST_CASE("the test integral is right for known integrals") {
    const auto cube = [](long double x) { return x * x * x; };
    // 1e-17: the rule's own stopping tolerance of 1e-16 times a safety that doubling the digits gives.
    CHECK(std::fabs(integrate(cube, 0.0L, 2.0L) - 4.0L) <= 4e-17L);
    const auto decay = [](long double x) { return std::exp(-x); };
    CHECK(std::fabs(integrate(decay, 0.0L, 1.0L) - 0.632120558828557678404476229838539132555L) <= 1e-17L);
    const auto root = [](long double x) { return std::sqrt(x); };
    CHECK(std::fabs(integrate(root, 0.0L, 1.0L) - 2.0L / 3.0L) <= 1e-16L);  // infinite slope at 0
    const auto one = [](long double) { return 1.0L; };
    CHECK(std::fabs(integrate_sphere(one) - 12.5663706143591729538505735331180115L) <=
          1e-15L);  // 4 pi, 18 panels
}

TEST_CASE("a table is read with its comments, names and exact inputs") {
    const std::string path = "support_test_table.csv";
    std::ofstream(path) << "# about\nx,name,y\n0.5,a,0.1\n0.10000000149011612,b,1e-400\n";
    const std::vector<Row> rows = read_table(path);
    std::remove(path.c_str());
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].input<float>("x") == 0.5f);
    CHECK(rows[0].expected("y") == 0.1L);
    CHECK(rows[0].text("name") == "a");
    CHECK(rows[1].input<float>("x") == 0.1f);
    CHECK(rows[1].input<long double>("x") == static_cast<long double>(0.1f));
    CHECK_THROWS_WITH_AS(rows[0].input<float>("y"), "support_test_table.csv:3: y is not exact in this type",
                         std::runtime_error);
    CHECK_THROWS_WITH_AS(rows[0].expected("name"), "support_test_table.csv:3: name is not a number: 'a'",
                         std::runtime_error);
    CHECK_THROWS_WITH_AS(rows[0].text("z"), "support_test_table.csv:3: no column named z",
                         std::runtime_error);
}

TEST_CASE("a table that is missing, torn or empty is refused") {
    CHECK_THROWS_AS(read_table("no/such/table.csv"), std::runtime_error);
    const std::string path = "support_test_torn.csv";
    std::ofstream(path) << "x,y\n1,2\n3\n";
    CHECK_THROWS_WITH_AS(read_table(path), "support_test_torn.csv:3: 1 cells, expected 2",
                         std::runtime_error);
    std::ofstream(path) << "x,y\n";
    CHECK_THROWS_WITH_AS(read_table(path), "support_test_torn.csv: no rows", std::runtime_error);
    std::remove(path.c_str());
}

TEST_SUITE_END();
