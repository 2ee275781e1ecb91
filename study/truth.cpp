#include "truth.hpp"

#include <numeric>
#include <vector>

#include "adaptive.hpp"

namespace study {
namespace {

/// Two columns' worth of rounding: what an optical depth may be off by before it is halved again. The rule of
/// 15 points is then better than that by orders of magnitude.
constexpr Real sure_of_depth = 1e-11L;
/// Share of the integral at which the radiance is good: again what two rules differ by.
constexpr Real sure_of_light = 1e-10L;
/// Beyond this optical depth nothing is left of the light, e^-100.
constexpr Real opaque = 100;

struct Vector {
    Real x, y, z;
};

Real dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector normalised(const airlight::vec3<double>& v) {
    const Vector w = {v.x, v.y, v.z};
    const Real length = std::sqrt(dot(w, w));
    return {w.x / length, w.y / length, w.z / length};
}

/// The air of a world: its densities, and the heights at which they have corners or change fast.
class Air {
  public:
    explicit Air(const World& world) : world_(world), air_(world.air) {
        const Real centre = air_.ozone_altitude;
        const Real width = air_.ozone_half_width;
        if (world.ozone == airlight::ozone_tent) {
            heights_ = {centre - width, centre, centre + width};
        }
        if (world.ozone == airlight::ozone_lorentzian) {
            heights_ = {centre - 2 * width, centre, centre + 2 * width};
        }
    }

    Real radius() const {
        return air_.ground_radius;
    }
    Real top() const {
        return radius() + static_cast<Real>(air_.top_altitude);
    }
    const std::vector<Real>& heights() const {
        return heights_;
    }

    /// Relative densities of molecules, aerosol and ozone at a distance from the centre.
    Three densities(Real distance) const {
        const double h = static_cast<double>(std::max(distance - radius(), Real(0)));
        const double molecules = std::exp(-h / air_.rayleigh_scale_height);
        const double off = (h - air_.ozone_altitude) / air_.ozone_half_width;
        double ozone = 0;
        if (world_.ozone == airlight::ozone_tent) {
            ozone = std::max(0.0, 1.0 - std::abs(off));
        }
        if (world_.ozone == airlight::ozone_lorentzian) {
            ozone = molecules / (1.0 + off * off);
        }
        return {molecules, std::exp(-h / air_.mie_scale_height), ozone};
    }

    /// Optical depths of a column, three channels.
    Three depth(const Three& column) const {
        Three out{};
        for (int k = 0; k < 3; ++k) {
            const Real mie = Real(air_.mie_scattering[k]) + Real(air_.mie_absorption[k]);
            out[static_cast<std::size_t>(k)] = Real(air_.rayleigh_scattering[k]) * column[0] +
                                               mie * column[1] + Real(air_.ozone_absorption[k]) * column[2];
        }
        return out;
    }

    /// Light scattered per length, three channels.
    Three source(const Three& densities, Real rayleigh_phase, Real mie_phase) const {
        Three out{};
        for (int k = 0; k < 3; ++k) {
            out[static_cast<std::size_t>(k)] =
                Real(air_.rayleigh_scattering[k]) * densities[0] * rayleigh_phase +
                Real(air_.mie_scattering[k]) * densities[1] * mie_phase;
        }
        return out;
    }

  private:
    const World& world_;
    const airlight::Atmosphere<double>& air_;
    std::vector<Real> heights_;
};

/// A line by its distance from the centre at t = 0 and its position there, counted from the closest approach.
struct Line {
    Real distance;
    Real along;

    Real at(Real t) const {
        return std::sqrt(distance * distance + t * (2 * along + t));
    }
    Real perigee_squared() const {
        return (distance - along) * (distance + along);
    }
    /// Half the chord in a sphere, 0 where the line misses it.
    Real half_chord(Real radius) const {
        const Real square = radius * radius - perigee_squared();
        return square > 0 ? std::sqrt(square) : 0;
    }
};

/// Keeps the cuts inside (a, b), in order, with both ends.
std::vector<Real> sorted_within(std::vector<Real> cuts, Real a, Real b) {
    cuts.erase(std::remove_if(cuts.begin(), cuts.end(), [&](Real t) { return !(t > a && t < b); }),
               cuts.end());
    cuts.push_back(a);
    cuts.push_back(b);
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

std::vector<Real> cuts_of(const Air& air, const Line& line) {
    std::vector<Real> cuts = {-line.along};
    for (const Real height : air.heights()) {
        const Real half = line.half_chord(air.radius() + height);
        if (half > 0) {
            cuts.push_back(-line.along - half);
            cuts.push_back(-line.along + half);
        }
    }
    return cuts;
}

/// Molecules, aerosol and ozone on a stretch of a line.
Three column(const Air& air, const Line& line, Real from, Real to) {
    Three sum{};
    if (!(to > from)) {
        return sum;
    }
    const std::vector<Real> cuts = sorted_within(cuts_of(air, line), from, to);
    const auto enough = [&](const Estimate& part) {
        return size(air.depth(part.doubt)) <=
               sure_of_depth * std::max(size(air.depth(part.value)), Real(1e-3L));
    };
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        sum = sum + integral([&](Real t) { return air.densities(line.at(t)); }, cuts[i], cuts[i + 1], enough);
    }
    return sum;
}

Real rayleigh_phase(Real cosine) {
    return 3 * (1 + cosine * cosine) / (16 * airlight::pi<Real>);
}
/// Cornette and Shanks.
Real mie_phase(Real cosine, Real g) {
    const Real square = 1 + g * g - 2 * g * cosine;
    return 3 * (1 - g * g) * (1 + cosine * cosine) /
           (8 * airlight::pi<Real> * (2 + g * g) * square * std::sqrt(square));
}

/// The light along one view ray.
class Light {
  public:
    explicit Light(const View& view)
        : world_(worlds()[view.world]),
          air_(world_),
          direction_(normalised(view.ray.direction)),
          to_sun_(normalised(view.ray.to_sun)) {
        const Vector up = normalised(view.ray.eye.up);
        const Real distance = air_.radius() + std::max(Real(view.ray.eye.altitude), Real(0));
        line_ = {distance, distance * dot(up, direction_)};
        sun_height_ = distance * dot(up, to_sun_);
        cos_theta_ = dot(direction_, to_sun_);
        rayleigh_phase_ = rayleigh_phase(cos_theta_);
        mie_phase_ = mie_phase(cos_theta_, Real(world_.air.mie_g));
        const Real half = line_.half_chord(air_.top());
        begin_ = std::max(-line_.along - half, Real(0));
        end_ = half > 0 ? std::min(-line_.along + half, Real(view.ray.distance)) : 0;
        const Real ground = line_.half_chord(air_.radius());
        if (ground > 0 && line_.along < 0) {
            end_ = std::min(end_, -line_.along - ground);
        }
    }

