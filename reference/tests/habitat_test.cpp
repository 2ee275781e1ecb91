#include "reference/habitat.hpp"

#include <airlight/gauss.hpp>
#include <airlight/habitat_indirect.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

using namespace reference;

namespace {

using airlight::pi;

/// The library's habitat, with walls of this albedo.
Habitat rama(double albedo) {
    return Habitat{airlight::rama_air<double>(), airlight::rama_lights<double>(), Vector(albedo), false};
}

Habitat without_air(Habitat habitat) {
    habitat.air.rayleigh_scattering = habitat.air.mie_scattering = habitat.air.mie_absorption = Vector(0.0);
    return habitat;
}

/// How many standard errors two estimates are apart.
double apart(const Estimate& a, const Estimate& b) {
    return std::fabs(a.mean - b.mean) / std::hypot(a.error, b.error);
}

/// Integral from `begin` to `end` by the rule of Gauss with 5 points in each of `pieces`.
template <typename Result, typename Integrand>
Result integral(double begin, double end, int pieces, const Integrand& integrand) {
    const double width = (end - begin) / pieces;
    Result sum(0);
    for (int i = 0; i < pieces; ++i) {
        for (int k = 0; k < 5; ++k) {
            sum += width * airlight::gauss_5_weights<double>[k] *
                   integrand(begin + (i + airlight::gauss_5_positions<double>[k]) * width);
        }
    }
    return sum;
}

/// Integral of `towards_eye(direction)` times the strips' light that reaches a place over their area: no
/// solid angle, no angle, no way around the corners.
template <typename TowardsEye>
Vector straight_light(const Habitat& habitat, const Vector& place, int pieces_along, int pieces_across,
                      const TowardsEye& towards_eye) {
    Vector sum(0, 0, 0);
    for (int i = 0; i < 6; ++i) {
        const airlight::LinearLight<double> strip = airlight::habitat_strip(habitat.air, habitat.lights, i);
        const Vector side = glm::cross(strip.normal, strip.along);
        sum += integral<Vector>(-strip.half_length, strip.half_length, pieces_along, [&](double x) {
            return integral<Vector>(-strip.width / 2, strip.width / 2, pieces_across, [&](double y) {
                const Vector light = strip.centre + x * strip.along + y * side;
                const Vector way = light - place;
                const double square = glm::dot(way, way);
                const Vector to_light = way / std::sqrt(square);
                const double cosine = -glm::dot(to_light, strip.normal);
                return strip.radiance * (std::max(cosine, 0.0) / square) *
                       airlight::habitat_transmittance(habitat.air, light, place) * towards_eye(to_light);
            });
        });
    }
    return sum;
}

struct Ray {
    std::string what;
    Vector eye;
    Vector direction;
    double spared = 0;      // [m] before the wall
    int pieces = 40;        // of the quadrature along the ray,
    int pieces_along = 44;  // along a strip
    int pieces_across = 1;  // and across it
};

double length_of(const Habitat& habitat, const Ray& ray) {
    return airlight::habitat_wall(habitat.air, habitat.lights, ray.eye, ray.direction).distance - ray.spared;
}

/// A place evenly on walls and caps, and how they face.
std::pair<Vector, Vector> on_wall(const Habitat& habitat, Random& random) {
    const double r = habitat.air.radius;
    const double h = habitat.lights.half_length;
    const double angle = 2 * pi<double> * random();
    const Vector out(0, std::cos(angle), std::sin(angle));
    const double share = random() * (2 * h + r);  // areas over 2 pi r: the wall's 2 h, the caps' r / 2 each
    if (share < 2 * h) {
        return {Vector(share - h, 0, 0) + r * out, -out};
    }
    const double side = share < 2 * h + r / 2 ? 1 : -1;
    return {Vector(side * h, 0, 0) + r * std::sqrt(random()) * out, Vector(-side, 0, 0)};
}

}  // namespace

