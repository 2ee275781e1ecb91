#pragma once

// CPU only. Tables of scattered light, made order by order: what inscatter.hpp (three dimensions) and
// bruneton.hpp (four) have in common.

#include <airlight/scattering_mapping.hpp>
#include <airlight/scattering_of_table.hpp>
#include <airlight/scattering_orders.hpp>
#include <airlight/tables/table.hpp>
#include <cstddef>
#include <vector>

namespace airlight {

/// What a bake leaves behind, for the three hooks of radiance_of_table and for surfaces.
template <typename T>
struct ScatteringTables {
    Table<vec3<T>> rayleigh;    ///< [1] order 1 by molecules, without phase function
    Table<vec3<T>> mie;         ///< [1] order 1 by aerosol, without phase function
    Table<vec3<T>> multiple;    ///< [1/sr] radiance of orders 2 and up
    Table<vec3<T>> irradiance;  ///< [1] of level surfaces by all of these orders,
                                ///< without the sun itself
};

/// What looks at every order of a bake if nobody else does.
struct KeepNothing {
    template <typename T>
    void operator()(int, const Table<vec3<T>>&) const {}
};

/// How many passes a bake of `orders` orders makes; every pass calls `rows` once.
constexpr int passes_of_bake(int orders) {
    return orders < 2 ? 2 : 2 + 4 * (orders - 1);
}

namespace detail {

/// The light from every direction of sphere_direction, for every altitude and sun of a table. It is the same
/// for all views, of which a table has hundreds for each altitude and sun.
template <typename T, typename Scene>
struct IncidentTable {
    int suns;
    std::vector<vec3<T>> light;

