#pragma once

// The bodies of methods.hpp's templates; one source file for each scalar type includes this.

#include <baselines/baselines.hpp>

#include "converted.hpp"
#include "methods.hpp"
#include "tables.hpp"

namespace study {

template <int Ozone, int Nodes>
struct SceneOf : airlight::DefaultScene {
    static constexpr int ozone = Ozone;
    static constexpr int nodes = Nodes;
};

template <typename T, int Ozone>
class Evaluation {
  public:
    using Scattered = airlight::Scattered<T>;

    Evaluation(const Place<T>& place, const std::vector<Ray<T>>& rays) : place_(place), rays_(rays) {}

    std::vector<Scattered> by(const Setting& s) const {
        namespace baseline = airlight::baseline;
        using Scene = SceneOf<Ozone, 8>;
        switch (s.method) {
            case Method::nodes:
                return by_nodes(s.steps);
            case Method::marched:
                return each([&](const Ray<T>& r) {
                    return airlight::single_scattering_marched<T, Scene>(place_.air, r.eye, r.direction,
                                                                         r.to_sun, r.distance, s.steps);
                });
            case Method::leenman:
                return each([&](const Ray<T>& r) {
                    return baseline::leenman<T, Scene>(place_.air, r.eye, r.direction, r.to_sun, r.distance,
                                                       s.steps, s.sun_steps);
                });
            case Method::cs562:
                return each([&](const Ray<T>& r) {
                    return baseline::cs562<T, Scene, Texture<T>>(place_.air, r.eye, r.direction, r.to_sun,
                                                                 r.distance, s.steps + 1, place_.cs562);
                });
            case Method::double_loop:
                return each([&](const Ray<T>& r) {
                    return baseline::double_loop<T, Scene>(place_.air, r.eye, r.direction, r.to_sun,
                                                           r.distance, s.steps);
                });
            case Method::hillaire:
                return each([&](const Ray<T>& r) {
                    return baseline::hillaire<T, Scene, Texture<T>>(place_.air, r.eye, r.direction, r.to_sun,
                                                                    r.distance, s.steps, place_.hillaire);
                });
            case Method::schueler:
                return each([&](const Ray<T>& r) {
                    return baseline::schueler<T, Scene>(place_.air, r.eye, r.direction, r.to_sun, r.distance,
                                                        s.steps);
                });
            case Method::hdrp:
                return each([&](const Ray<T>& r) {
                    return baseline::hdrp<T, Scene>(place_.air, r.eye, r.direction, r.to_sun, r.distance,
                                                    s.steps);
                });
        }
        return {};
    }

  private:
    template <typename One>
    std::vector<Scattered> each(const One& one) const {
        std::vector<Scattered> out;
        out.reserve(rays_.size());
        for (const Ray<T>& ray : rays_) {
            out.push_back(one(ray));
        }
        return out;
    }

    template <int Nodes>
    std::vector<Scattered> with_nodes() const {
        return each([&](const Ray<T>& r) {
            return airlight::single_scattering<T, SceneOf<Ozone, Nodes>>(place_.air, r.eye, r.direction,
                                                                         r.to_sun, r.distance);
        });
    }

    std::vector<Scattered> by_nodes(int nodes) const {
        switch (nodes) {
            case 4:
                return with_nodes<4>();
            case 5:
                return with_nodes<5>();
            case 6:
                return with_nodes<6>();
            case 8:
                return with_nodes<8>();
            case 10:
                return with_nodes<10>();
            case 12:
                return with_nodes<12>();
            case 16:
                return with_nodes<16>();
            default:
                return with_nodes<24>();
        }
    }

    const Place<T>& place_;
    const std::vector<Ray<T>>& rays_;
};

template <typename T>
const std::vector<Place<T>>& places() {
    static const std::vector<Place<T>> all = [] {
        std::vector<Place<T>> out;
        for (std::size_t i = 0; i < worlds().size(); ++i) {
            const World& world = worlds()[i];
            out.push_back({airlight_test::converted<T>(world.air), world.ozone, cs562_table<T>(i),
                           hillaire_table<T>(i)});
        }
        return out;
    }();
    return all;
}

template <typename T>
std::vector<airlight::Scattered<T>> evaluated(const Setting& setting, const Place<T>& place,
                                              const std::vector<Ray<T>>& rays) {
    switch (place.ozone) {
        case airlight::ozone_tent:
            return Evaluation<T, airlight::ozone_tent>(place, rays).by(setting);
        case airlight::ozone_lorentzian:
            return Evaluation<T, airlight::ozone_lorentzian>(place, rays).by(setting);
        default:
            return Evaluation<T, airlight::ozone_none>(place, rays).by(setting);
    }
}

}  // namespace study
