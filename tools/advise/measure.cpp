#include "measure.hpp"

#include <airlight/color.hpp>
#include <algorithm>
#include <cmath>

#include "error_metrics.hpp"
#include "sampling.hpp"
#include "support/parallel.hpp"

namespace advise {
namespace {

/// The changes of all views by a function View -> Light, on every core.
template <typename Function>
Change changes(const Measured& measured, const Function& light) {
    std::vector<double> out(measured.views.size());
    support::for_each_row(static_cast<int>(out.size()), [&](int row) {
        const auto i = static_cast<std::size_t>(row);
        out[i] = change_of(light(measured.views[i]), measured.light[i], measured.floor);
    });
    return summed_up(out);
}

}  // namespace

Measured measured(const Atmosphere& air, const Setting& reference, std::vector<View> views) {
    Measured out{air, reference, std::move(views), {}, 0};
    for (const View& view : out.views) {
        out.light.push_back(evaluated(reference, air, view));
    }
    // As docs/trade.md measures errors: a ten thousandth of the zenith at noon.
    out.floor = 1e-4 * airlight::luminance(evaluated(reference, air, noon_zenith()).radiance);
    return out;
}

double change_of(const Light& light, const Light& reference, double floor) {
    const double now = airlight::luminance(light.radiance);
    const double before = airlight::luminance(reference.radiance);
    const double measure = std::max(before, floor);
    const double added = measure > 0 ? std::abs(now - before) / measure : (now > 0 ? 1.0 : 0.0);
    const double passed =
        std::abs(airlight::luminance(light.transmittance) - airlight::luminance(reference.transmittance));
    return std::max(added, passed);
}

Change summed_up(const std::vector<double>& changes) {
    const airlight_test::ErrorMetrics all = airlight_test::error_metrics(changes);
    return {all.median, all.p95, all.largest};
}

Change change_by(const Measured& measured, const Setting& setting) {
    return changes(measured, [&](const View& view) { return evaluated(setting, measured.air, view); });
}

Change change_in(const Measured& measured, const Atmosphere& air) {
    return changes(measured, [&](const View& view) { return evaluated(measured.reference, air, view); });
}

Change doubt(const Measured& measured, int steps) {
    return changes(measured,
                   [&](const View& view) { return marched(measured.reference, measured.air, view, steps); });
}

Atmosphere flat(const Atmosphere& air) {
    Atmosphere out = air;
    out.ground_radius *= 1000.0;
    return out;
}

Atmosphere endless(const Atmosphere& air) {
    Atmosphere out = air;
    // Above forty heights lies e^-40 of a layer, less than a double holds next to the rest.
    out.top_altitude = std::max({air.top_altitude, 40.0 * air.rayleigh_scale_height,
                                 40.0 * air.mie_scale_height, air.ozone_altitude + air.ozone_half_width});
    return out;
}

}  // namespace advise
