#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/diffuse_light.hpp>

namespace parity {

static const bool even_light_row =
    row("even_light")
        .inputs([](Draw& draw) { return std::make_tuple(draw.spectrum(1e-9F, 1e2F)); })
        .cpu([](const auto& radiance) { return airlight::even_light(radiance); })
        .to_the_bit();

static const bool scattered_diffuse_light_row =
    row("scattered_diffuse_light")
        .inputs([](Draw& draw) {
            const airlight::vec3<float> up(0.0F, 0.0F, 1.0F);
            const auto direction = draw.direction_at(up, static_cast<double>(draw.cosine()));
            const auto to_sun = draw.direction_at(up, static_cast<double>(draw.cosine()));
            const float mu = direction.z;
            const float cos_theta = glm::clamp(
                direction.x * to_sun.x + direction.y * to_sun.y + direction.z * to_sun.z, -1.0F, 1.0F);
            return std::make_tuple(draw.diffuse_light(), draw.spectrum(1e-9F, 1e-2F),
                                   draw.spectrum(1e-9F, 1e-2F), mu, cos_theta, to_sun.z);
        })
        .cpu(
            [](const auto& light, const auto& rayleigh, const auto& mie, auto mu, auto cos_theta, auto mu_s) {
                return airlight::scattered_diffuse_light(light, rayleigh, mie, mu, cos_theta, mu_s);
            })
        .to_the_bit();

}  // namespace parity
