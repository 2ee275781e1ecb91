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

/// A hook for light from all sides that does the same.
struct CountingLight {
    int* calls;

    template <typename T>
    airlight::DiffuseLight<T> operator()(T altitude, T mu_s) const {
        ++*calls;
        return airlight::NoDiffuseLight{}(altitude, mu_s);
    }
};

/// How often nodes_of runs all nodes, by the calls of its hook, over the rays where it runs any.
template <typename Scene, typename NodesOf>
double mean_over_suite(const NodesOf& nodes_of) {
    int nodes = 0;
    int rays = 0;
    for (const study::View& view : study::suite()) {
        int calls = 0;
        nodes_of(study::worlds()[view.world].air, view.ray, &calls);
        nodes += calls;
        rays += calls > 0 ? 1 : 0;
    }
    return double(nodes) / (double(Scene::nodes) * rays);
}

template <typename Scene>
double lit_pieces() {
    return mean_over_suite<Scene>([](const auto& air, const study::Ray<double>& ray, int* calls) {
        airlight::single_scattering<double, Scene>(air, ray.eye, ray.direction, ray.to_sun, ray.distance,
                                                   CountingVisibility{calls});
    });
}

}  // namespace

double mean_pieces(const std::string& flags) {
    static const double usual = lit_pieces<airlight::DefaultScene>();
    static const double without_shadow = lit_pieces<NoShadow>();
    static const double without_ozone = lit_pieces<NoOzone>();
    return flags == "planet_shadow=0" ? without_shadow : flags == "ozone=none" ? without_ozone : usual;
}

double mean_sides() {
    using Scene = airlight::DefaultScene;
    return mean_over_suite<Scene>([](const auto& air, const study::Ray<double>& ray, int* calls) {
        airlight::diffuse_scattering<double, Scene>(air, ray.eye, ray.direction, ray.to_sun, ray.distance,
                                                    CountingLight{calls});
    });
}

}  // namespace shader_cost
