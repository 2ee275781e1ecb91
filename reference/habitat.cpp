#include "habitat.hpp"

#include <airlight/habitat_indirect.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace reference {
namespace {

using airlight::LinearLight;
using airlight::pi;
using airlight::StripView;

static_assert(airlight::DefaultScene::mie_phase == airlight::phase_cornette_shanks,
              "directions are drawn from this phase function");

/// Share of a walk's first weight below which it is ended by chance.
constexpr double little_weight = 0.1;

/// Where a strip is cut, by shares of its solid angle: a strip that is one piece, and one whose ends, which
/// may lie where the air scatters most, are pieces of their own. The latter for the first light of a path:
/// most of a picture is that light.
template <std::size_t Cuts>
using Shares = std::array<double, Cuts>;
constexpr Shares<2> whole = {0, 1};
constexpr Shares<7> with_ends = {0, 0.05, 0.2, 0.5, 0.8, 0.95, 1};

using Strips = std::array<LinearLight<double>, 6>;

Strips strips_of(const Habitat& habitat) {
    Strips strips{};
    for (int i = 0; i < 6; ++i) {
        strips[static_cast<std::size_t>(i)] = airlight::habitat_strip(habitat.air, habitat.lights, i);
    }
    return strips;
}

/// Three even numbers.
using Draws = std::array<double, 3>;

/// A place of a light, and the solid angle that it stands for: 0 where nothing is seen.
struct Glimpse {
    Vector way{0, 0, 0};  ///< from where one looks
    double solid_angle = 0;
};

/// A place of a strip, a rectangle. Across, the angle at which it is seen is even, along, its sine is: their
/// product is the solid angle's element, d(angle) d(sine), to the last digit.
Glimpse glimpse_of_strip(const LinearLight<double>& light, const Vector& position, double across,
                         double along) {
    const Vector to_centre = light.centre - position;
    const Vector side = glm::cross(light.normal, light.along);
    const double height = -glm::dot(to_centre, light.normal);
    const double aside = glm::dot(to_centre, side);
    const double left = aside - 0.5 * light.width;
    const double right = aside + 0.5 * light.width;
    const double angle = std::atan2(height * light.width, height * height + left * right);
    const double at =
        std::clamp(height * std::tan(std::atan2(left, height) + across * angle), left, right) - aside;
    // The rectangle's line through that place, as a strip too narrow to have a width.
    const LinearLight<double> line{light.centre + at * side, light.along,        light.normal,
                                   light.half_length,        1e-9 * light.width, light.radiance};
    const StripView<double> view = airlight::strip_view(line, position);
    if (!(view.span > 0)) {
        return Glimpse{};
    }
    return Glimpse{airlight::strip_point(view, along), angle * view.span};
}

/// A habitat in one colour, as a walk needs it.
class Room {
  public:
    Room(const Habitat& habitat, const Strips& strips, int channel)
        : habitat_(habitat),
          strips_(strips),
          channel_(channel),
          rayleigh_(habitat.air.rayleigh_scattering[channel]),
          mie_(habitat.air.mie_scattering[channel]),
          extinction_(airlight::habitat_extinction(habitat.air)[channel]) {}

    int channel() const {
        return channel_;
    }
    double albedo() const {
        return habitat_.albedo[channel_];
    }
    /// [1/m] at the wall.
    double scattering() const {
        return rayleigh_ + mie_;
    }
    /// Share of the extinction that is scattering, everywhere the same: all densities are.
    double scattered_share() const {
        return scattering() / extinction_;
    }
    double density(const Vector& position) const {
        return airlight::habitat_density(habitat_.air, position);
    }
    double passed(const Vector& from, const Vector& to) const {
        return std::exp(-extinction_ * airlight::habitat_column(habitat_.air, from, to));
    }
    double phase(double cos_theta) const {
        return habitat_.isotropic ? airlight::isotropic_phase<double>()
                                  : (rayleigh_ * airlight::rayleigh_phase(cos_theta) +
                                     mie_ * airlight::mie_phase<double>(cos_theta, habitat_.air.mie_g)) /
                                        scattering();
    }
    Vector scattered(const Vector& direction, Random& random) const {
        if (habitat_.isotropic) {
            return turned(direction, 2 * random() - 1, random);
        }
        const bool by_molecules = random() * scattering() < rayleigh_;
        return turned(direction,
                      by_molecules ? airlight::sample_rayleigh_phase(random())
                                   : sample_cornette_shanks(habitat_.air.mie_g, random),
                      random);
    }

