#pragma once

// How wrong every setting is.

#include <error_metrics.hpp>
#include <functional>
#include <string>
#include <vector>

#include "methods.hpp"
#include "truth.hpp"
#include "views.hpp"

namespace study {

/// Reported while a long computation goes on: done of all.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// Views with their true luminance, and what their errors are measured by.
struct Judged {
    std::vector<View> views;
    std::vector<double> luminance;  ///< true, of each view
    std::vector<double> floor;      ///< of each view: 1e-4 of its world's zenith at noon
    double doubt = 0;               ///< largest share that the truth is not sure of
};

Judged judged(std::vector<View> views, const Progress& progress);

/// |Y - Y_true| / max(Y_true, floor) of each view, in double or in float.
template <typename T>
std::vector<double> errors(const Setting& setting, const Judged& judged);

/// The errors of those views for which `chosen` holds, summed up.
airlight_test::ErrorMetrics metrics(const std::vector<double>& errors, const Judged& judged,
                                    const std::function<bool(const View&)>& chosen);

}  // namespace study
