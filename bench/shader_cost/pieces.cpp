#include "pieces.hpp"

#include <airlight/airlight.hpp>

#include "views.hpp"

namespace shader_cost {
namespace {

struct NoShadow : airlight::DefaultScene {
    static constexpr bool planet_shadow = false;
};
struct NoOzone : airlight::DefaultScene {
    static constexpr int ozone = airlight::ozone_none;
};

/// A visibility hook that counts how often it is asked: once at each node of each lit piece.
struct CountingVisibility {
    int* calls;

    template <typename T>
    T operator()([[maybe_unused]] const airlight::vec3<T>& position) const {
        ++*calls;
        return T(1);
    }
};

template <typename Scene>
double mean_over_suite() {
    int nodes = 0;
    int lit_rays = 0;
    for (const study::View& view : study::suite()) {
        const study::Ray<double>& ray = view.ray;
        int calls = 0;
        airlight::single_scattering<double, Scene>(study::worlds()[view.world].air, ray.eye, ray.direction,
                                                   ray.to_sun, ray.distance, CountingVisibility{&calls});
        nodes += calls;
        lit_rays += calls > 0 ? 1 : 0;
    }
    return double(nodes) / (double(Scene::nodes) * lit_rays);
}

}  // namespace

double mean_pieces(const std::string& flags) {
    static const double usual = mean_over_suite<airlight::DefaultScene>();
    static const double without_shadow = mean_over_suite<NoShadow>();
    static const double without_ozone = mean_over_suite<NoOzone>();
    return flags == "planet_shadow=0" ? without_shadow : flags == "ozone=none" ? without_ozone : usual;
}

}  // namespace shader_cost