TEST_CASE("habitat: light scattered once is the integral over the ray and the area of the strips") {
    Habitat habitat = rama(0.3);
    const std::vector<Ray> rays = {
        {"along the axis", Vector(-20e3, 100, 50), glm::normalize(Vector(1, 0.02, -0.01))},
        {"from the ground, up", Vector(2000, 0, -7990), Vector(0, 0, 1)},
        {"towards a strip", Vector(-3000, -4000, 1000), glm::normalize(Vector(11000, 12000, -1000)), 300},
        {"the last stretch before a strip", Vector(8000, 7700, 20), glm::normalize(Vector(0.5, 1, 0)), 60, 4,
         550, 4},
        {"along a strip, 300 m off", Vector(3000, 7700, 0), Vector(1, 0, 0)},
        {"past a strip, 150 m off", Vector(9000, 7850, 2000), glm::normalize(Vector(0.3, 0, -1))},
    };
    double squares = 0;
    int values = 0;
    for (const bool isotropic : {false, true}) {
        habitat.isotropic = isotropic;
        for (const Ray& ray : rays) {
            const double distance = length_of(habitat, ray);
            const Vector expected = integral<Vector>(0, distance, ray.pieces, [&](double t) {
                const Vector place = ray.eye + t * ray.direction;
                const double density = airlight::habitat_density(habitat.air, place);
                const auto towards_eye = [&](const Vector& to_light) {
                    const double cos_theta = glm::dot(to_light, ray.direction);
                    const double molecules =
                        isotropic ? 1 / (4 * pi<double>) : 3 / (16 * pi<double>)*(1 + cos_theta * cos_theta);
                    const double aerosol =
                        isotropic ? molecules : airlight::cornette_shanks_phase(cos_theta, habitat.air.mie_g);
                    return habitat.air.rayleigh_scattering * molecules + habitat.air.mie_scattering * aerosol;
                };
                return density * airlight::habitat_transmittance(habitat.air, ray.eye, place) *
                       straight_light(habitat, place, ray.pieces_along, ray.pieces_across, towards_eye);
            });
            for (int channel = 0; channel < 3; ++channel) {
                const Estimate got = habitat_air_light(habitat, channel, ray.eye, ray.direction, distance, 1,
                                                       40000, static_cast<std::uint64_t>(++values));
                const double quadrature = 2e-5 * expected[channel];  // half the pieces move it by 1.2e-5
                const double off = std::fabs(got.mean - expected[channel]) / (got.error + quadrature);
                squares += off * off;
                std::printf("%s%s, channel %d: %.6g +- %.2g %% for %.6g\n", ray.what.c_str(),
                            isotropic ? ", evenly" : "", channel, got.mean, 100 * got.error / got.mean,
                            expected[channel]);
                CAPTURE(ray.what);
                CAPTURE(channel);
                CHECK(off < 4.5);                    // 1e-5 each, of groups whose spread is known to 11 %
                CHECK(got.error < 3e-3 * got.mean);  // what a table of such rays is to be good to
            }
        }
    }
    CHECK(squares / values < 1.6);  // 1 expected, with a spread of 0.26
}

TEST_CASE("habitat: without air a surface has the irradiance of the strips") {
    const Habitat bare = without_air(rama(0.3));
    const std::vector<Ray> surfaces = {
        {"on the axis", Vector(0, 0, 0), glm::normalize(Vector(1, 2, 0.5))},
        {"on the wall", Vector(-9000, 0, 8000), Vector(0, 0, -1)},
        {"on a cap", Vector(24e3, 3000, -1000), Vector(-1, 0, 0)},
        {"above the end of a strip", Vector(5000, 4000, 0), Vector(0, 1, 0)},
    };
    for (const Ray& surface : surfaces) {
        Vector expected(0, 0, 0);
        for (int i = 0; i < 6; ++i) {
            expected += airlight::strip_irradiance(airlight::habitat_strip(bare.air, bare.lights, i),
                                                   surface.eye, surface.direction);
        }
        const Estimate got = habitat_surface_irradiance(bare, 1, surface.eye, surface.direction, 0, 40000, 7);
        std::printf("irradiance %s: %.6g +- %.1e for %.6g\n", surface.what.c_str(), got.mean, got.error,
                    expected.y);
        const double closed_form = 1e-4 * expected.y;  // strip_irradiance's promise from 30 widths on
        CHECK(std::fabs(got.mean - expected.y) <= 4 * got.error + closed_form);  // once in 15000
        CHECK(got.error < 3e-3 * got.mean);  // or the check above says nothing
    }
}

