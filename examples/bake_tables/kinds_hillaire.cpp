#include <airlight/tables/hillaire.hpp>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::AltitudeCosine;
using airlight::vec2;
using airlight::vec3;

Kind hillaire() {
    Kind kind{
        "hillaire",
        "Hillaire's table: light of all orders from the second on, as if it came alike from all sides",
        {32, 32, 1},
        "altitude_sun_uv",
        "mean radiance of light scattered at least once; times the scattering coefficient the source of all "
        "orders from the second on",
        "1/sr, per unit of solar irradiance above the air",
        {"R", "G", "B"}};
    const auto texel = [](auto scene, const auto& air, auto altitude, auto mu_s) {
        const airlight::HillaireEffort effort;
        return airlight::hillaire_texel<decltype(altitude), decltype(scene)>(
            air, altitude, mu_s, effort.zeniths, effort.azimuths, effort.steps);
    };
    bake_each_alone(
        kind, [texel](auto scene, const auto& air, const auto& uvw, const support::TableSize& size) {
            using T = scalar_of<std::decay_t<decltype(air)>>;
            const AltitudeCosine<T> at =
                airlight::altitude_sun_parameters(air, vec2<T>(uvw.x, uvw.y), size.width, size.height);
            return texel(scene, air, at.altitude, at.mu);
        });
    kind.on_gpu = [](const Request& request, GpuBaker& gpu) {
        const airlight::HillaireEffort effort;
        const GpuTable table = gpu.make_table(request.size);
        gpu.pass("hillaire", {&table}, {},
                 {{"zeniths", effort.zeniths}, {"azimuths", effort.azimuths}, {"steps", effort.steps}});
        return numbers_of(table, 3);
    };
    kind.has_sun = true;
    compare_each(kind, [texel](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                               Draws& draws, Compared& all) {
        const double altitude = draws.altitude(air);
        const double mu_s = draws.sun_cosine();
        const vec2<double> at =
            airlight::altitude_sun_uv(air, altitude, mu_s, request.size.width, request.size.height);
        add(all, look_up(vec3<double>(at, 0.5)), texel(scene, air, altitude, mu_s));
    });
    kind.remark =
        "The errors are those against the same sum of as many directions without a table; what the method "
        "itself "
        "is off by\nis not among them.";
    return kind;
}

}  // namespace

std::vector<Kind> hillaire_kinds() {
    return {hillaire()};
}

}  // namespace bake_tables
