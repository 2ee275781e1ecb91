#include "walk.hpp"

#include <airlight/phase.hpp>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace reference {
namespace {

using airlight::pi;

/// Share of a walk's first weight below which it is ended by chance.
constexpr double little_weight = 0.1;

/// Sine of the sun's height below which walks are guided: 2 degrees down.
constexpr double sun_is_down = -0.035;

std::uint64_t walks_in_group(std::uint64_t walks, const Effort& effort) {
    return std::max<std::uint64_t>(walks / static_cast<std::uint64_t>(effort.groups), 1);
}

Vector unit(const Vector& v) {
    return v / glm::length(v);
}

/// Distances along a view ray, by cells: mostly in proportion to the sunlight that is scattered there and
/// reaches the eye, for the rest to what any light would.
class Meeting {
  public:
    Meeting(const Air& air, const Light& light, const ViewRay& ray, int cells)
        : air_(air), ray_(ray), cells_(cells) {
        std::vector<double> mass;
        std::vector<double> sunlit;
        for (int i = 0; i < cells_; ++i) {
            const double t = (i + 0.5) * width();
            mass.push_back(density(t));
            sunlit.push_back(light.sun > 0 ? air.to_space(ray.begin + t * ray.direction, light.to_sun) : 0.0);
        }
        // The shadow's edge may lie anywhere in a cell: a cell counts as bright as its brightest neighbour.
        const std::vector<double> middle = sunlit;
        for (std::size_t i = 0; i < sunlit.size(); ++i) {
            sunlit[i] =
                std::max({middle[i > 0 ? i - 1 : 0], middle[i], middle[std::min(i + 1, middle.size() - 1)]});
        }
        double any = 0;
        double lit = 0;
        for (std::size_t i = 0; i < mass.size(); ++i) {
            any += mass[i];
            lit += mass[i] * sunlit[i];
        }
        if (!(any > 0)) {
            return;
        }
        for (std::size_t i = 0; i < mass.size(); ++i) {
            mass[i] *= (lit > 0 ? for_sunlight * sunlit[i] / lit : 0.0) + (1 - for_sunlight) / any;
        }
        // A floor, so that no place is left out where the middle of a cell is dark.
        const double floor = 1e-3 / cells_;
        double sum = 0;
        for (const double m : mass) {
            sum += m + floor;
            reached_.push_back(sum);
        }
    }
    bool possible() const {
        return !reached_.empty();
    }
    /// A distance, and what is scattered and gets through from there over the chance to draw it.
    std::pair<double, double> draw(double u) const {
        const double at = u * reached_.back();
        const auto cell = std::min<std::ptrdiff_t>(
            std::upper_bound(reached_.begin(), reached_.end(), at) - reached_.begin(), cells_ - 1);
        const double below = cell > 0 ? reached_[static_cast<std::size_t>(cell) - 1] : 0.0;
        const double mass = reached_[static_cast<std::size_t>(cell)] - below;
        const double t = (static_cast<double>(cell) + std::clamp((at - below) / mass, 0.0, 1.0)) * width();
        return {t, density(t) * width() * reached_.back() / mass};
    }

