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

using namespace airlight;
using namespace airlight_test;

namespace {

/// Relative errors of the look-up against texels computed at the place, for suns between two cosines.
ErrorMetrics look_up_errors(const Atmosphere<double>& air, const Table<vec3<double>>& table, double low,
                            double high, double scale = 1) {
    const HillaireLight<double> light{&table};
    Random random(51);
    std::vector<double> errors;
    for (int i = 0; i < 300; ++i) {
        const double altitude = 6e4 * std::pow(random.unit(), 2);
        const double mu_s = random.uniform(low, high);
        const vec3<double> looked_up = light(air, altitude, mu_s) / scale;
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
    const auto measure = [&](const char* when, double low, double high) {
        const ErrorMetrics m = look_up_errors(air, table, low, high);
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
    CHECK(twilight.median >= 0.1);  // two texels from the terminator to 7 degrees below it
}

TEST_CASE("the table's own precision: half loses the twilight unless it is scaled") {
    const Atmosphere<double> air = earth<double>();
    Table<vec3<double>> plain = bake_hillaire(air);
    Table<vec3<double>> scaled = plain;
    const double scale = 1024;
    const Table<vec3<double>> exact_table = plain;
    for (vec3<double>& texel : plain.texels) {
        texel = as_half(texel);
    }
    for (vec3<double>& texel : scaled.texels) {
        texel = as_half(scale * texel);
    }
    double plain_worst = 0;
    double scaled_worst = 0;
    for (std::size_t i = 0; i < exact_table.texels.size(); ++i) {
        const int column = static_cast<int>(i % 32);
        if (column < 13) {
            continue;  // the sun 9.4 degrees down or more
        }
        for (int channel = 0; channel < 3; ++channel) {
            const double known = exact_table.texels[i][channel];
            plain_worst = std::fmax(plain_worst, std::fabs(plain.texels[i][channel] / known - 1));
            scaled_worst = std::fmax(scaled_worst, std::fabs(scaled.texels[i][channel] / scale / known - 1));
        }
    }
    std::printf("hillaire 32 x 32 in half, sun down to -9.3 degrees: off by %.1e, times 1024 by %.1e\n",
                plain_worst, scaled_worst);
    CHECK(plain_worst >= 1e-2);
    CHECK(scaled_worst <= 1e-3);  // half precision's roundoff is 4.9e-4
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
    Atmosphere<T> zero = earth<T>();
    zero.rayleigh_scattering = zero.mie_scattering = zero.mie_absorption = zero.ozone_absorption =
        zero.ground_albedo = vec3<T>(T(0));
    for (const Atmosphere<T>& air : {earth<T>(), mars<T>(), thick, none, zero}) {
        for (const int size : {1, 2, 6}) {
            const Table<vec3<T>> table = bake_hillaire(air, size, size);
            for (const T altitude : {T(-1), T(0), T(2e4L), T(1e9L)}) {
                for (const T mu_s : {T(-1), T(-0.05L), T(0), T(1)}) {
                    CHECK_UNARY(is_amount(HillaireLight<T>{&table}(air, altitude, mu_s)));
                }
            }
        }
    }
    const Table<vec3<T>> dark = bake_hillaire(zero, 3, 3);
    CHECK(HillaireLight<T>{&dark}(zero, T(0), T(1)) == vec3<T>(T(0)));  // exact: nothing scatters
}

TEST_SUITE_END();
