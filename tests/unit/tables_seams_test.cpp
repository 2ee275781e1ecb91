#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/tables/diffuse.hpp>

#include "angles.hpp"
#include "converted.hpp"
#include "scenes.hpp"
#include "story.hpp"
#include "worlds.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

// The sky through a table in float, as a shader has it, from `low` to `high` degrees.
std::vector<double> scan(const DiffuseTable<float>& table, float altitude, double sun, double low,
                         double high, int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i) {
        const double elevation = low + (high - low) * i / (count - 1);
        const Scattered<float> seen =
            all_scattering<float>(table.atmosphere, standing(altitude), slope<float>(elevation, 20.0),
                                  slope<float>(sun), no_surface<float>(), table);
        out.push_back(static_cast<double>(seen.radiance.y));
    }
    return out;
}

// The largest change from one sample to the next that its neighbours on both sides do not lead to, of the
// value.
double largest_step(const std::vector<double>& values) {
    double worst = 0;
    for (std::size_t i = 2; i + 1 < values.size(); ++i) {
        const double expected = (3 * values[i - 1] + values[i + 1] - values[i - 2]) / 3;  // of a parabola
        worst = std::max(worst, std::fabs(values[i] - expected) / std::max(values[i], 1e-12));
    }
    return worst;
}

}  // namespace

TEST_SUITE_BEGIN("tables_seams");

TEST_CASE("no seam, stripe or speck across the sky through a table, on Earth, thin Mars and dense Titan") {
    for (const Atmosphere<double>& air : {earth<double>(), mars<double>(), titan<double>()}) {
        const Atmosphere<float> planet = airlight_test::converted<float>(air);
        const DiffuseTable<float> table = bake_diffuse_table<float, Nodes<5>>(planet, 32, 8, 3);
        for (const double sun : {40.0, 2.0, -4.0, -10.0}) {
            // From just above the horizon to the zenith, in steps of a tenth of a degree: exposure 1 or a
            // million, what is smooth in the ratio is smooth on the screen.
            const double step = largest_step(scan(table, 2.0F, sun, 0.2, 90.0, 900));
            CAPTURE(air.ground_radius);
            CAPTURE(sun);
            CHECK(step <= 1e-3);  // a quarter of a level of 8 bits (measured: 4.4e-4, at sunset)
        }
    }
}

TEST_SUITE_END();
