#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/view_path.hpp>
#include <airlight/viewpoint.hpp>

namespace parity {

static const bool viewpoint_from_centre_row =
    row("viewpoint_from_centre")
        .inputs([](Draw& draw) {
            const float radius = draw.magnitude(1e3F, 1e8F, {6.36e6F});
            // The centre itself, inside the planet, on the ground, far away.
            const float share = draw.magnitude(1e-3F, 200.0F, {0.0F, 1.0F, 1.0F + 1e-6F});
            return std::make_tuple(radius, draw.direction() * (radius * share));
        })
        .cpu([](auto radius, const auto& position) {
            return airlight::viewpoint_from_centre(radius, position);
        })
        .to_the_bit();

static const bool viewpoint_from_surface_row =
    row("viewpoint_from_surface")
        .inputs([](Draw& draw) {
            const float radius = draw.magnitude(1e3F, 1e8F, {6.36e6F});
            const auto up = draw.direction();
            // From the origin itself to far away; also straight down to the planet's centre.
            const float share = draw.magnitude(1e-7F, 200.0F, {0.0F, 1.0F});
            const auto towards = draw.one_of({0, 1, 2, 3}) == 0 ? -up : draw.direction();
            return std::make_tuple(radius, towards * (radius * share), up);
        })
        .cpu([](auto radius, const auto& position, const auto& up) {
            return airlight::viewpoint_from_surface(radius, position, up);
        })
        .to_the_bit();

static const bool altitude_along_ray_row =
    row("altitude_along_ray")
        .inputs([](Draw& draw) {
            const auto atmosphere = draw.atmosphere();
            const float altitude = draw.altitude(atmosphere);
            const float along = (atmosphere.ground_radius + altitude) * draw.cosine();
            const float distance = draw.magnitude(1e-6F, 10.0F, {0.0F}) * atmosphere.ground_radius;
            return std::make_tuple(atmosphere.ground_radius, altitude, along, distance);
        })
        .cpu([](auto radius, auto altitude, auto along, auto distance) {
            return airlight::altitude_along_ray(radius, altitude, along, distance);
        })
        .to_the_bit();

static auto ray(Draw& draw) {
    const auto atmosphere = draw.atmosphere();
    const auto eye = draw.viewpoint(atmosphere);
    const auto direction = draw.view(atmosphere, eye);
    return std::make_tuple(atmosphere, eye, direction, draw.distance(atmosphere));
}

static const bool air_ray_row =
    row("air_ray")
        .inputs(ray)
        .count(65536)
        .cpu([](const auto& atmosphere, const auto& eye, const auto& direction, auto distance) {
            return airlight::air_ray(atmosphere, eye, direction, distance);
        })
        .to_the_bit();

static const bool view_path_row =
    row("view_path")
        .inputs(ray)
        .count(65536)
        .cpu([](const auto& atmosphere, const auto& eye, const auto& direction, auto distance) {
            return airlight::view_path(atmosphere, eye, direction, distance);
        })
        .to_the_bit();

}  // namespace parity
