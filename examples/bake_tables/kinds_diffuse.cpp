#include <airlight/tables/diffuse.hpp>

#include "by_scene.hpp"
#include "families.hpp"

namespace bake_tables {
namespace {

using airlight::vec2;
using airlight::vec3;
using airlight::vec4;

constexpr int layers = airlight::diffuse_table_layers;
constexpr int unpacked_layers = 12;

/// The same passes as airlight::bake_diffuse_table.
Numbers diffuse_on_gpu(const Request& request, GpuBaker& gpu) {
    const auto layered = [&](int count) {
        return gpu.make_table({request.size.width, request.size.height, count}, support::TableShape::layers);
    };
    const GpuTable before = layered(layers);
    GpuTable next = layered(unpacked_layers);
    GpuTable last = layered(unpacked_layers);
    GpuTable sum = layered(unpacked_layers);
    GpuTable next_sum = layered(unpacked_layers);
    gpu.expect_passes(3 * request.orders);
    for (int order = 1; order <= request.orders; ++order) {
        const bool ends = order == request.orders;
        gpu.column_pass("diffuse_gather", next, {{"before_table", &before}},
                        {{"first_order", order == 1 ? 1 : 0}});
        gpu.column_pass("diffuse_sum", next_sum,
                        {{"sum_table", &sum}, {"last_table", &last}, {"next_table", &next}},
                        {{"last_order", ends && order > 1 ? 1 : 0}});
        std::swap(sum, next_sum);
        gpu.column_pass("diffuse_pack", before, {{"light_table", ends ? &sum : &next}}, {});
        std::swap(last, next);
    }
    return numbers_of(before, 4);
}

Kind diffuse() {
    Kind kind{
        "diffuse",
        "light from all sides: multiple scattering, ground bounce and sky irradiance of all orders, with "
        "where it comes from",
        {64, 16, layers},
        "diffuse_table_uv",
        "seven layers of DiffuseTexels, three of IrradianceTexels, see diffuse_table.hpp; layers are not "
        "filtered",
        "logarithms of 1/sr and of 1, and ratios",
        {"R", "G", "B", "A"}};
    kind.has_orders = true;
    kind.may_be_negative = true;
    kind.layered = true;
    kind.small_size = {9, 5, layers};
    kind.size_rule = "give a depth of 10, its layers";
    kind.takes_size = [](const support::TableSize& size) {
        return size.width >= 2 && size.height >= 2 && size.depth == layers;
    };
    bake_on_cpu(kind, [](auto scene, const auto& air, const Request& request, const support::Rows& rows) {
        using T = scalar_of<std::decay_t<decltype(air)>>;
        rows.expect_passes(request.orders);
        return support::numbers_of(airlight::bake_diffuse_table<T, decltype(scene)>(
                                       air, request.size.width, request.size.height, request.orders, rows)
                                       .texels);
    });
    kind.on_gpu = diffuse_on_gpu;
    kind.has_sun = true;
    compare_each(kind, [](auto scene, const auto& air, const Request& request, const LookUp& look_up,
                          Draws& draws, Compared& all) {
        const double altitude = draws.altitude(air);
        const double mu_s = draws.sun_cosine();
        const vec2<double> uv =
            airlight::diffuse_table_uv(air, altitude, mu_s, request.size.width, request.size.height);
        vec4<double> read[layers];
        for (int k = 0; k < layers; ++k) {
            const std::vector<double> texel = look_up(vec3<double>(uv, (k + 0.5) / layers));
            read[k] = vec4<double>(texel[0], texel[1], texel[2], texel[3]);
        }
        const auto light = airlight::unpacked_diffuse_light(
            airlight::DiffuseTexels<double>{read[0], read[1], read[2], read[3], read[4], read[5], read[6]});
        const auto sky =
            airlight::unpacked_sky_irradiance(airlight::IrradianceTexels<double>{read[7], read[8], read[9]});
        const auto exact = airlight::gathered_light<double, decltype(scene)>(air, altitude, mu_s, true);
        add(all, light.mean, exact.light.mean);
        add(all, sky.down, exact.irradiance.down);
    });
    kind.remark =
        "The errors are those of the mean radiance and of the irradiance of a level surface, by the first "
        "order of\n"
        "scattering. The largest, 1, is of irradiance between the last two rows: at the very top nothing "
        "comes from "
        "above.\nHalf precision has its place in the payload itself: logarithms and ratios.";
    return kind;
}

}  // namespace

std::vector<Kind> diffuse_kinds() {
    return {diffuse()};
}

}  // namespace bake_tables
