#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/planet_shadow.hpp>

namespace parity {

static auto sunlit_ray(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const auto eye = draw.viewpoint(atmosphere);
    const auto direction = draw.view(atmosphere, eye);
    // Anywhere in the sky, straight up, straight down, along the view ray and against it.
    const int sun = draw.one_of({0, 0, 0, 0, 1, 2, 3, 4});
    const auto to_sun =
        sun == 0 ? draw.direction_at(eye.up, static_cast<double>(draw.cosine()))
                 : (sun == 1 ? eye.up : (sun == 2 ? -eye.up : (sun == 3 ? direction : -direction)));
    return std::make_tuple(atmosphere.ground_radius, eye, direction, to_sun);
}

static const bool sun_over_line_row =
    row("sun_over_line")
        .inputs(sunlit_ray)
        .cpu([](auto radius, const auto& eye, const auto& direction, const auto& to_sun) {
            return airlight::sun_over_line(radius, eye, direction, to_sun);
        })
        .to_the_bit();

static const bool shadow_span_row =
    row("shadow_span")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const auto eye = draw.viewpoint(atmosphere);
            const auto direction = draw.view(atmosphere, eye);
            const auto to_sun = draw.direction_at(eye.up, static_cast<double>(draw.cosine()));
            const auto air = airlight::air_ray(atmosphere, eye, direction, airlight::no_surface<float>());
            const auto sun = airlight::sun_over_line(atmosphere.ground_radius, eye, direction, to_sun);
            return std::make_tuple(atmosphere.ground_radius, air.perigee_altitude, sun,
                                   draw.one_of({0, 1}) == 0 ? 0.0F : draw.altitude_in_air(atmosphere));
        })
        .cpu([](auto radius, auto perigee_altitude, const auto& sun, auto shell) {
            return airlight::shadow_span(radius, perigee_altitude, sun, shell);
        })
        .to_the_bit();

}  // namespace parity
