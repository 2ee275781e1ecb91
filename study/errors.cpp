#include "errors.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "support/parallel.hpp"

namespace study {

Judged judged(std::vector<View> views, const Progress& progress) {
    std::vector<double> floors;
    for (std::size_t world = 0; world < worlds().size(); ++world) {
        floors.push_back(1e-4 * airlight::luminance(true_radiance(noon_zenith(world)).radiance));
    }
    Judged out;
    out.views = std::move(views);
    out.luminance.resize(out.views.size());
    std::vector<double> doubts(out.views.size());
    std::atomic<std::size_t> done{0};
    support::for_each_row(static_cast<int>(out.views.size()), [&](int row) {
        const auto i = static_cast<std::size_t>(row);
        const Truth truth = true_radiance(out.views[i]);
        out.luminance[i] = airlight::luminance(truth.radiance);
        doubts[i] = truth.doubt;
        progress(++done, out.views.size());
    });
    for (const View& view : out.views) {
        out.floor.push_back(floors[view.world]);
    }
    out.doubt = doubts.empty() ? 0.0 : *std::max_element(doubts.begin(), doubts.end());
    return out;
}

template <typename T>
std::vector<double> errors(const Setting& setting, const Judged& judged) {
    std::vector<double> out(judged.views.size());
    for (std::size_t world = 0; world < worlds().size(); ++world) {
        std::vector<std::size_t> which;
        std::vector<Ray<T>> rays;
        for (std::size_t i = 0; i < judged.views.size(); ++i) {
            if (judged.views[i].world == world) {
                which.push_back(i);
                rays.push_back(converted<T>(judged.views[i].ray));
            }
        }
        const auto light = evaluated(setting, places<T>()[world], rays);
        for (std::size_t i = 0; i < which.size(); ++i) {
            const double found = static_cast<double>(airlight::luminance(light[i].radiance));
            const double truth = judged.luminance[which[i]];
            out[which[i]] = std::abs(found - truth) / std::max(truth, judged.floor[which[i]]);
        }
    }
    return out;
}

template std::vector<double> errors<float>(const Setting&, const Judged&);
template std::vector<double> errors<double>(const Setting&, const Judged&);

airlight_test::ErrorMetrics metrics(const std::vector<double>& errors, const Judged& judged,
                                    const std::function<bool(const View&)>& chosen) {
    std::vector<double> out;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (chosen(judged.views[i])) {
            out.push_back(errors[i]);
        }
    }
    return airlight_test::error_metrics(out);
}

}  // namespace study
