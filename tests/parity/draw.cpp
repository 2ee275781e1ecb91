#include "draw.hpp"

#include <airlight/atmospheres.hpp>
#include <airlight/constants.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace parity {
namespace {

// splitmix64, the seeding generator of the xoshiro family: one multiply-xor chain per output.
std::uint64_t mixed_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

double unit(std::uint64_t bits) {
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

constexpr std::array<int, 48> primes = {2,   3,   5,   7,   11,  13,  17,  19,  23,  29,  31,  37,
                                        41,  43,  47,  53,  59,  61,  67,  71,  73,  79,  83,  89,
                                        97,  101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151,
                                        157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223};

}  // namespace

Draw::Draw(std::uint64_t seed, std::size_t index, std::size_t count, bool fog, bool planet_shadow)
    : mode_(index < count / 8 ? Mode::every_edge : (index < count / 4 ? Mode::random_edges : Mode::mixed)),
      state_(mixed_bits(seed ^ mixed_bits(index))),
      seed_(seed),
      index_(index),
      remaining_(index),
      fog_(fog),
      planet_shadow_(planet_shadow) {}

std::uint64_t Draw::random() {
    state_ = mixed_bits(state_);
    return state_;
}

double Draw::next() {
    // Richtmyer's sequence: multiples of square roots of primes, shifted by the seed.
    const std::size_t d = dimension_++;
    const double shift = unit(mixed_bits(seed_ + d));
    const double x = shift + static_cast<double>(index_) * std::sqrt(primes[d % primes.size()]);
    return x - std::floor(x);
}

bool Draw::edge(std::size_t n, std::size_t& which) {
    if (mode_ == Mode::every_edge) {
        which = remaining_ % n;
        remaining_ = remaining_ >= n ? remaining_ / n : static_cast<std::size_t>(random() % 1024);
        return true;
    }
    which = static_cast<std::size_t>(random() % n);
    return mode_ == Mode::random_edges || random() % 8 == 0;
}

float Draw::number(float low, float high, std::initializer_list<float> edges) {
    const double u = next();
    std::size_t which = 0;
    if (edge(edges.size() + 2, which)) {
        return which == 0 ? low : (which == 1 ? high : *(edges.begin() + (which - 2)));
    }
    const double span = static_cast<double>(high) - static_cast<double>(low);
    return std::clamp(static_cast<float>(static_cast<double>(low) + u * span), low, high);
}

float Draw::magnitude(float low, float high, std::initializer_list<float> edges) {
    const double u = next();
    std::size_t which = 0;
    if (edge(edges.size() + 2, which)) {
        return which == 0 ? low : (which == 1 ? high : *(edges.begin() + (which - 2)));
    }
    const double ratio = static_cast<double>(high) / static_cast<double>(low);
    return std::clamp(static_cast<float>(static_cast<double>(low) * std::pow(ratio, u)), low, high);
}

int Draw::one_of(std::initializer_list<int> values) {
    const double u = next();
    const auto i = static_cast<std::size_t>(u * static_cast<double>(values.size()));
    return *(values.begin() + std::min(i, values.size() - 1));
}

float Draw::cosine() {
    const double u = next();
    std::size_t which = 0;
    constexpr std::array<float, 7> edges = {-1.0F,          0.0F, 1.0F, -0x1p-20F, 0x1p-20F, -1.0F + 0x1p-24F,
                                            1.0F - 0x1p-24F};
    if (edge(edges.size(), which)) {
        return edges[which];
    }
    switch (random() % 4) {
        case 0: {  // close to the horizon
            const double size = std::pow(10.0, -6 * std::abs(2 * u - 1));
            return static_cast<float>(u < 0.5 ? -size : size);
        }
        case 1: {  // close to a pole
            const double size = 1 - std::pow(10.0, -7 * std::abs(2 * u - 1));
            return static_cast<float>(u < 0.5 ? -size : size);
        }
        default:
            return static_cast<float>(2 * u - 1);
    }
}

float Draw::grazing_cosine(float radius, float altitude) {
    const double u = next();
    const float any = cosine();
    if (!(altitude > 0) || random() % 2 == 0) {
        return any;
    }
    const double sine =
        static_cast<double>(radius) / (static_cast<double>(radius) + static_cast<double>(altitude));
    const double touching = std::sqrt((1 - sine) * (1 + sine));
    const double off = std::pow(10.0, -7 * std::abs(2 * u - 1)) * (u < 0.5 ? -1 : 1);
    return static_cast<float>(std::clamp(-touching * (1 + off), -1.0, 1.0));
}

airlight::vec3<float> Draw::direction() {
    const double u = next();
    const double v = next();
    std::size_t which = 0;
    if (edge(6, which)) {
        airlight::vec3<float> axis(0.0F, 0.0F, 0.0F);
        axis[static_cast<glm::length_t>(which / 2)] = which % 2 == 0 ? 1.0F : -1.0F;
        return axis;
    }
    const double z = 2 * u - 1;
    const double radius = std::sqrt(std::max(0.0, 1 - z * z));
    const double angle = 2 * airlight::pi<double> * v;
    return airlight::vec3<float>(static_cast<float>(radius * std::cos(angle)),
                                 static_cast<float>(radius * std::sin(angle)), static_cast<float>(z));
}

airlight::vec3<float> Draw::direction_at(const airlight::vec3<float>& up, double mu) {
    const airlight::vec3<double> axis(static_cast<double>(up.x), static_cast<double>(up.y),
                                      static_cast<double>(up.z));
    const double angle = 2 * airlight::pi<double> * next();
    const airlight::vec3<double> helper =
        std::abs(axis.x) < 0.6 ? airlight::vec3<double>(1, 0, 0) : airlight::vec3<double>(0, 1, 0);
    const airlight::vec3<double> east = glm::normalize(glm::cross(helper, axis));
    const airlight::vec3<double> north = glm::cross(axis, east);
    const double sine = std::sqrt(std::max(0.0, (1 - mu) * (1 + mu)));
    const airlight::vec3<double> d = axis * mu + (east * std::cos(angle) + north * std::sin(angle)) * sine;
    return airlight::vec3<float>(static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z));
}