    /// Light straight from the strips, of which each is cut. One piece is picked by what its middle sends on:
    /// `towards_eye(direction)` is the share per solid angle.
    template <std::size_t Cuts, typename TowardsEye>
    double straight_light(const Shares<Cuts>& cuts, const Vector& position, const Draws& draws,
                          const TowardsEye& towards_eye) const {
        constexpr std::size_t pieces = Cuts - 1;
        constexpr std::size_t count = 6 * pieces;
        std::array<double, count> solid_angle{};
        std::array<double, count> sent{};
        double all_solid_angle = 0;
        double all_sent = 0;
        for (std::size_t strip = 0; strip < 6; ++strip) {
            const StripView<double> view = airlight::strip_view(strips_[strip], position);
            for (std::size_t piece = 0; view.solid_angle > 0 && piece < pieces; ++piece) {
                const std::size_t i = strip * pieces + piece;
                const Vector way = airlight::strip_point(view, 0.5 * (cuts[piece] + cuts[piece + 1]));
                const double length = glm::length(way);
                solid_angle[i] = view.solid_angle * (cuts[piece + 1] - cuts[piece]);
                sent[i] = length > 0 ? solid_angle[i] * std::max(towards_eye(way / length), 0.0) : 0.0;
                all_solid_angle += solid_angle[i];
                all_sent += sent[i];
            }
        }
        if (!(all_solid_angle > 0)) {
            return 0;
        }
        // What a piece's middle does not send others of it may: a part by solid angle alone.
        std::array<double, count> chance{};
        std::array<double, count> reached{};
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double by_angle = solid_angle[i] / all_solid_angle;
            chance[i] = all_sent > 0 ? 0.75 * sent[i] / all_sent + 0.25 * by_angle : by_angle;
            sum += chance[i];
            reached[i] = sum;
        }
        const auto found = std::upper_bound(reached.begin(), reached.end(), draws[0] * sum);
        const auto i = std::min(static_cast<std::size_t>(found - reached.begin()), count - 1);
        if (!(chance[i] > 0)) {
            return 0;
        }
        const LinearLight<double>& strip = strips_[i / pieces];
        const double share_of_strip = cuts[i % pieces + 1] - cuts[i % pieces];
        const Glimpse glimpse =
            glimpse_of_strip(strip, position, draws[1], cuts[i % pieces] + draws[2] * share_of_strip);
        const double length = glm::length(glimpse.way);
        if (!(glimpse.solid_angle > 0) || !(length > 0)) {
            return 0;
        }
        const double share = towards_eye(glimpse.way / length);
        return share > 0 ? share * habitat_.lights.radiance[channel_] *
                               (glimpse.solid_angle * share_of_strip * sum / chance[i]) *
                               passed(position, position + glimpse.way)
                         : 0.0;
    }

    airlight::HabitatWall<double> wall(const Vector& position, const Vector& direction) const {
        return airlight::habitat_wall(habitat_.air, habitat_.lights, position, direction);
    }

    /// Where a free flight ends, before the wall or at it: Woodcock's tracking, for the air is nowhere denser
    /// than at the wall.
    struct Flight {
        Vector position;
        bool on_wall;
    };
    Flight fly(const Vector& position, const Vector& direction, const airlight::HabitatWall<double>& wall,
               Random& random) const {
        double flown = 0;
        while (extinction_ > 0) {
            flown -= std::log1p(-random()) / extinction_;
            if (flown >= wall.distance) {
                break;
            }
            const Vector there = position + flown * direction;
            if (random() < density(there)) {
                return Flight{there, false};
            }
        }
        return Flight{wall.position, true};
    }