  private:
    static constexpr double for_sunlight = 0.5;  // share of the walks that look for it
    double width() const {
        return ray_.extent / cells_;
    }
    double density(double t) const {
        const Vector position = ray_.begin + t * ray_.direction;
        const double altitude = glm::length(position) - air_.ground_radius();
        return air_.at(altitude).scattering() * air_.along(ray_.begin, ray_.direction, t);
    }
    const Air& air_;
    ViewRay ray_;
    int cells_;
    std::vector<double> reached_;
};

/// A step of a walk: where it comes to, by what direction, and by how much what is found there counts.
struct Step {
    Vector position;
    Vector direction;
    End end;
    double weight;
};

/// As the air would have it: by its phase functions, until something is met.
Step free_step(const Air& air, const Coefficients& here, const Vector& position, const Vector& direction,
               bool on_ground, Random& random) {
    const Vector towards =
        on_ground ? from_surface(unit(position), random) : air.scattered(here, direction, random);
    const Flight flight = air.fly(position, towards, random);
    double weight = 1;
    if (flight.end == End::met_air) {
        const Coefficients there = air.at(glm::length(flight.position) - air.ground_radius());
        weight = there.scattering() / there.extinction();
    }
    return Step{flight.position, towards, flight.end, weight};
}

/// Lobes of Henyey and Greenstein about the glow.
constexpr double wide_lobe = 0.5;
constexpr double narrow_lobe = 0.9;

/// Towards the glow: in twilight light comes from thin air far off, which a free step hardly ever finds. Two
/// thirds of the directions lean to where the sun went down, and the air on the way is met for certain, most
/// often where the sun shines.
Step guided_step(const Air& air, const Light& light, const Coefficients& here, const Vector& position,
                 const Vector& direction, bool on_ground, Random& random) {
    const Vector up = unit(position);
    const Vector glow = unit(light.to_sun - up * glm::dot(up, light.to_sun) + 0.06 * up);
    const double kind = random();
    Vector towards;
    if (kind < 1.0 / 3) {
        towards = on_ground ? from_surface(up, random) : air.scattered(here, direction, random);
    } else {
        const double lobe = kind < 2.0 / 3 ? wide_lobe : narrow_lobe;
        towards = turned(glow, airlight::sample_henyey_greenstein_phase(random(), lobe), random);
    }
    const double wanted = on_ground ? std::max(glm::dot(up, towards), 0.0) / pi<double>
                                    : air.phase(here, glm::dot(direction, towards));
    const double to_glow = glm::dot(glow, towards);
    const double chance = (wanted + airlight::henyey_greenstein_phase(to_glow, wide_lobe) +
                           airlight::henyey_greenstein_phase(to_glow, narrow_lobe)) /
                          3;
    double weight = wanted / chance;
    const ViewRay ray = view_ray(air, position, towards);
    const double chance_of_air = ray.to_ground ? 0.9 : 1.0;
    const Step nowhere{position, towards, End::escaped, 0};
    if (!(weight > 0) || !(ray.extent > 0)) {
        return nowhere;
    }
    if (random() >= chance_of_air) {
        weight *= air.along(ray.begin, towards, ray.extent) / (1 - chance_of_air);
        const Vector ground = unit(ray.begin + ray.extent * towards) * air.ground_radius();
        return Step{ground, towards, End::ground, weight};
    }
    const Meeting meeting(air, light, ray, 24);
    if (!meeting.possible()) {
        return nowhere;
    }
    const auto [t, share] = meeting.draw(random());
    return Step{ray.begin + t * towards, towards, End::met_air, weight * share / chance_of_air};
}

/// Whether a walk from there is guided. A guided step never leaves the air, so a lit sky would be missed.
bool is_twilight(const Light& light, const Vector& position) {
    return light.sun > 0 && light.sky <= 0 && glm::dot(unit(position), light.to_sun) < sun_is_down;
}

/// What a guided walk counts for: it takes twenty times as long as a free one and is worth more than that.
constexpr int guided_walk = 10;

/// Steps of a walk that are guided where the sun is down.
constexpr int guided_steps = 5;

/// One walk backwards from a meeting with the air at `position`, light going to the eye against
/// `direction`. `add(order, light)` is told of every share of light.
template <typename Add>
void walk_back(const Air& air, const Light& light, Vector position, Vector direction, double weight,
               int orders, Random& random, const Add& add) {
    bool on_ground = false;
    const bool twilight = is_twilight(light, position);
    const double little = little_weight * weight;
    for (int order = 0; order < orders; ++order) {
        const Vector to_sun =
            light.sun_radius > 0
                ? turned(light.to_sun, 1 - random() * (1 - std::cos(light.sun_radius)), random)
                : light.to_sun;
        const double radius = glm::length(position);
        const Vector up = position / radius;
        const Coefficients here = air.at(radius - air.ground_radius());
        if (light.sun > 0) {
            const double towards_eye = on_ground ? std::max(glm::dot(up, to_sun), 0.0) / pi<double>
                                                 : air.phase(here, glm::dot(direction, to_sun));
            if (towards_eye > 0) {
                add(order, weight * towards_eye * light.sun * air.to_space(position, to_sun));
            }
        }
        const bool guided = twilight && order < guided_steps;
        const Step step = guided ? guided_step(air, light, here, position, direction, on_ground, random)
                                 : free_step(air, here, position, direction, on_ground, random);
        weight *= step.weight;
        if (step.end == End::escaped) {
            add(order, weight * light.sky);
            return;
        }
        position = step.position;
        direction = step.direction;
        on_ground = step.end == End::ground;
        if (on_ground) {
            weight *= air.albedo();
        }
        // Little light is followed by chance only, and what goes on counts more; but where a walk is guided
        // it may be about to meet the glow.
        const double chance = guided && weight > 0 ? 1.0 : std::min(weight / little, 1.0);
        if (!(random() < chance)) {
            return;
        }
        weight /= chance;
    }
}

}  // namespace

ViewRay view_ray(const Air& air, const Vector& eye, const Vector& direction) {
    const double rise = glm::dot(eye, direction);
    const double square = glm::dot(eye, eye);
    const double over = rise * rise - (square - air.top_radius() * air.top_radius());
    if (over <= 0) {
        return ViewRay{eye, direction, 0, false};
    }
    const double begin = std::max(-rise - std::sqrt(over), 0.0);
    double end = -rise + std::sqrt(over);
    const double under = rise * rise - (square - air.ground_radius() * air.ground_radius());
    const bool to_ground = rise < 0 && under > 0;
    if (to_ground) {
        end = std::max(-rise - std::sqrt(under), 0.0);
    }
    return ViewRay{eye + begin * direction, direction, std::max(end - begin, 0.0), to_ground};
}

