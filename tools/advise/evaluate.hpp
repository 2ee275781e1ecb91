#pragma once

// single_scattering with flags that are chosen while the program runs.

#include <airlight/single_scattering.hpp>
#include <vector>

#include "setting.hpp"

namespace advise {

using Atmosphere = airlight::Atmosphere<double>;
using Light = airlight::Scattered<double>;
using Vector = airlight::vec3<double>;

/// One view ray.
struct View {
    airlight::Viewpoint<double> eye;
    Vector direction;
    Vector to_sun;
    double distance;  ///< [m] of the surface it ends on, or airlight::no_surface
};

/// Stands in for the visibility hook: light everywhere, and a list of where the nodes lie.
struct NodeRecorder {
    std::vector<Vector>* places;  ///< relative to the eye; null for no list

    template <typename T>
    T operator()(const airlight::vec3<T>& position) const {
        if (places != nullptr) {
            places->push_back(position);
        }
        return T(1);
    }
};

/// The air's light on one view ray under a setting; `places` gets the nodes' places.
Light evaluated(const Setting& setting, const Atmosphere& air, const View& view,
                std::vector<Vector>* places = nullptr);

/// One of single_scattering's instances, and the table of those with a number of nodes.
using Evaluate = Light (*)(const Atmosphere& air, const View& view, const NodeRecorder& recorder);
template <int Nodes>
Evaluate evaluate_with(const Setting& setting);

/// The same light by `steps` equal steps: the check of the reference.
Light marched(const Setting& setting, const Atmosphere& air, const View& view, int steps);

}  // namespace advise
