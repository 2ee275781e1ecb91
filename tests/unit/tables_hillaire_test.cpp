#include <doctest/doctest.h>
#include <airlight/atmospheres.hpp>
#include <airlight/tables/hillaire.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

#include "error_metrics.hpp"
#include "half.hpp"
#include "promises.hpp"
#include "samplers.hpp"
#include "worlds.hpp"

using namespace airlight;
using namespace airlight_test;

namespace {

/// Relative errors of the look-up against texels computed at the place, for suns between two cosines.
ErrorMetrics look_up_errors(const Atmosphere<double>& air, const Table<vec3<double>>& table, double low,
                            double high, bool roots) {
    const HillaireLight<double> light{&air, &table, roots};
    Random random(51);
    std::vector<double> errors;
    for (int i = 0; i < 300; ++i) {
        const double altitude = 6e4 * std::pow(random.unit(), 2);
        const double mu_s = random.uniform(low, high);
        const vec3<double> looked_up = light(altitude, mu_s).mean;
        const vec3<double> direct = hillaire_texel<double>(air, altitude, mu_s, 8, 4, 20);
        for (int channel = 0; channel < 3; ++channel) {
            errors.push_back(std::fabs(looked_up[channel] / direct[channel] - 1));
        }
    }
    return error_metrics(errors);
}

}  // namespace

TEST_SUITE_BEGIN("tables_hillaire");

TEST_CASE("32 x 32 texels hold the day, and blur the twilight as the mapping does") {
    const Atmosphere<double> air = earth<double>();
    const Table<vec3<double>> table = bake_hillaire(air);
    Table<vec3<double>> roots = table;
    for (vec3<double>& texel : roots.texels) {
        texel = stored_light(texel);
    }
    const auto measure = [&](const char* when, double low, double high, bool root = false) {
        const ErrorMetrics m = look_up_errors(air, root ? roots : table, low, high, root);
        std::printf("hillaire 32 x 32, %s: look-up off by median %.1e p95 %.1e max %.1e\n", when, m.median,
                    m.p95, m.largest);
        return m;
    };
    // The printed errors with a fifth to spare.
    const ErrorMetrics day = measure("sun above 6 degrees", 0.1, 1);
    CHECK(day.median <= 1.5e-3);
    CHECK(day.p95 <= 0.03);
    const ErrorMetrics twilight = measure("sun from 0 to -6 degrees", -0.1, 0);
    CHECK(twilight.p95 <= 3);
    CHECK(twilight.median >= 0.1);  // one texel from the terminator to 4 degrees below it, two to 7 degrees
    const ErrorMetrics rooted = measure("the same, square roots", -0.1, 0, true);
    CHECK(rooted.p95 <= twilight.p95 / 2);
    CHECK(rooted.median <= 0.15);
}

TEST_CASE("half precision loses the twilight, square roots in half keep it") {
    const Atmosphere<double> air = earth<double>();
    const Table<vec3<double>> table = bake_hillaire(air);
    double plain_worst = 0;
    double root_worst = 0;
    for (std::size_t i = 0; i < table.texels.size(); ++i) {
        const vec3<double> light = table.texels[i];
        const vec3<double> plain = as_half(light);
        const vec3<double> root = light_from_stored(as_half(stored_light(light)));
        for (int channel = 0; channel < 3; ++channel) {
            if (light[channel] >= 1e-9) {  // all that is left 12 degrees after sunset
                plain_worst = std::fmax(plain_worst, std::fabs(plain[channel] / light[channel] - 1));
                root_worst = std::fmax(root_worst, std::fabs(root[channel] / light[channel] - 1));
            }
        }
    }
    std::printf("hillaire 32 x 32 in half, light from 1e-9: off by %.1e, square roots by %.1e\n", plain_worst,
                root_worst);
    CHECK(plain_worst >= 0.5);  // below 3e-8 half precision has nothing but 0
    CHECK(root_worst <= 1e-3);  // twice half precision's roundoff, 4.9e-4
}

TEST_CASE("rows may be baked in any order") {
    const Atmosphere<float> air = earth<float>();
    const auto backwards = [](int count, const auto& body) {
        for (int row = count - 1; row >= 0; --row) {
            body(row);
        }
    };
    const HillaireEffort little = {2, 1, 3};
    CHECK(bake_hillaire(air, 5, 4, little).texels == bake_hillaire(air, 5, 4, little, backwards).texels);
}

TEST_CASE_TEMPLATE("sizes of 1, thin Mars, thick air and none give amounts of light", T, float, double) {
    Atmosphere<T> thick = earth<T>();
    thick.rayleigh_scattering *= T(100);
    Atmosphere<T> none = earth<T>();
    none.top_altitude = T(0);
    Atmosphere<T> zero = airless(earth<T>());
    zero.ground_albedo = vec3<T>(T(0));
    for (const Atmosphere<T>& air : {earth<T>(), mars<T>(), thick, none, zero}) {
        for (const int size : {1, 2, 6}) {
            const Table<vec3<T>> table = bake_hillaire(air, size, size);
            for (const T altitude : {T(-1), T(0), T(2e4L), T(1e9L)}) {
                for (const T mu_s : {T(-1), T(-0.05L), T(0), T(1)}) {
                    CHECK_UNARY(is_amount(HillaireLight<T>{&air, &table}(altitude, mu_s).mean));
                }
            }
        }
    }
    const Table<vec3<T>> dark = bake_hillaire(zero, 3, 3);
    CHECK(HillaireLight<T>{&zero, &dark}(T(0), T(1)).mean == vec3<T>(T(0)));  // exact: nothing scatters
}

TEST_SUITE_END();
