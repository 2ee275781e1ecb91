#include <airlight/scattering_of_table.hpp>
#include <airlight/tables/bruneton.hpp>
#include <airlight/tables/inscatter.hpp>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::vec2;
using airlight::vec3;

// Of the four-dimensional table's width; how many suns and angles there are is not free on the command line.
constexpr int nus = 8;
constexpr int directions = 2 * airlight::DefaultScene::nodes * 16;

template <typename T>
airlight::InscatterShape<T> inscatter_shape(const airlight::Atmosphere<T>& air,
                                            const support::TableSize& size) {
    airlight::InscatterShape<T> shape{air};
    shape.altitudes = size.width;
    shape.views = size.height;
    shape.suns = size.depth;
    return shape;
}

template <typename T>
airlight::BrunetonShape<T> bruneton_shape(const airlight::Atmosphere<T>& air,
                                          const support::TableSize& size) {
    airlight::BrunetonShape<T> shape{air};
    shape.nus = nus;
    shape.suns = size.width / nus;
    shape.views = size.height;
    shape.altitudes = size.depth;
    return shape;
}

/// The tables while a bake on the GPU fills them.
struct GpuOrders {
    GpuTable rayleigh;
    GpuTable mie;
    GpuTable multiple;
    GpuTable irradiance;
};

/// Order by order, in the same passes as airlight::bake_scattering. `shape` names the mapping in the shaders.
GpuOrders orders_on_gpu(const Request& request, GpuBaker& gpu, const std::string& shape,
                        const std::vector<Setting>& sizes, int altitudes, int suns) {
    const support::TableSize small{64, 16, 1};
    gpu.expect_passes(airlight::passes_of_bake(request.orders));
    const auto pass = [&](const std::string& shader, const std::vector<const GpuTable*>& targets,
                          const std::vector<Source>& sources) {
        gpu.pass(shader, targets, sources, sizes, "#define BAKE_" + shape + "\n");
    };
    GpuOrders out{gpu.make_table(request.size), gpu.make_table(request.size), gpu.make_table(request.size),
                  gpu.make_table(small)};
    pass("scattering_single", {&out.rayleigh, &out.mie}, {});

    GpuTable order = gpu.make_table(request.size);
    GpuTable gathered_rayleigh = gpu.make_table(request.size);
    GpuTable gathered_mie = gpu.make_table(request.size);
    GpuTable incident = gpu.make_table({suns, altitudes, directions});
    GpuTable irradiance = gpu.make_table(small);
    GpuTable next_irradiance = gpu.make_table(small);
    GpuTable next_multiple = gpu.make_table(request.size);
    const std::vector<Source> first = {{"rayleigh_table", &out.rayleigh}, {"mie_table", &out.mie}};
    const auto irradiate = [&](const std::string& order_shader, const std::vector<Source>& light) {
        std::vector<Source> sources = light;
        sources.push_back({"before", &out.irradiance});
        pass("scattering_irradiance" + order_shader, {&irradiance, &next_irradiance}, sources);
        std::swap(out.irradiance, next_irradiance);
    };
    for (int k = 2; k <= request.orders; ++k) {
        if (k == 2) {
            pass("scattering_incident_first", {&incident}, first);
            irradiate("_first", first);
        } else {
            pass("scattering_incident", {&incident},
                 {{"order_table", &order}, {"irradiance_table", &irradiance}});
            irradiate("", {{"order_table", &order}});
        }
        pass("scattering_gather", {&gathered_rayleigh, &gathered_mie}, {{"incident_table", &incident}});
        pass("scattering_next", {&order, &next_multiple},
             {{"gathered_rayleigh_table", &gathered_rayleigh},
              {"gathered_mie_table", &gathered_mie},
              {"before", &out.multiple}});
        std::swap(out.multiple, next_multiple);
    }
    if (request.orders < 2) {
        irradiate("_first", first);
    } else {
        irradiate("", {{"order_table", &order}});
    }
    return out;
}

Numbers all_numbers_of(const GpuOrders& tables) {
    return side_by_side({&tables.rayleigh, &tables.mie, &tables.multiple});
}

std::vector<Setting> inscatter_sizes(const support::TableSize& size) {
    return {{"altitudes", size.width}, {"views", size.height}, {"suns", size.depth}, {"nus", 1}};
}
std::vector<Setting> bruneton_sizes(const support::TableSize& size) {
    return {{"altitudes", size.depth}, {"views", size.height}, {"suns", size.width / nus}, {"nus", nus}};
}

const std::string scattering_payload =
    "light scattered once by molecules and by aerosol, without phase functions [1]; radiance of orders 2 and "
    "up "
    "[1/sr]";
const std::vector<std::string> scattering_channels = {
    "rayleigh.R", "rayleigh.G", "rayleigh.B", "mie.R",      "mie.G",
    "mie.B",      "multiple.R", "multiple.G", "multiple.B",
};

