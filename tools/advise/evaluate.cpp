#include "evaluate.hpp"

namespace advise {
namespace {

Evaluate chosen(const Setting& setting) {
    switch (setting.nodes) {
        case 4:
            return evaluate_with<4>(setting);
        case 5:
            return evaluate_with<5>(setting);
        case 6:
            return evaluate_with<6>(setting);
        case 8:
            return evaluate_with<8>(setting);
        case 10:
            return evaluate_with<10>(setting);
        case 12:
            return evaluate_with<12>(setting);
        case 16:
            return evaluate_with<16>(setting);
        default:
            return evaluate_with<24>(setting);
    }
}

template <int Ozone, int Phase>
struct MarchedScene : airlight::DefaultScene {
    static constexpr int ozone = Ozone;
    static constexpr int mie_phase = Phase;
};

template <int Ozone, int Phase>
Light marched_as(const Atmosphere& air, const View& view, int steps) {
    return airlight::single_scattering_marched<double, MarchedScene<Ozone, Phase>>(
        air, view.eye, view.direction, view.to_sun, view.distance, steps);
}

template <int Ozone>
Light marched_with(const Setting& setting, const Atmosphere& air, const View& view, int steps) {
    using namespace airlight;
    switch (setting.mie_phase) {
        case phase_henyey_greenstein:
            return marched_as<Ozone, phase_henyey_greenstein>(air, view, steps);
        case phase_fog:
            return marched_as<Ozone, phase_fog>(air, view, steps);
        default:
            return marched_as<Ozone, phase_cornette_shanks>(air, view, steps);
    }
}

}  // namespace

Light evaluated(const Setting& setting, const Atmosphere& air, const View& view,
                std::vector<Vector>* places) {
    return chosen(setting)(air, view, NodeRecorder{places});
}

Light marched(const Setting& setting, const Atmosphere& air, const View& view, int steps) {
    using namespace airlight;
    switch (setting.ozone) {
        case ozone_none:
            return marched_with<ozone_none>(setting, air, view, steps);
        case ozone_lorentzian:
            return marched_with<ozone_lorentzian>(setting, air, view, steps);
        default:
            return marched_with<ozone_tent>(setting, air, view, steps);
    }
}

}  // namespace advise
