#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/color.hpp>

namespace parity {

// In [0, 1] and somewhat outside, with both sides of the knees of both transfer functions.
static float channel(Draw& draw) {
    return draw.number(0.0F, 1.0F,
                       {-0.5F, 1.5F, 0.0031308F, 0.00314F, 0.00312F, 0.04045F, 0.0406F, 0.0403F, 1e-8F});
}
static airlight::vec3<float> channels(Draw& draw) {
    const float red = channel(draw);
    const float green = channel(draw);
    return airlight::vec3<float>(red, green, channel(draw));
}

static const bool luminance_row =
    row("luminance")
        .inputs([](Draw& draw) { return std::make_tuple(draw.spectrum(1e-10F, 1e10F)); })
        .cpu([](const auto& radiance) { return airlight::luminance(radiance); })
        .to_the_bit();

static const bool exposed_row =
    row("exposed")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.spectrum(1e-6F, 1e6F), draw.magnitude(1e-6F, 1e3F, {0.0F}));
        })
        .cpu([](const auto& radiance, auto exposure) { return airlight::exposed(radiance, exposure); })
        .within_bound();

static const bool srgb_channel_from_linear_row =
    row("srgb_channel_from_linear")
        .inputs([](Draw& draw) { return std::make_tuple(channel(draw)); })
        .cpu([](auto linear) { return airlight::srgb_channel_from_linear(linear); })
        .within_bound();

static const bool linear_channel_from_srgb_row =
    row("linear_channel_from_srgb")
        .inputs([](Draw& draw) { return std::make_tuple(channel(draw)); })
        .cpu([](auto encoded) { return airlight::linear_channel_from_srgb(encoded); })
        .within_bound();

static const bool srgb_from_linear_row =
    row("srgb_from_linear")
        .inputs([](Draw& draw) { return std::make_tuple(channels(draw)); })
        .cpu([](const auto& linear) { return airlight::srgb_from_linear(linear); })
        .within_bound();

static const bool linear_from_srgb_row =
    row("linear_from_srgb")
        .inputs([](Draw& draw) { return std::make_tuple(channels(draw)); })
        .cpu([](const auto& encoded) { return airlight::linear_from_srgb(encoded); })
        .within_bound();

}  // namespace parity
