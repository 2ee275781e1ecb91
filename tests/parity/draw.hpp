#pragma once

// Where the inputs of a row come from: the documented domain, stratified, with its end points. Seeded, so a
// run can be repeated; every draw of one input has a dimension of its own in a low-discrepancy sequence.

#include <airlight/atmosphere.hpp>
#include <airlight/column.hpp>
#include <airlight/diffuse_light.hpp>
#include <airlight/sky_irradiance.hpp>
#include <airlight/viewpoint.hpp>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace parity {

class Draw {
  public:
    /// Input number `index` of `count`. The first eighth runs through the end points in all combinations, as
    /// far as it goes; the second draws them at random; in the rest every eighth number is an end point.
    Draw(std::uint64_t seed, std::size_t index, std::size_t count, bool fog = false,
         bool planet_shadow = true);

    /// A number in [low, high], evenly; the ends and `edges` are drawn often.
    float number(float low, float high, std::initializer_list<float> edges = {});
    /// The same, evenly in the logarithm: low > 0. `edges` may lie outside, such as 0.
    float magnitude(float low, float high, std::initializer_list<float> edges = {});
    /// One of the values.
    int one_of(std::initializer_list<int> values);

    /// A cosine in [-1, 1]: even, close to the horizon, close to both poles; -1, 0, 1 and their neighbours.
    float cosine();
    /// As cosine(), but half of them close to the direction in which a ray touches a sphere of `radius`, seen
    /// from `altitude` above it: where hit and miss part.
    float grazing_cosine(float radius, float altitude);
    /// A unit vector to half a roundoff; along the axes too.
    airlight::vec3<float> direction();
    /// A unit vector whose cosine to `up` is close to `mu`.
    airlight::vec3<float> direction_at(const airlight::vec3<float>& up, double mu);
    /// Three coefficients; alike, zero, or different.
    airlight::vec3<float> spectrum(float low, float high);

    /// One of the library's atmospheres as it is, thick, thin, airless, with layers of no thickness, in
    /// kilometres or on a world of 60 km.
    airlight::Atmosphere<float> atmosphere();
    /// An altitude inside the air, with both ends, or below the ground.
    float altitude_in_air(const airlight::Atmosphere<float>& atmosphere);
    /// From the centre of the planet to a few radii above it.
    float altitude(const airlight::Atmosphere<float>& atmosphere);
    /// An eye at the centre, below the ground, on it, in the air and up to 1e9 m above it.
    airlight::Viewpoint<float> viewpoint(const airlight::Atmosphere<float>& atmosphere);
    /// A view direction: anywhere, at the horizon, the zenith, the nadir, and past the limb.
    airlight::vec3<float> view(const airlight::Atmosphere<float>& atmosphere,
                               const airlight::Viewpoint<float>& eye);
    /// Distance to a surface: 0, short, long, none.
    float distance(const airlight::Atmosphere<float>& atmosphere);
    /// The air along a ray: from a metre of each substance to a thousand kilometres, or none of it.
    airlight::Column<float> column();

    /// Light from all sides: from darkness to brighter than the sun's mean, uneven or not.
    airlight::DiffuseLight<float> diffuse_light();
    airlight::SkyIrradiance<float> sky_irradiance();

    /// A parameter of the aerosol's phase function, or a droplet diameter where the scene has fog.
    float aerosol_parameter();
    /// Whether the scene has the planet's shadow.
    bool planet_shadow() const {
        return planet_shadow_;
    }

  private:
    double next();           // in [0, 1), the next dimension
    std::uint64_t random();  // independent bits
    bool edge(std::size_t n, std::size_t& which);

    enum class Mode { every_edge, random_edges, mixed };
    Mode mode_;
    std::uint64_t state_;
    std::uint64_t seed_;
    std::size_t index_;
    std::size_t remaining_;
    std::size_t dimension_ = 0;
    bool fog_;
    bool planet_shadow_;
};

}  // namespace parity