Radiance traced(const Air& air, const Light& light, const ViewRay& ray, const Effort& effort) {
    Radiance out;
    if (!(ray.extent > 0)) {
        return out;
    }
    const Meeting first(air, light, ray, 1024);
    if (!first.possible()) {
        return out;
    }
    Tally total;
    std::array<Tally, kept_orders> orders;
    const std::uint64_t walks =
        effort.walks / (is_twilight(light, ray.begin) && effort.orders > 1 ? guided_walk : 1);
    const std::uint64_t each = walks_in_group(walks, effort);
    for (int group = 0; group < effort.groups; ++group) {
        Random random(effort.seed, static_cast<std::uint64_t>(group));
        for (std::uint64_t i = 0; i < each; ++i) {
            // One walk in each of `each` slices: the first meetings are spread evenly.
            const auto [t, weight] =
                first.draw((static_cast<double>(i) + random()) / static_cast<double>(each));
            walk_back(air, light, ray.begin + t * ray.direction, ray.direction, weight, effort.orders, random,
                      [&](int order, double amount) {
                          total.add(amount);
                          orders[static_cast<std::size_t>(std::min(order, kept_orders - 1))].add(amount);
                      });
        }
        total.close_group(each);
        for (Tally& tally : orders) {
            tally.close_group(each);
        }
    }
    out.total = total.estimate();
    for (std::size_t k = 0; k < orders.size(); ++k) {
        out.order[k] = orders[k].estimate();
    }
    return out;
}

Estimate sky_irradiance(const Air& air, const Light& light, const Effort& effort) {
    constexpr int directions = 100;  // of each group, evenly over the projected hemisphere
    const Vector place(0, 0, air.ground_radius());
    Tally tally;
    for (int group = 0; group < effort.groups; ++group) {
        Random random(effort.seed, static_cast<std::uint64_t>(group));
        for (int i = 0; i < directions; ++i) {
            const double square = (i + random()) / directions;  // of the sine to the vertical
            const double azimuth = 2 * pi<double> * random();
            const double sine = std::sqrt(square);
            const Vector direction(sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(1 - square));
            Effort own = effort;
            own.groups = 2;  // the spread over the directions is larger
            own.seed = effort.seed + static_cast<std::uint64_t>(group * directions + i);
            own.walks = effort.walks / static_cast<std::uint64_t>(effort.groups * directions);
            tally.add(pi<double> * traced(air, light, view_ray(air, place, direction), own).total.mean);
        }
        tally.close_group(directions);
    }
    return tally.estimate();
}

Estimate absorbed_by_ground(const Air& air, const Effort& effort) {
    Tally tally;
    const std::uint64_t each = walks_in_group(effort.walks, effort);
    const double share = air.top_radius() / air.ground_radius();
    for (int group = 0; group < effort.groups; ++group) {
        Random random(effort.seed, static_cast<std::uint64_t>(group));
        for (std::uint64_t i = 0; i < each; ++i) {
            // Evenly over the disc of the air, which is larger than the ground's.
            const double across = air.top_radius() * std::sqrt(random());
            const double angle = 2 * pi<double> * random();
            const double up = std::sqrt(air.top_radius() * air.top_radius() - across * across);
            Vector position(across * std::cos(angle), across * std::sin(angle), up);
            Vector direction(0, 0, -1);
            double weight = share * share;
            for (;;) {
                const Flight flight = air.fly(position, direction, random);
                if (flight.end == End::escaped) {
                    break;
                }
                position = flight.position;
                if (flight.end == End::ground) {
                    tally.add(weight * (1 - air.albedo()));
                    if (random() >= air.albedo()) {
                        break;
                    }
                    direction = from_surface(unit(position), random);
                    continue;
                }
                const Coefficients here = air.at(glm::length(position) - air.ground_radius());
                if (random() * here.extinction() >= here.scattering()) {
                    break;
                }
                direction = air.scattered(here, direction, random);
            }
        }
        tally.close_group(each);
    }
    return tally.estimate();
}

Estimate absorbed_by_ground_backwards(const Air& air, const Effort& effort) {
    Tally tally;
    const std::uint64_t each = walks_in_group(effort.walks, effort);
    Light light;
    light.to_sun = Vector(0, 0, 1);
    for (int group = 0; group < effort.groups; ++group) {
        Random random(effort.seed, static_cast<std::uint64_t>(group));
        for (std::uint64_t i = 0; i < each; ++i) {
            // Evenly over the sphere, four discs large; what arrives there, direct and from the sky, once.
            const Vector up = turned(Vector(0, 0, 1), 2 * random() - 1, random);
            const Vector position = up * air.ground_radius();
            const double weight = 4 * (1 - air.albedo());
            const double cosine = glm::dot(up, light.to_sun);
            if (cosine > 0) {
                tally.add(weight * cosine * air.to_space(position, light.to_sun));
            }
            const Vector direction = from_surface(up, random);
            const Flight flight = air.fly(position, direction, random);
            if (flight.end == End::met_air) {
                const Coefficients there = air.at(glm::length(flight.position) - air.ground_radius());
                walk_back(air, light, flight.position, direction,
                          weight * pi<double> * there.scattering() / there.extinction(), effort.orders,
                          random, [&](int, double amount) { tally.add(amount); });
            }
        }
        tally.close_group(each);
    }
    return tally.estimate();
}

}  // namespace reference
