#pragma once

// What a setting, or another atmosphere, changes in the views.

#include <string>
#include <vector>

#include "evaluate.hpp"

namespace advise {

/// Views with their reference: 24 nodes, every term on.
struct Measured {
    Atmosphere air;
    Setting reference;
    std::vector<View> views;
    std::vector<Light> light;  ///< of each view
    double floor;              ///< luminance below which a view counts as dark
};

Measured measured(const Atmosphere& air, const Setting& reference, std::vector<View> views);

/// Changes over the views, as shares: 0.01 is one per cent.
struct Change {
    double median = 0;
    double p95 = 0;
    double worst = 0;
};

/// How far a view's light is from the reference's. The larger of two shares: the change of the air's
/// luminance over max(luminance, floor), and the change of the share of light that the air lets through.
double change_of(const Light& light, const Light& reference, double floor);

/// The changes of some views.
Change summed_up(const std::vector<double>& changes);

/// By another setting, in the same air.
Change change_by(const Measured& measured, const Setting& setting);

/// By another atmosphere, with the reference's setting.
Change change_in(const Measured& measured, const Atmosphere& air);

/// Of the reference against a march of so many steps: no more than the errors of the two together.
Change doubt(const Measured& measured, int steps);

/// The same air over a ground a thousand times as large: flat, for every view within it.
Atmosphere flat(const Atmosphere& air);

/// The same layers without an end: what is cut off at top_altitude is there.
Atmosphere endless(const Atmosphere& air);

}  // namespace advise
