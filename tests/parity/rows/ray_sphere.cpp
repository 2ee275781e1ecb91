#include "row.hpp"
// row.hpp first: see bounded.hpp.
#include <airlight/ray_sphere.hpp>

namespace parity {

static const bool intersect_ray_sphere_row =
    row("intersect_ray_sphere")
        .inputs([](Draw& draw) {
            const float radius = draw.magnitude(1.0F, 1e8F, {6.371e6F});
            const float altitude = draw.magnitude(1e-7F, 150.0F, {0.0F, -1.0F, -0.5F, -1e-6F}) * radius;
            return std::make_tuple(radius, altitude, draw.grazing_cosine(radius, altitude));
        })
        .cpu([](auto radius, auto altitude, auto mu) {
            return airlight::intersect_ray_sphere(radius, altitude, mu);
        })
        .to_the_bit();

}  // namespace parity