TEST_CASE("habitat: within a width of a strip a surface has the irradiance of its whole area") {
    const Habitat habitat = rama(0.3);
    for (const Vector& place : {Vector(9000, 7990, 30), Vector(5010, 7960, -70), Vector(16040, 7980, 10)}) {
        const Vector normal = glm::normalize(Vector(0.2, 1, 0.1));
        // Pieces of 5 m and 10 m for heights of 10 m and more: good to 1e-4.
        const Vector expected = straight_light(habitat, place, 2200, 10, [&](const Vector& to_light) {
            return std::max(glm::dot(to_light, normal), 0.0);
        });
        const Estimate got = habitat_surface_irradiance(habitat, 2, place, normal, 0, 100000, 8);
        std::printf("near a strip: %.6g +- %.1e for %.6g\n", got.mean, got.error, expected.z);
        CHECK(std::fabs(got.mean - expected.z) <=
              4 * got.error + 2e-4 * expected.z);  // and the kink where the cosine turns 0
        CHECK(got.error < 3e-3 * got.mean);        // or the check above says nothing
    }
}

TEST_CASE("habitat: where air absorbs nothing the walls absorb all that the strips send out") {
    Habitat clear = rama(0.5);
    clear.air.mie_absorption = Vector(0.0);
    clear.air.rayleigh_scattering *= 3.0;  // so that air counts for as much as the walls
    for (const bool air : {true, false}) {
        const Habitat habitat = air ? clear : without_air(clear);
        const airlight::HabitatLights<double>& lights = habitat.lights;
        const double sent = 6 * pi<double> * lights.radiance.z * (lights.end - lights.begin) * lights.width;
        const double r = habitat.air.radius;
        const double area = 2 * pi<double> * r * (2 * lights.half_length + r);
        Random random(31, 0);
        Tally absorbed;
        constexpr int groups = 40;
        constexpr int places = 2500;
        for (int group = 0; group < groups; ++group) {
            for (int i = 0; i < places; ++i) {
                const auto [position, normal] = on_wall(habitat, random);
                const auto seed = static_cast<std::uint64_t>(group * places + i);
                absorbed.add(
                    (1 - habitat.albedo.z) * area *
                    habitat_surface_irradiance(habitat, 2, position, normal, every_order, 1, seed).mean);
            }
            absorbed.close_group(places);
        }
        const Estimate got = absorbed.estimate();
        std::printf("absorbed by the walls%s: %.5f +- %.5f of what was sent out\n", air ? "" : " without air",
                    got.mean / sent, got.error / sent);
        const double missing =
            4e-5 * sent;  // a strip's edges stand 16 cm behind the wall: some light gets by
        CHECK(std::fabs(got.mean - sent) <= 4 * got.error + missing);  // once in 15000
        CHECK(got.error < 0.01 * sent);                                // or the check above says nothing
    }
}

TEST_CASE("habitat: irradiance is what pixels in all directions add up to") {
    // The first is found by free flights, the second by meetings that are made for certain.
    const Habitat habitat = rama(0.4);
    const Vector position(3000, -2000, 7000);
    const Vector normal = glm::normalize(Vector(-0.5, 0.3, -1));
    for (const int orders : {1, 3, every_order}) {
        const Estimate whole = habitat_surface_irradiance(habitat, 1, position, normal, orders, 60000, 12);
        const Estimate straight = habitat_surface_irradiance(habitat, 1, position, normal, 0, 60000, 13);
        Random random(14, 0);
        Tally tally;
        constexpr int groups = 20;
        constexpr int directions = 150;
        for (int i = 0; i < groups * directions; ++i) {
            const Vector direction = from_surface(normal, random);
            const auto wall = airlight::habitat_wall(habitat.air, habitat.lights, position, direction);
            tally.add(pi<double> * habitat_pixel(habitat, position, direction, wall.distance, wall.normal,
                                                 habitat.albedo, Vector(0.0), orders, 8,
                                                 static_cast<std::uint64_t>(i))
                                       .y);
            if (i % directions == directions - 1) {
                tally.close_group(directions);
            }
        }
        const Estimate indirect = tally.estimate();
        std::printf("irradiance by %d orders: %.5g +- %.1e, of pixels %.5g +- %.1e\n", orders,
                    whole.mean - straight.mean, whole.error, indirect.mean, indirect.error);
        CHECK(apart(whole, Estimate{straight.mean + indirect.mean,
                                    std::hypot(straight.error, indirect.error)}) < 4);  // once in 15000
        CHECK(indirect.error < 0.02 * indirect.mean);  // or the check above says nothing
    }
}