    Truth integrated() const {
        if (!(end_ > begin_)) {
            return {airlight::vec3<double>(0.0), 0.0};
        }
        const auto surer = [](const Part& a, const Part& b) {
            return size(a.light.doubt) < size(b.light.doubt);
        };
        std::priority_queue<Part, std::vector<Part>, decltype(surer)> parts(surer);
        const std::vector<Real> cuts = all_cuts();
        Three known{};
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const Part part = part_of(cuts[i], cuts[i + 1], known);
            known = known + column(air_, line_, cuts[i], cuts[i + 1]);
            parts.push(part);
        }
        Three sum{};
        Real doubt = 0;
        for (auto all = parts; !all.empty(); all.pop()) {
            sum = sum + all.top().light.value;
            doubt += size(all.top().light.doubt);
        }
        for (int halvings = 0; halvings < 4000 && doubt > sure_of_light * size(sum); ++halvings) {
            const Part worst = parts.top();
            parts.pop();
            const Real middle = (worst.from + worst.to) / 2;
            const Part first = part_of(worst.from, middle, worst.known);
            const Part second =
                part_of(middle, worst.to, worst.known + column(air_, line_, worst.from, middle));
            sum = sum + (first.light.value + second.light.value - worst.light.value);
            doubt += size(first.light.doubt) + size(second.light.doubt) - size(worst.light.doubt);
            parts.push(first);
            parts.push(second);
        }
        return {airlight::vec3<double>(double(sum[0]), double(sum[1]), double(sum[2])),
                size(sum) > 0 ? double(doubt / size(sum)) : 0.0};
    }

  private:
    struct Part {
        Real from;
        Real to;
        Three known;  ///< the eye's column at `from`
        Estimate light;
    };

    Part part_of(Real from, Real to, const Three& known) const {
        const auto f = [&](Real t) { return at(t, known + column(air_, line_, from, t)); };
        return {from, to, known, gauss_kronrod(f, from, to)};
    }

    /// The light that one place adds per length, dimmed on its way from the sun and to the eye.
    Three at(Real t, const Three& to_eye) const {
        const Real distance = line_.at(t);
        const Line sun_line = {distance, sun_height_ + t * cos_theta_};
        if (sun_line.along < 0 && sun_line.half_chord(air_.radius()) > 0) {
            return Three{};
        }
        const Three seen = air_.depth(to_eye);
        if (std::min({seen[0], seen[1], seen[2]}) > opaque) {
            return Three{};
        }
        const Real sun_end = sun_line.half_chord(air_.top()) - sun_line.along;
        const Three depth = seen + air_.depth(column(air_, sun_line, 0, sun_end));
        Three out = air_.source(air_.densities(distance), rayleigh_phase_, mie_phase_);
        for (std::size_t k = 0; k < 3; ++k) {
            out[k] *= std::exp(-depth[k]);
        }
        return out;
    }

    /// Where the view ray crosses the cylinder of sun rays that graze a sphere on the night side.
    void add_grazing(Real radius, std::vector<Real>& cuts) const {
        const Real a = 1 - cos_theta_ * cos_theta_;
        const Real b = line_.along - sun_height_ * cos_theta_;
        const Real c = line_.distance * line_.distance - sun_height_ * sun_height_ - radius * radius;
        if (a > 0 && b * b > a * c) {
            for (const Real sign : {-1, 1}) {
                const Real t = (-b + sign * std::sqrt(b * b - a * c)) / a;
                if (sun_height_ + t * cos_theta_ <= 0) {
                    cuts.push_back(t);
                }
            }
        }
    }

    std::vector<Real> all_cuts() const {
        std::vector<Real> cuts = cuts_of(air_, line_);
        add_grazing(air_.radius(), cuts);
        for (const Real height : air_.heights()) {
            add_grazing(air_.radius() + height, cuts);
        }
        return sorted_within(cuts, begin_, end_);
    }

    const World& world_;
    Air air_;
    Vector direction_;
    Vector to_sun_;
    Line line_{};
    Real sun_height_ = 0;
    Real cos_theta_ = 0;
    Real rayleigh_phase_ = 0;
    Real mie_phase_ = 0;
    Real begin_ = 0;
    Real end_ = 0;
};

}  // namespace

Truth true_radiance(const View& view) {
    return Light(view).integrated();
}

}  // namespace study
