#pragma once

// Directions as air and surfaces choose them.

#include <airlight/types.hpp>

#include "random.hpp"

namespace reference {

using Vector = airlight::vec3<double>;

/// A unit vector at an angle to another, turned about it evenly.
Vector turned(const Vector& direction, double cosine, Random& random);

/// A direction from a Lambert surface.
Vector from_surface(const Vector& normal, Random& random);

/// Cosine with the distribution of cornette_shanks_phase: Henyey and Greenstein's, of which each is kept with
/// the chance that it lacks, (1 + x^2) / 2.
double sample_cornette_shanks(double g, Random& random);

}  // namespace reference