/// Radiance of order 1 as a scene would ask for it, from a table and without one.
template <typename Scene, typename Read>
void compare_first_order(const airlight::Atmosphere<double>& air, Draws& draws, Compared& all,
                         const Read& read) {
    const double altitude = draws.altitude(air);
    const double horizon = airlight::horizon_cosine(air.ground_radius, altitude);
    const double mu = std::cos(draws.unit() * airlight::pi<double>);
    const double mu_s = draws.sun_cosine();
    const double across = std::sqrt((1 - mu * mu) * (1 - mu_s * mu_s));
    const double nu = airlight::table_cosine(mu * mu_s + across * draws.azimuth_cosine());
    const bool ground = mu < horizon;
    const auto light = airlight::single_inscatter<double, Scene>(air, altitude, mu, mu_s, nu, ground);
    const auto radiance = [&](const vec3<double>& rayleigh, const vec3<double>& mie) {
        return airlight::rayleigh_phase(nu) * rayleigh + airlight::cornette_shanks_phase(nu, air.mie_g) * mie;
    };
    const std::vector<double> got = read(altitude, mu, mu_s, nu, ground);
    add(all, radiance(vec3<double>(got[0], got[1], got[2]), vec3<double>(got[3], got[4], got[5])),
        radiance(light.rayleigh, light.mie));
}

Kind inscatter3d() {
    Kind kind{"inscatter3d",
              "light scattered towards a point over altitude, view and sun, order by order; no azimuth",
              {32, 128, 64},
              "inscatter_uvw",
              scattering_payload,
              "1 and 1/sr, per unit of solar irradiance above the air",
              scattering_channels};
    kind.has_orders = true;
    kind.small_size = {5, 8, 6};
    kind.size_rule = "give an even height: half of the rows look at the ground";
    kind.takes_size = even_height;
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const support::Rows& rows) {
        rows.expect_passes(airlight::passes_of_bake(request.orders));
        const auto tables = airlight::bake_scattering<decltype(scene)>(inscatter_shape(air, request.size),
                                                                       request.orders, rows);
        return support::numbers_of(tables.rayleigh, tables.mie, tables.multiple);
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        return all_numbers_of(orders_on_gpu(request, gpu, "THREE_DIMENSIONS", inscatter_sizes(request.size),
                                            request.size.width, request.size.depth));
    };
    kind.has_sun = true;
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const support::TableSize& size = request.size;
        compare_first_order<decltype(scene)>(
            air, draws, all, [&](double altitude, double mu, double mu_s, double, bool ground) {
                return look_up(airlight::inscatter_uvw(air, altitude, mu, mu_s, ground,
                                                       airlight::lowest_sun_cosine(air), size.width,
                                                       size.height, size.depth));
            });
    });
    kind.remark =
        "The errors are those of the radiance of order 1, phase functions included; most of them come from "
        "leaving out the\nazimuth, which no size mends.";
    return kind;
}

Kind bruneton() {
    Kind kind{
        "bruneton",
        "Bruneton's table: light scattered towards a point over altitude, view, sun and the angle between "
        "these, order by order",
        {256, 128, 32},
        "scattering_lookup",
        scattering_payload,
        "1 and 1/sr, per unit of solar irradiance above the air",
        scattering_channels};
    kind.has_orders = true;
    kind.small_size = {24, 8, 5};
    kind.size_rule = "give a width of 8 times the number of suns, and an even height";
    kind.takes_size = [](const support::TableSize& size) {
        return even_height(size) && size.width % nus == 0;
    };
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const support::Rows& rows) {
        rows.expect_passes(airlight::passes_of_bake(request.orders));
        const auto tables = airlight::bake_scattering<decltype(scene)>(bruneton_shape(air, request.size),
                                                                       request.orders, rows);
        return support::numbers_of(tables.rayleigh, tables.mie, tables.multiple);
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        return all_numbers_of(orders_on_gpu(request, gpu, "FOUR_DIMENSIONS", bruneton_sizes(request.size),
                                            request.size.depth, request.size.width / nus));
    };
    kind.has_sun = true;
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const support::TableSize& size = request.size;
        compare_first_order<decltype(scene)>(
            air, draws, all, [&](double altitude, double mu, double mu_s, double nu, bool ground) {
                const auto at = airlight::scattering_lookup(air, altitude, mu, mu_s, nu, ground,
                                                            airlight::lowest_sun_cosine(air), nus,
                                                            size.width / nus, size.height, size.depth);
                std::vector<double> mixed = look_up(at.first);
                const std::vector<double> second = look_up(at.second);
                for (std::size_t c = 0; c < mixed.size(); ++c) {
                    mixed[c] += at.weight * (second[c] - mixed[c]);
                }
                return mixed;
            });
    });
    kind.remark = "The errors are those of the radiance of order 1, phase functions included.";
    return kind;
}

Kind irradiance() {
    Kind kind{"irradiance",
              "irradiance of a level surface by the sky, all orders of inscatter3d, without the sun itself",
              {64, 16, 1},
              "altitude_sun_uv",
              "irradiance of a level surface by scattered light",
              "1, per unit of solar irradiance above the air",
              {"R", "G", "B"}};
    kind.has_orders = true;
    kind.size_rule = "it has 64x16 texels";
    kind.takes_size = [](const support::TableSize& size) { return size.width == 64 && size.height == 16; };
    kind.small_size = {64, 16, 1};
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const support::Rows& rows) {
        rows.expect_passes(airlight::passes_of_bake(request.orders));
        const auto tables = airlight::bake_scattering<decltype(scene)>(inscatter_shape(air, {16, 64, 32}),
                                                                       request.orders, rows);
        return support::numbers_of(tables.irradiance);
    });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        const support::TableSize around{16, 64, 32};
        const Request of_table{request.preset, around, request.orders};
        return numbers_of(orders_on_gpu(of_table, gpu, "THREE_DIMENSIONS", inscatter_sizes(around),
                                        around.width, around.depth)
                              .irradiance,
                          3);
    };
    return kind;
}

}  // namespace

std::vector<Kind> scattering_kinds() {
    return {inscatter3d(), bruneton(), irradiance()};
}

}  // namespace bake_tables