airlight::vec3<float> Draw::spectrum(float low, float high) {
    const float x = magnitude(low, high, {0.0F});
    switch (random() % 4) {
        case 0:
            return airlight::vec3<float>(x, x, x);
        case 1:
            return airlight::vec3<float>(0.0F, x, 0.0F);
        default:
            return airlight::vec3<float>(x, magnitude(low, high, {0.0F}), magnitude(low, high, {0.0F}));
    }
}

airlight::DiffuseLight<float> Draw::diffuse_light() {
    const airlight::vec3<float> mean = spectrum(1e-9F, 1e2F);
    const auto moment = [&] { return mean * number(-1.0F, 1.0F, {0.0F}); };
    const auto vertical = moment();
    const auto slanted = moment();
    const auto across = moment();
    const auto lobe = [&] { return mean * number(0.0F, 4.0F, {1.0F}); };
    const auto up = lobe();
    const auto down = lobe();
    const auto sunward = lobe();
    const auto away = lobe();
    const auto aside = lobe();
    return airlight::DiffuseLight<float>{mean, vertical, slanted, across, up, down, sunward, away, aside};
}

airlight::SkyIrradiance<float> Draw::sky_irradiance() {
    const airlight::vec3<float> down = spectrum(1e-9F, 1.0F);
    const airlight::vec3<float> up = spectrum(1e-9F, 1.0F);
    return airlight::SkyIrradiance<float>{down, up, (down + up) * number(-1.0F, 1.0F, {0.0F})};
}

float Draw::aerosol_parameter() {
    return fog_ ? number(5.0F, 50.0F, {0.0F, 4.0F, 60.0F}) : number(-0.95F, 0.95F, {0.0F, 0.76F, 0.8F});
}

