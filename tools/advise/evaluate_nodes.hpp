#pragma once

// The instances of single_scattering with one number of nodes. They are many: each number is compiled alone.

#include "evaluate.hpp"

namespace advise {

template <bool Mie, int Ozone, int Phase, bool Shadow, int Nodes>
struct FixedScene : airlight::DefaultScene {
    static constexpr bool mie = Mie;
    static constexpr int ozone = Ozone;
    static constexpr int mie_phase = Phase;
    static constexpr bool planet_shadow = Shadow;
    static constexpr int nodes = Nodes;
};

template <typename Scene>
Light evaluated_as(const Atmosphere& air, const View& view, const NodeRecorder& recorder) {
    return airlight::single_scattering<double, Scene>(air, view.eye, view.direction, view.to_sun,
                                                      view.distance, recorder);
}

template <bool Mie, int Ozone, int Phase, int Nodes>
Evaluate with_shadow(const Setting& setting) {
    return setting.planet_shadow ? evaluated_as<FixedScene<Mie, Ozone, Phase, true, Nodes>>
                                 : evaluated_as<FixedScene<Mie, Ozone, Phase, false, Nodes>>;
}

template <int Ozone, int Nodes>
Evaluate with_aerosol(const Setting& setting) {
    using namespace airlight;
    if (!setting.mie) {
        return with_shadow<false, Ozone, phase_cornette_shanks, Nodes>(setting);
    }
    switch (setting.mie_phase) {
        case phase_henyey_greenstein:
            return with_shadow<true, Ozone, phase_henyey_greenstein, Nodes>(setting);
        case phase_fog:
            return with_shadow<true, Ozone, phase_fog, Nodes>(setting);
        default:
            return with_shadow<true, Ozone, phase_cornette_shanks, Nodes>(setting);
    }
}

template <int Nodes>
Evaluate evaluate_with(const Setting& setting) {
    using namespace airlight;
    switch (setting.ozone) {
        case ozone_none:
            return with_aerosol<ozone_none, Nodes>(setting);
        case ozone_lorentzian:
            return with_aerosol<ozone_lorentzian, Nodes>(setting);
        default:
            return with_aerosol<ozone_tent, Nodes>(setting);
    }
}

}  // namespace advise
