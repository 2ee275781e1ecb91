#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/aerial_perspective.hpp>
#include <airlight/sun.hpp>

namespace parity {

static const bool solar_disc_row = row("solar_disc")
                                       .no_inputs()
                                       .cpu([](auto run) {
                                           using R = decltype(run);
                                           return airlight::solar_disc<typename R::T>();
                                       })
                                       .to_the_bit();

static const bool disc_solid_angle_row =
    row("disc_solid_angle")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.magnitude(1e-6F, 1.0F, {0.0F, 0.00465F}));
        })
        .cpu([](auto sin_radius) { return airlight::disc_solid_angle(sin_radius); })
        .to_the_bit();

static const bool disc_radiance_row =
    row("disc_radiance")
        .inputs([](Draw& draw) { return std::make_tuple(draw.magnitude(1e-6F, 1.0F, {0.00465F})); })
        .cpu([](auto sin_radius) { return airlight::disc_radiance(sin_radius); })
        .to_the_bit();

static const bool windowed_power_row =
    row("windowed_power")
        .inputs([](Draw& draw) {
            const float x = draw.number(-1.5F, 1.0F, {0.0F});
            return std::make_tuple(x, draw.magnitude(1e-4F, 10.0F, {0.0F, 0.03125F}),
                                   draw.number(0.1F, 3.0F, {0.0F, 1.0F, 2.0F}));
        })
        .cpu([](auto x, auto half_width, auto power) {
            return airlight::windowed_power(x, half_width, power);
        })
        .within_bound();

static const bool limb_darkening_row =
    row("limb_darkening")
        .inputs([](Draw& draw) {
            const float square = draw.number(0.0F, 2.0F, {1.0F});
            return std::make_tuple(square, draw.number(0.1F, 2.0F, {0.0F}),
                                   draw.magnitude(1e-4F, 10.0F, {0.0F, 0.03125F}));
        })
        .cpu([](auto square, auto exponent, auto spread) {
            return airlight::limb_darkening(square, exponent, spread);
        })
        .within_bound();

static const bool sun_radiance_row =
    row("sun_radiance")
        .inputs([](Draw& draw) {
            const float sin_radius = draw.magnitude(1e-4F, 1.0F, {0.00465F});
            const auto disc = airlight::SunDisc<float>{sin_radius, draw.spectrum(0.1F, 2.0F),
                                                       sin_radius * draw.magnitude(1e-3F, 10.0F, {0.0F})};
            const auto to_sun = draw.direction();
            // Around the sun, at its middle, opposite, and anywhere.
            const float off = draw.number(0.0F, 1.5F) * sin_radius;
            const int where = draw.one_of({0, 0, 0, 0, 0, 0, 1, 2, 3});
            const auto direction =
                where == 0
                    ? draw.direction_at(to_sun, std::sqrt(std::max(0.0, 1.0 - double(off) * double(off))))
                : where == 1 ? to_sun
                : where == 2 ? -to_sun
                             : draw.direction();
            return std::make_tuple(disc, direction, to_sun);
        })
        .cpu([](const auto& disc, const auto& direction, const auto& to_sun) {
            return airlight::sun_radiance(disc, direction, to_sun);
        })
        .within_bound();

static const bool visible_middle_row =
    row("visible_middle")
        .inputs([](Draw& draw) {
            return std::make_tuple(draw.number(-1.25F, 1.25F, {-1.0F, 0.0F, 1.0F}));
        })
        .cpu([](auto gap) { return airlight::visible_middle(gap); })
        .to_the_bit();

static const bool sunlight_row =
    row("sunlight")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            return std::make_tuple(atmosphere, altitude,
                                   draw.grazing_cosine(atmosphere.ground_radius, altitude),
                                   draw.magnitude(1e-4F, 1.0F, {0.0F, 0.00465F}));
        })
        .cpu([](auto run, const auto& atmosphere, auto altitude, auto mu_s, auto sin_radius) {
            using R = decltype(run);
            return airlight::sunlight<typename R::T, typename R::Scene>(atmosphere, altitude, mu_s,
                                                                        sin_radius);
        })
        .within_bound();

static const bool elek_sun_lobe_row =
    row("elek_sun_lobe")
        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine(), draw.number(-0.99F, 0.99F, {0.0F})); })
        .cpu([](auto cos_theta, auto g) { return airlight::elek_sun_lobe(cos_theta, g); })
        .to_the_bit();

static const bool leenman_sun_row = row("leenman_sun")
                                        .inputs([](Draw& draw) { return std::make_tuple(draw.cosine()); })
                                        .cpu([](auto cos_theta) { return airlight::leenman_sun(cos_theta); })
                                        .to_the_bit();

static const bool sun_irradiance_row =
    row("sun_irradiance")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const airlight::Viewpoint<float> place{draw.altitude_in_air(atmosphere), draw.direction()};
            const auto to_sun = draw.direction_at(
                place.up, static_cast<double>(draw.grazing_cosine(atmosphere.ground_radius, place.altitude)));
            return std::make_tuple(atmosphere, place, draw.direction(), to_sun,
                                   draw.magnitude(1e-4F, 1.0F, {0.0F, 0.00465F}));
        })
        .left_out(0.35, 0.05, "half of the suns touch the horizon, and some lie exactly on it")
        .cpu([](auto run, const auto& atmosphere, const auto& place, const auto& normal, const auto& to_sun,
                auto sin_radius) {
            using R = decltype(run);
            return airlight::sun_irradiance<typename R::T, typename R::Scene>(atmosphere, place, normal,
                                                                              to_sun, sin_radius);
        })
        .within_bound();

}  // namespace parity
