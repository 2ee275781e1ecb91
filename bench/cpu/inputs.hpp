#pragma once

#include <airlight/airlight.hpp>
#include <cmath>
#include <random>

namespace cpu_bench {

/// The inputs of one call: a ray like those of a game, and numbers. Seeded, so that every run has the same.
template <typename T>
class Draw {
  public:
    /// Another ray: from the ground to 100 km up, one in eight from an orbit; any direction; sun from below
    /// the horizon to the zenith; half of them end on a surface.
    void next() {
        altitude = choose(8) ? between(2e5, 2e6) : decades(0, 5);
        up = unit_vector();
        direction = unit_vector();
        mu = airlight::dot_product(up, direction);
        mu_s = between(-0.1, 1);
        to_sun = with_cosine(mu_s);
        cos_theta = airlight::dot_product(direction, to_sun);
        distance = choose(2) ? decades(2, 5) : airlight::no_surface<T>();
    }

    T altitude = 0;                  ///< [m]
    airlight::vec3<T> up{0};         ///< unit vector
    airlight::vec3<T> direction{0};  ///< unit vector
    airlight::vec3<T> to_sun{0};     ///< unit vector
    T mu = 0;                        ///< of direction
    T mu_s = 0;                      ///< of to_sun
    T cos_theta = 0;                 ///< between direction and to_sun
    T distance = 0;                  ///< [m]

    T between(double low, double high) {
        return T(std::uniform_real_distribution<double>(low, high)(random_));
    }
    /// 10^low to 10^high, each decade as likely.
    T decades(double low, double high) {
        return T(std::pow(10.0, std::uniform_real_distribution<double>(low, high)(random_)));
    }
    /// True once in `n` calls.
    bool choose(int n) {
        return std::uniform_int_distribution<int>(1, n)(random_) == 1;
    }
    /// 0 to n - 1.
    int below(int n) {
        return std::uniform_int_distribution<int>(0, n - 1)(random_);
    }
    airlight::vec3<T> color(double low, double high) {
        return {between(low, high), between(low, high), between(low, high)};
    }
    airlight::vec3<T> unit_vector() {
        std::normal_distribution<double> normal;
        return glm::normalize(airlight::vec3<T>(T(normal(random_)), T(normal(random_)), T(normal(random_))));
    }

    /// [m] in a habitat.
    airlight::vec3<T> place() {
        const T x = between(-24e3, 24e3);
        const T y = between(-5600, 5600);
        return {x, y, between(-5600, 5600)};
    }

  private:
    /// A unit vector at a cosine to `up`.
    airlight::vec3<T> with_cosine(T cosine) {
        const airlight::vec3<T> across = glm::normalize(glm::cross(up, unit_vector()));
        return cosine * up + std::sqrt(1 - cosine * cosine) * across;
    }

    std::mt19937 random_;
};

/// What a scene is lit through: an Earth, whose aerosol is droplets of 10 micrometres where the scene has
/// fog.
template <typename T, typename Scene>
airlight::Atmosphere<T> atmosphere_of() {
    airlight::Atmosphere<T> out = airlight::earth<T>();
    if constexpr (Scene::mie_phase == airlight::phase_fog) {
        out.mie_g = 10;
    }
    return out;
}

/// A habitat with that aerosol, in metres.
template <typename T>
airlight::HabitatAir<T> habitat_of(const airlight::Atmosphere<T>& atmosphere) {
    airlight::HabitatAir<T> air = airlight::rama_air<T>();
    air.mie_g = atmosphere.mie_g;
    return air;
}

/// One of its lights, on the wall.
template <typename T>
airlight::LinearLight<T> strip_of() {
    using vec3 = airlight::vec3<T>;
    return {vec3(T(10500), T(0), T(-8000)),
            vec3(T(1), T(0), T(0)),
            vec3(T(0), T(0), T(1)),
            T(5500),
            T(100),
            vec3(T(1))};
}

/// A lamp at its wall.
template <typename T>
airlight::PointLight<T> lamp_of() {
    using vec3 = airlight::vec3<T>;
    return {vec3(T(0), T(0), T(-7990)), vec3(T(1)), vec3(T(0), T(0), T(1)), T(0.9), T(0.5)};
}

}  // namespace cpu_bench