airlight::Atmosphere<float> Draw::atmosphere() {
    airlight::Atmosphere<float> a = airlight::earth<float>();
    switch (one_of({0, 0, 0, 1, 2, 3, 4})) {
        case 1:
            a = airlight::cs562_earth<float>();
            break;
        case 2:
            a = airlight::elek_earth<float>();
            break;
        case 3:
            a = airlight::leenman_earth<float>();
            break;
        case 4:
            a = airlight::mars<float>();
            break;
        default:
            break;
    }
    const airlight::vec3<float> none(0.0F, 0.0F, 0.0F);
    switch (one_of({0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8})) {
        case 1:  // ten times the molecules
            a.rayleigh_scattering *= 10.0F;
            break;
        case 2:  // no air at all
            a.rayleigh_scattering = none;
            a.mie_scattering = none;
            a.mie_absorption = none;
            a.ozone_absorption = none;
            break;
        case 3:  // layers of no thickness
            a.mie_scale_height = 0.0F;
            a.ozone_half_width = 0.0F;
            break;
        case 4:  // no molecules
            a.rayleigh_scattering = none;
            a.rayleigh_scale_height = 0.0F;
            break;
        case 5:  // kilometres
            a = airlight::rescaled(a, 0.001F);
            break;
        case 6:  // a small world
            a.ground_radius = 60e3F;
            break;
        case 7:  // another planet
            a.ground_radius *= magnitude(0.1F, 10.0F);
            a.rayleigh_scale_height *= magnitude(0.5F, 2.0F);
            a.mie_scale_height *= magnitude(0.5F, 4.0F);
            a.ozone_altitude *= magnitude(0.5F, 2.0F, {0.0F});
            break;
        case 8:  // haze
            a.mie_scattering *= 10.0F;
            break;
        default:
            break;
    }
    a.mie_g = random() % 4 == 0 || fog_ ? aerosol_parameter() : a.mie_g;
    return a;
}

float Draw::altitude_in_air(const airlight::Atmosphere<float>& atmosphere) {
    const float top = atmosphere.top_altitude;
    return magnitude(top * 1e-6F, top, {0.0F, atmosphere.ozone_altitude, -top * 0.01F});
}

float Draw::altitude(const airlight::Atmosphere<float>& atmosphere) {
    const float top = atmosphere.top_altitude;
    const float radius = atmosphere.ground_radius;
    return magnitude(top * 1e-6F, radius * 4,
                     {0.0F, top, std::nextafter(top, 2 * top), -top * 1e-6F, -top, -radius});
}

airlight::Viewpoint<float> Draw::viewpoint(const airlight::Atmosphere<float>& atmosphere) {
    const float top = atmosphere.top_altitude;
    const float radius = atmosphere.ground_radius;
    const float far = radius * 157.0F;  // 1e9 m for an Earth
    const float h = magnitude(top * 1e-6F, far,
                              {0.0F, top * 1e-5F, top * 0.1F, top, std::nextafter(top, 2 * top), radius,
                               -top * 1e-4F, -radius * 0.5F, -radius});
    return airlight::Viewpoint<float>{h, direction()};
}

airlight::vec3<float> Draw::view(const airlight::Atmosphere<float>& atmosphere,
                                 const airlight::Viewpoint<float>& eye) {
    const double u = next();
    std::size_t which = 0;
    if (edge(4, which)) {
        if (which < 2) {
            return which == 0 ? eye.up : -eye.up;
        }
        return direction_at(eye.up, which == 2 ? 0.0 : -1e-3);
    }
    const double height = std::max(0.0, static_cast<double>(eye.altitude));
    if (random() % 2 == 0 || height <= 0) {
        return direction_at(eye.up, static_cast<double>(cosine()));
    }
    // Past the limb: the closest approach anywhere from the inside of the planet to twice the air's top.
    const double radius = static_cast<double>(atmosphere.ground_radius);
    const double top = static_cast<double>(atmosphere.top_altitude);
    const double reach = random() % 2 == 0 ? 2 * top : radius;
    const double sine = std::min(1.0, (radius + reach * (2 * u - 1)) / (radius + height));
    return direction_at(eye.up, -std::sqrt(std::max(0.0, (1 - sine) * (1 + sine))));
}

float Draw::distance(const airlight::Atmosphere<float>& atmosphere) {
    return magnitude(
        atmosphere.top_altitude * 1e-6F, atmosphere.ground_radius * 200,
        {0.0F, atmosphere.top_altitude, airlight::no_surface<float>(), airlight::no_surface<float>()});
}

airlight::Column<float> Draw::column() {
    const auto one = [this] { return magnitude(1.0F, 1e6F, {0.0F}); };
    return airlight::Column<float>{one(), one(), one()};  // in this order: braces go from left to right
}

}  // namespace parity