    /// A place on a way, drawn as the sum over the strips of one over the distance to each, and the length
    /// that it stands for.
    struct PlaceOnWay {
        Vector position;
        double length;
    };
    PlaceOnWay place_on_way(const Vector& from, const Vector& direction, double distance, double u) const {
        std::array<double, 6> peak{};
        std::array<double, 6> width{};
        std::array<double, 6> before{};
        std::array<double, 6> reached{};
        double sum = 0;
        for (std::size_t i = 0; i < 6; ++i) {
            peak[i] = airlight::nearest_to_strip(strips_[i], from, direction, distance);
            width[i] = airlight::peak_width(strips_[i], from + peak[i] * direction, distance);
            before[i] = std::asinh(peak[i] / width[i]);
            sum += before[i] + std::asinh((distance - peak[i]) / width[i]);
            reached[i] = sum;
        }
        const auto found = std::upper_bound(reached.begin(), reached.end(), u * sum);
        const auto picked = std::min<std::size_t>(static_cast<std::size_t>(found - reached.begin()), 5);
        const double into = u * sum - (picked > 0 ? reached[picked - 1] : 0.0);
        const double t =
            std::clamp(peak[picked] + width[picked] * std::sinh(into - before[picked]), 0.0, distance);
        double density = 0;
        for (std::size_t i = 0; i < 6; ++i) {
            density += 1 / std::hypot(width[i], t - peak[i]);
        }
        return PlaceOnWay{from + t * direction, sum / density};
    }

  private:
    const Habitat& habitat_;
    const Strips& strips_;
    int channel_;
    double rayleigh_;
    double mie_;
    double extinction_;
};

Draws draws_of(Random& random) {
    const double first = random();
    const double second = random();
    return Draws{first, second, random()};
}

/// What air at a place sends on, against `direction`, of light straight from the strips.
template <std::size_t Cuts>
double straight_light_in_air(const Room& room, const Shares<Cuts>& cuts, const Vector& position,
                             const Vector& direction, const Draws& draws) {
    return room.straight_light(cuts, position, draws, [&](const Vector& to_light) {
        return room.phase(std::clamp(glm::dot(direction, to_light), -1.0, 1.0));
    });
}

/// Radiance that comes to a place against `direction`, which is one share of `weight`, by paths of up to
/// `orders` meetings. Straight light that the air scatters is looked for on every way and not where free
/// flights end: near a strip that is seldom, and then much.
double walk_back(const Room& room, Vector position, Vector direction, double weight, int orders,
                 Random& random) {
    const double little = little_weight * weight;
    double light = 0;
    for (int order = 0; order < orders; ++order) {
        const airlight::HabitatWall<double> wall = room.wall(position, direction);
        if (room.scattering() > 0 && wall.distance > 0) {
            const Room::PlaceOnWay place = room.place_on_way(position, direction, wall.distance, random());
            light += weight * place.length * room.scattering() * room.density(place.position) *
                     room.passed(position, place.position) *
                     straight_light_in_air(room, whole, place.position, direction, draws_of(random));
        }
        const Room::Flight flight = room.fly(position, direction, wall, random);
        position = flight.position;
        weight *= flight.on_wall ? room.albedo() : room.scattered_share();
        // Little light is followed by chance only, and what goes on counts more.
        const double chance = std::min(weight / little, 1.0);
        if (!(random() < chance)) {
            break;
        }
        weight /= chance;
        if (flight.on_wall) {
            light +=
                weight * room.straight_light(whole, position, draws_of(random), [&](const Vector& to_light) {
                    return glm::dot(wall.normal, to_light) / pi<double>;
                });
            direction = from_surface(wall.normal, random);
        } else {
            direction = room.scattered(direction, random);
        }
    }
    return light;
}

