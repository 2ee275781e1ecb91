#include "directions.hpp"

#include <airlight/phase.hpp>
#include <algorithm>
#include <cmath>

namespace reference {

Vector turned(const Vector& direction, double cosine, Random& random) {
    // Duff et al., Building an Orthonormal Basis, Revisited (2017).
    const double sign = std::copysign(1.0, direction.z);
    const double a = -1.0 / (sign + direction.z);
    const double b = direction.x * direction.y * a;
    const Vector side(1 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x);
    const Vector other(b, sign + direction.y * direction.y * a, -direction.y);
    const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
    const double angle = 2 * airlight::pi<double> * random();
    const Vector out =
        direction * cosine + side * (sine * std::cos(angle)) + other * (sine * std::sin(angle));
    return out / glm::length(out);
}

Vector from_surface(const Vector& normal, Random& random) {
    return turned(normal, std::sqrt(1 - random()), random);
}

double sample_cornette_shanks(double g, Random& random) {
    for (;;) {
        const double x = airlight::sample_henyey_greenstein_phase(random(), g);
        if (2 * random() <= 1 + x * x) {
            return x;
        }
    }
}

}  // namespace reference
