#include <cmath>
#include <cstdio>

#include <doctest/doctest.h>

#include "reference/views.hpp"
#include "table.hpp"

using namespace reference;

TEST_CASE("the committed table has the judged views, its orders add up, and another seed agrees with it") {
    const std::vector<airlight_test::Row> rows = airlight_test::read_table(REFERENCE_TABLE);
    const std::vector<View> views = judged_views();
    REQUIRE(rows.size() == 3 * views.size());
    const support::Preset earth = support::preset("earth");
    double squares = 0;
    int values = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const airlight_test::Row& row = rows[i];
        const View& view = views[i / 3];
        CAPTURE(view.name());
        const double is[] = {row.input<double>("altitude"), row.input<double>("sun_elevation"),
                             row.input<double>("elevation"), row.input<double>("azimuth")};
        const double should[] = {view.altitude, view.sun_elevation, view.elevation, view.azimuth};
        for (int k = 0; k < 4; ++k) {
            CHECK(is[k] == should[k]);
        }
        const int channel = row.input<int>("channel");
        CHECK(channel == static_cast<int>(i % 3));

        const auto total = static_cast<double>(row.expected("total"));
        const auto error = static_cast<double>(row.expected("total_error"));
        CHECK(total > 0);
        double sum = 0;
        for (int k = 1; k < kept_orders; ++k) {
            sum += static_cast<double>(row.expected("order_" + std::to_string(k)));
        }
        sum += static_cast<double>(row.expected("order_" + std::to_string(kept_orders) + "_and_more"));
        CHECK(std::fabs(sum - total) <= 1e-6 * total);  // seven printed digits of each

        // By day a short walk is enough to see a wrong number; twilight takes long.
        if (view.sun_elevation >= 0) {
            const Air air(earth.air, earth.ozone, channel);
            const Estimate again = traced(air, view, 0, Effort{4000, 7 + i, 40}).total;
            const double off = (again.mean - total) / std::hypot(again.error, error);
            squares += off * off;
            ++values;
            CHECK(std::fabs(off) < 5);  // 1e-6 each, were the error known; it is known to 11 %
        }
    }
    std::printf("table against another seed: %d values, chi-square %.2f of its mean\n", values,
                squares / values);
    CHECK(values > 50);
    CHECK(squares / values < 1.7);  // 1 expected, with a spread of 0.17
}