TEST_CASE("habitat: a pixel is its surface past the air, and the air") {
    const Habitat habitat = rama(0.3);
    const Ray ray{"", Vector(100, -5000, 0), Vector(0, 1, 0)};
    const Vector normal(0, -1, 0);
    const Vector albedo(0.2, 0.4, 0.6);
    const Vector end = ray.eye + 9000.0 * ray.direction;
    const auto pixel = [&](const Vector& reflected, const Vector& emitted) {
        return habitat_pixel(habitat, ray.eye, ray.direction, 9000, normal, reflected, emitted, 1, 20000, 5);
    };
    const Vector black = pixel(Vector(0.0), Vector(0.0));
    const Vector lit = pixel(albedo, Vector(0.0));
    const Vector shining = pixel(Vector(0.0), Vector(1, 2, 3));
    const Vector passed = airlight::habitat_transmittance(habitat.air, ray.eye, end);
    for (int c = 0; c < 3; ++c) {
        const Estimate air = habitat_air_light(habitat, c, ray.eye, ray.direction, 9000, 1, 20000, 6);
        CHECK(std::fabs(black[c] - air.mean) < 6 * air.error);  // both have that error
        CHECK(shining[c] - black[c] == doctest::Approx((c + 1) * passed[c]).epsilon(1e-12));  // roundoffs
        const Estimate straight = habitat_surface_irradiance(habitat, c, end, normal, 0, 20000, 6);
        CHECK(std::fabs((lit[c] - black[c]) * pi<double> / (albedo[c] * passed[c]) - straight.mean) <
              6 * straight.error);  // both have that error
    }
}

TEST_CASE("habitat: the unit of length does not matter, and a seed gives the same numbers") {
    const Habitat metres = rama(0.3);
    Habitat other = metres;
    constexpr double k = 1024;  // a power of two: scaling rounds nothing
    other.air.radius *= k;
    other.air.density_rise /= k * k;
    other.air.rayleigh_scattering /= k;
    other.air.mie_scattering /= k;
    other.air.mie_absorption /= k;
    other.lights.half_length *= k;
    other.lights.begin *= k;
    other.lights.end *= k;
    other.lights.width *= k;
    const Vector eye(-3000, 4000, 5000);
    const Vector direction = glm::normalize(Vector(1, 0.3, -0.5));
    for (const int orders : {1, every_order}) {
        const Estimate a = habitat_air_light(metres, 2, eye, direction, 6000, orders, 2000, 3);
        const Estimate b = habitat_air_light(other, 2, k * eye, direction, 6000 * k, orders, 2000, 3);
        const Estimate c = habitat_air_light(metres, 2, eye, direction, 6000, orders, 2000, 4);
        CHECK(a.mean == b.mean);  // exact: the same walks
        CHECK(a.error == b.error);
        CHECK(a.mean != c.mean);
        CHECK(apart(a, c) < 4.5);  // 1e-5
    }
}

TEST_CASE("habitat: nothing is seen of air without air, without way and without light") {
    const Habitat habitat = rama(0.3);
    const Vector eye(0, 0, 0);
    const Vector direction(0, 0, 1);
    CHECK(habitat_air_light(without_air(habitat), 0, eye, direction, 8000, every_order, 100, 1).mean == 0);
    CHECK(habitat_air_light(habitat, 0, eye, direction, 0, every_order, 100, 1).mean == 0);
    CHECK(habitat_air_light(habitat, 0, eye, direction, 8000, 0, 100, 1).mean == 0);
    Habitat dark = habitat;
    dark.lights.radiance = Vector(0.0);
    CHECK(habitat_air_light(dark, 0, eye, direction, 8000, every_order, 100, 1).mean == 0);
    CHECK(habitat_surface_irradiance(dark, 0, eye, direction, every_order, 100, 1).mean == 0);
    // On the axis of black walls without air nothing but the strips is seen.
    const Habitat black = without_air(rama(0));
    CHECK(habitat_surface_irradiance(black, 0, eye, direction, every_order, 100, 1).mean ==
          habitat_surface_irradiance(black, 0, eye, direction, 0, 100, 1).mean);  // exact: the same looks
}