/// Distances along a view ray, by cells that are fine where the ray passes by strips: mostly in proportion to
/// the strips' light that is scattered there and reaches the eye, for the rest to what any light would.
class Meeting {
  public:
    Meeting(const Habitat& habitat, const Strips& strips, const Vector& eye, const Vector& direction,
            double distance)
        : eye_(eye), direction_(direction) {
        edges_ = {0, distance};
        for (const LinearLight<double>& strip : strips) {
            const double peak = airlight::nearest_to_strip(strip, eye, direction, distance);
            const double width = airlight::peak_width(strip, eye + peak * direction, distance);
            const double before = std::asinh(peak / width);
            const double reach = before + std::asinh((distance - peak) / width);
            for (int i = 1; i < cells_each; ++i) {
                const double t = peak + width * std::sinh(reach * i / cells_each - before);
                edges_.push_back(std::clamp(t, 0.0, distance));
            }
        }
        std::sort(edges_.begin(), edges_.end());
        for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
            const double width = edges_[i + 1] - edges_[i];
            const Vector position = eye + 0.5 * (edges_[i] + edges_[i + 1]) * direction;
            const Vector passed = airlight::habitat_transmittance(habitat.air, eye, position);
            Vector source(0, 0, 0);
            for (const LinearLight<double>& strip : strips) {
                source += habitat.isotropic
                              ? airlight::isotropic_source(
                                    habitat.air, position,
                                    airlight::strip_mean_radiance(habitat.air, strip, position, 1))
                              : airlight::strip_source(habitat.air, strip, position, direction, 1);
            }
            lit_.push_back(width * passed * source);
            any_.push_back(width * passed * airlight::habitat_density(habitat.air, position));
        }
    }

    /// For one colour: the chances of the cells, added up. `straight` is the share that looks for light
    /// straight from the strips.
    std::vector<double> chances(int channel, double straight) const {
        double lit = 0;
        double any = 0;
        for (std::size_t i = 0; i < lit_.size(); ++i) {
            lit += lit_[i][channel];
            any += any_[i][channel];
        }
        std::vector<double> reached;
        double sum = 0;
        for (std::size_t i = 0; i < lit_.size(); ++i) {
            sum += (lit > 0 ? straight * lit_[i][channel] / lit : 0.0) +
                   (any > 0 ? (1 - straight) * any_[i][channel] / any : 0.0);
            reached.push_back(sum);
        }
        return reached;
    }

    /// A place, and what is scattered and gets through from there over the chance to draw it.
    std::pair<Vector, double> draw(const Room& room, const std::vector<double>& reached, double u) const {
        const double at = u * reached.back();
        const auto cell = std::min(
            static_cast<std::size_t>(std::upper_bound(reached.begin(), reached.end(), at) - reached.begin()),
            reached.size() - 1);
        const double below = cell > 0 ? reached[cell - 1] : 0.0;
        const double mass = reached[cell] - below;
        const double width = edges_[cell + 1] - edges_[cell];
        const double share = mass > 0 ? std::clamp((at - below) / mass, 0.0, 1.0) : 0.5;
        const Vector position = eye_ + (edges_[cell] + share * width) * direction_;
        const double scattered =
            room.scattering() * room.density(position) * room.passed(eye_, position) * width;
        return {position, mass > 0 ? scattered * reached.back() / mass : 0.0};
    }

  private:
    static constexpr int cells_each = 10;
    Vector eye_;
    Vector direction_;
    std::vector<double> edges_;
    std::vector<Vector> lit_;  ///< scattered straight light of each cell
    std::vector<Vector> any_;
};

/// Points that fill a cube of four sides evenly, wherever one stops: the lattice of the root of
/// x^5 = x + 1, moved by chance.
class EvenPoints {
  public:
    explicit EvenPoints(Random& random) {
        for (double& at : at_) {
            at = random();
        }
    }
    const std::array<double, 4>& next() {
        constexpr double root = 1.1673039782614187;
        double step = 1;
        for (double& at : at_) {
            step /= root;
            at += step;
            at -= std::floor(at);
        }
        return at_;
    }

  private:
    std::array<double, 4> at_{};
};

/// Groups whose spread is the standard error: no more than there are walks.
std::uint64_t groups_of(std::uint64_t walks) {
    return std::clamp<std::uint64_t>(walks / 2, 1, 40);
}