    static constexpr int directions = 2 * Scene::nodes * 16;
    static int index(int side, int polar, int azimuth) {
        return (side * Scene::nodes + polar) * 16 + azimuth;
    }
    vec3<T>* row(int altitude, int sun) {
        return light.data() + static_cast<std::ptrdiff_t>(altitude * suns + sun) * directions;
    }
};

/// The hook IncidentLight for one altitude and sun.
template <typename T, typename Scene>
struct IncidentRow {
    const vec3<T>* light;
    vec3<T> operator()(T, T, int side, int polar, int azimuth) const {
        return light[IncidentTable<T, Scene>::index(side, polar, azimuth)];
    }
};

}  // namespace detail

/// A table of one value per ray as a hook.
template <typename T, typename Shape>
struct TableHook {
    const Shape& shape;
    const Table<vec3<T>>& table;
    vec3<T> operator()(T altitude, T mu, T mu_s, T nu, bool reaches_ground) const {
        return shape.read(table, altitude, mu, mu_s, nu, reaches_ground);
    }
};

/// The table of irradiance as a hook, for the ground.
template <typename T>
struct IrradianceHook {
    const Atmosphere<T>& atmosphere;
    const Table<vec3<T>>& table;
    vec3<T> operator()(T mu_s) const {
        return sample(table, altitude_sun_uv(atmosphere, T(0), mu_s, table.width, table.height));
    }
};

/// The sun itself on the ground, as a hook.
template <typename T, typename Scene>
struct DirectIrradianceHook {
    const Atmosphere<T>& atmosphere;
    vec3<T> operator()(T mu_s) const {
        return direct_irradiance<T, Scene>(atmosphere, T(0), mu_s);
    }
};

/// Fills the tables of a shape with `orders` orders of scattering. Scene::nodes is how many samples each leg
/// of a ray has, and how many polar angles each half of the sphere.
///
/// rows(count, body) as in bake_table; each_order(k, table) is shown the radiance of every order from the
/// second on, in [1/sr], before the next one takes its place.
///
/// Units:    those of ScatteringTables, per unit of solar irradiance above the air.
/// Domain:   a shape whose sizes are >= 1; orders >= 1, fewer count as 1.
/// Accuracy: by size, docs/multiple_scattering.md; with 16 nodes sharp aerosol keeps its energy (within 0.8 %
///           for g = 0.8), with 8 it may gain or lose 14 %.
/// Errors:   none.
/// Source:   docs/theory/scattering_orders.md.
template <typename Scene = DefaultScene, typename T, template <typename> class Shape,
          typename Rows = OneAfterAnother, typename EachOrder = KeepNothing>
ScatteringTables<T> bake_scattering(const Shape<T>& shape, int orders, const Rows& rows = Rows{},
                                    const EachOrder& each_order = EachOrder{}) {
    const Atmosphere<T>& atmosphere = shape.atmosphere;
    using Incident = detail::IncidentTable<T, Scene>;
    const auto empty = [&] { return make_table<vec3<T>>(shape.width(), shape.height(), shape.depth()); };
    ScatteringTables<T> out{empty(), empty(), empty(),
                            make_table<vec3<T>>(shape.irradiance_suns, shape.irradiance_altitudes)};
    const auto for_texels = [&](const auto& texel) {
        rows(shape.height() * shape.depth(), [&](int row) {
            for (int i = 0; i < shape.width(); ++i) {
                texel(i, row % shape.height(), row / shape.height());
            }
        });
    };
    for_texels([&](int i, int j, int k) {
        const ScatteringPoint<T> p = shape.point(i, j, k);
        const InScatter<T> light =
            single_inscatter<T, Scene>(atmosphere, p.altitude, p.mu, p.mu_s, p.nu, p.reaches_ground);
        out.rayleigh.texel(i, j, k) = light.rayleigh;
        out.mie.texel(i, j, k) = light.mie;
    });

    // Irradiance of one order, and of all so far.
    Table<vec3<T>> irradiance = out.irradiance;
    const auto irradiate = [&](const auto& radiance) {
        bake_table(
            irradiance,
            [&](int i, int j, int) {
                const vec3<T> uv = texel_centre<T>(irradiance, i, j);
                const AltitudeCosine<T> p = altitude_sun_parameters(atmosphere, vec2<T>(uv.x, uv.y),
                                                                    irradiance.width, irradiance.height);
                return order_irradiance<T, Scene>(atmosphere, p.altitude, p.mu, radiance);
            },
            rows);
        for (std::size_t i = 0; i < irradiance.texels.size(); ++i) {
            out.irradiance.texels[i] += irradiance.texels[i];
        }
    };

    Table<vec3<T>> order = empty();
    Table<vec3<T>> gathered_rayleigh = empty();
    Table<vec3<T>> gathered_mie = empty();
    Incident incident{shape.suns, {}};
    incident.light.resize(static_cast<std::size_t>(shape.altitudes * shape.suns) * Incident::directions);
    const auto gather_from_sky = [&](const auto& radiance, const auto& ground) {
        rows(shape.altitudes * shape.suns, [&](int row) {
            const int altitude = row / shape.suns;
            const int sun = row % shape.suns;
            const ScatteringPoint<T> p = shape.point_at(altitude, sun);
            vec3<T>* const light = incident.row(altitude, sun);
            for (int side = 0; side < 2; ++side) {
                for (int polar = 0; polar < Scene::nodes; ++polar) {
                    for (int azimuth = 0; azimuth < 16; ++azimuth) {
                        light[Incident::index(side, polar, azimuth)] = incident_light<T, Scene>(
                            atmosphere, p.altitude, p.mu_s, side, polar, azimuth, radiance, ground);
                    }
                }
            }
        });
    };

    const TableHook<T, Shape<T>> rayleigh_hook{shape, out.rayleigh};
    const TableHook<T, Shape<T>> mie_hook{shape, out.mie};
    const auto first_order = [&](T altitude, T mu, T mu_s, T nu, bool reaches_ground) {
        return radiance_of_table<T, Scene>(atmosphere, altitude, mu, mu_s, nu, reaches_ground, rayleigh_hook,
                                           mie_hook);
    };
    const TableHook<T, Shape<T>> order_hook{shape, order};
    for (int k = 2; k <= orders; ++k) {
        if (k == 2) {
            gather_from_sky(first_order, DirectIrradianceHook<T, Scene>{atmosphere});
            irradiate(first_order);
        } else {
            gather_from_sky(order_hook, IrradianceHook<T>{atmosphere, irradiance});
            irradiate(order_hook);
        }
        for_texels([&](int i, int j, int l) {
            const ScatteringPoint<T> p = shape.point(i, j, l);
            const PhaseWeighted<T> light = phase_weighted_light<T, Scene>(
                atmosphere, p.altitude, p.mu, p.mu_s, p.nu,
                detail::IncidentRow<T, Scene>{incident.row(shape.altitude_of(i, l), shape.sun_of(i, l))});
            gathered_rayleigh.texel(i, j, l) = light.rayleigh;
            gathered_mie.texel(i, j, l) = light.mie;
        });
        for_texels([&](int i, int j, int l) {
            const ScatteringPoint<T> p = shape.point(i, j, l);
            order.texel(i, j, l) =
                next_order_radiance<T, Scene>(atmosphere, p.altitude, p.mu, p.mu_s, p.nu, p.reaches_ground,
                                              TableHook<T, Shape<T>>{shape, gathered_rayleigh},
                                              TableHook<T, Shape<T>>{shape, gathered_mie});
            out.multiple.texel(i, j, l) += order.texel(i, j, l);
        });
        each_order(k, order);
    }
    if (orders < 2) {
        irradiate(first_order);
    } else {
        irradiate(order_hook);
    }
    return out;
}

}  // namespace airlight