Estimate air_light(const Room& room, const Meeting& meeting, const Vector& direction, int orders,
                   std::uint64_t walks, std::uint64_t groups, std::uint64_t seed) {
    Tally tally;
    if (orders < 1 || !(room.scattering() > 0)) {
        return Estimate{};
    }
    const std::vector<double> reached = meeting.chances(room.channel(), orders > 1 ? 0.5 : 0.9);
    if (!(reached.back() > 0)) {
        return Estimate{};
    }
    const std::uint64_t each = std::max<std::uint64_t>(walks / groups, 1);
    for (std::uint64_t group = 0; group < groups; ++group) {
        Random random(seed, group);
        EvenPoints points(random);
        for (std::uint64_t i = 0; i < each; ++i) {
            const std::array<double, 4>& u = points.next();
            const auto [position, weight] = meeting.draw(room, reached, u[0]);
            tally.add(weight *
                      straight_light_in_air(room, with_ends, position, direction, Draws{u[1], u[2], u[3]}));
            if (orders > 1) {
                tally.add(
                    walk_back(room, position, room.scattered(direction, random), weight, orders - 1, random));
            }
        }
        tally.close_group(each);
    }
    return tally.estimate();
}

Estimate surface_irradiance(const Room& room, const Vector& position, const Vector& normal, int bounces,
                            std::uint64_t walks, std::uint64_t groups, std::uint64_t seed) {
    Tally tally;
    const std::uint64_t each = std::max<std::uint64_t>(walks / groups, 1);
    for (std::uint64_t group = 0; group < groups; ++group) {
        Random random(seed, group);
        EvenPoints points(random);
        for (std::uint64_t i = 0; i < each; ++i) {
            const std::array<double, 4>& u = points.next();
            tally.add(
                room.straight_light(with_ends, position, Draws{u[0], u[1], u[2]},
                                    [&](const Vector& to_light) { return glm::dot(normal, to_light); }));
            if (bounces > 0) {
                tally.add(
                    walk_back(room, position, from_surface(normal, random), pi<double>, bounces, random));
            }
        }
        tally.close_group(each);
    }
    return tally.estimate();
}

}  // namespace

Estimate habitat_air_light(const Habitat& habitat, int channel, const Vector& eye, const Vector& direction,
                           double distance, int orders, std::uint64_t walks, std::uint64_t seed) {
    if (!(distance > 0)) {
        return Estimate{};
    }
    const Strips strips = strips_of(habitat);
    return air_light(Room(habitat, strips, channel), Meeting(habitat, strips, eye, direction, distance),
                     direction, orders, walks, groups_of(walks), seed);
}

Estimate habitat_surface_irradiance(const Habitat& habitat, int channel, const Vector& position,
                                    const Vector& normal, int bounces, std::uint64_t walks,
                                    std::uint64_t seed) {
    const Strips strips = strips_of(habitat);
    return surface_irradiance(Room(habitat, strips, channel), position, normal, bounces, walks,
                              groups_of(walks), seed);
}

Vector habitat_pixel(const Habitat& habitat, const Vector& eye, const Vector& direction, double distance,
                     const Vector& normal, const Vector& albedo, const Vector& emission, int orders,
                     std::uint64_t walks, std::uint64_t seed) {
    const Strips strips = strips_of(habitat);
    const Vector position = eye + distance * direction;
    const Meeting meeting(habitat, strips, eye, direction, distance);
    Vector out(0, 0, 0);
    for (int channel = 0; channel < 3; ++channel) {
        const Room room(habitat, strips, channel);
        // One group: nobody asks for the error. The three colours are off the same way: less colour in noise.
        if (distance > 0) {
            out[channel] += air_light(room, meeting, direction, orders, walks, 1, seed).mean;
        }
        const double irradiance =
            orders > 0 && albedo[channel] > 0
                ? surface_irradiance(room, position, normal, orders - 1, walks, 1, seed).mean
                : 0.0;
        out[channel] +=
            room.passed(eye, position) * (emission[channel] + albedo[channel] / pi<double> * irradiance);
    }
    return out;
}

}  // namespace reference
