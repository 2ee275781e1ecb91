// Rows around the horizon, in linear light: no specks along it, no thin lines across.

#include "gl_main.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <airlight/constants.hpp>

#include "studio.hpp"

namespace {

using image::LinearPicture;
using image::Shows;

constexpr int width = 32;
constexpr int height = 96;

/// [degrees] From afar the air is a thin rim: a scale height is half a degree from 100 km, a fifth from 400
/// km.
double pixel_size(double altitude) {
    return altitude < 50e3 ? 0.02 : 0.005;
}

/// Worst of one kind, relative to the light there.
struct Flaw {
    double size = 0;
    int x = 0;
    int y = 0;

    void take(double other, int at_x, int at_y) {
        if (!(other <= size)) {
            *this = {other, at_x, at_y};
        }
    }
};

/// Light too faint to see beside the brightest near it: none of it is looked at.
float faint(const LinearPicture& picture) {
    float most = 0;
    for (std::size_t i = 0; i < picture.shows.size(); ++i) {
        if (picture.shows[i] == Shows::sky) {
            most = std::max(
                {most, picture.radiance[3 * i], picture.radiance[3 * i + 1], picture.radiance[3 * i + 2]});
        }
    }
    return 1e-4f * most;
}

/// Each pixel against the median of the five along its row, all of the same kind.
Flaw specks(const LinearPicture& p, Shows kind) {
    Flaw worst;
    const float least = faint(p);
    for (int y = 0; y < height; ++y) {
        for (int x = 2; x + 2 < width; ++x) {
            bool same = true;
            for (int u = x - 2; u <= x + 2; ++u) {
                same = same && p.shows[p.index(u, y)] == kind;
            }
            for (int c = 0; same && c < 3; ++c) {
                std::array<float, 5> near{};
                for (int u = 0; u < 5; ++u) {
                    near[std::size_t(u)] = p.at(x - 2 + u, y, c);
                }
                std::sort(near.begin(), near.end());
                worst.take(double(std::abs(p.at(x, y, c) - near[2]) / (near[2] + least)), x, y);
            }
        }
    }
    return worst;
}

/// How far a pixel stands out above, or lies below, both of those two rows off.
Flaw lines(const LinearPicture& p, Shows kind) {
    Flaw worst;
    const float least = faint(p);
    for (int y = 2; y + 2 < height; ++y) {
        for (int x = 0; x < width; ++x) {
            bool same = true;
            for (int v = y - 2; v <= y + 2; ++v) {
                same = same && p.shows[p.index(x, v)] == kind;
            }
            for (int c = 0; same && c < 3; ++c) {
                const float here = p.at(x, y, c);
                const float above = p.at(x, y - 2, c);
                const float below = p.at(x, y + 2, c);
                const float out = std::max(here - std::max(above, below), std::min(above, below) - here);
                worst.take(double(out / (std::min(above, below) + least)), x, y);
            }
        }
    }
    return worst;
}

/// The row that touches the ground's edge, against the two behind it: a step in their direction of up to
/// three times theirs is a slope that steepens like a root, as the distance to the ground does.
Flaw edge_lines(const LinearPicture& p, Shows kind) {
    Flaw worst;
    const float least = faint(p);
    const int away = kind == Shows::sky ? -1 : 1;
    for (int y = 2; y + 2 < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool edge = p.shows[p.index(x, y)] == kind && p.shows[p.index(x, y + away)] == kind &&
                              p.shows[p.index(x, y + 2 * away)] == kind &&
                              p.shows[p.index(x, y - away)] != kind;
            for (int c = 0; edge && c < 3; ++c) {
                const float step = p.at(x, y, c) - p.at(x, y + away, c);
                const float before = p.at(x, y + away, c) - p.at(x, y + 2 * away, c);
                const float allowed_most = std::max(0.0f, 3 * before);
                const float allowed_least = std::min(0.0f, 3 * before);
                const float out = std::max({0.0f, step - allowed_most, allowed_least - step});
                worst.take(double(out / (p.at(x, y + away, c) + least)), x, y);
            }
        }
    }
    return worst;
}

/// The worst of every view is printed at the end.
struct Kind {
    const char* name;
    Flaw (*find)(const LinearPicture&, Shows);
    Shows where;
    double tolerated;
    double worst;
};

}  // namespace

TEST_CASE("around the horizon there is neither a speck nor a thin line") {
    deferred::Settings settings;
    settings.shadow_size = 64;
    // Ground that reflects nothing: every pixel is the air's own light.
    image::Studio studio("black", settings, width, height, 8);
    // Relative to the light there. Along the horizon the air changes by less than 1e-4 in five pixels.
    // Across, a peak as wide as a scale height, 20 pixels and more, falls by (2 / 20)^2 / 2 = 5e-3 in two
    // pixels.
    std::array<Kind, 6> kinds = {{
        {"speck in the sky", specks, Shows::sky, 1e-3, 0},
        {"speck before the ground", specks, Shows::ground, 1e-3, 0},
        {"line across the sky", lines, Shows::sky, 1e-2, 0},
        {"line before the ground", lines, Shows::ground, 1e-2, 0},
        {"line of sky along the edge", edge_lines, Shows::sky, 1e-2, 0},
        {"line of ground along the edge", edge_lines, Shows::ground, 1e-2, 0},
    }};
    for (const double altitude : {2.0, 1e3, 10e3, 100e3, 400e3}) {
        const double radius = 6371e3;
        const double dip = std::acos(radius / (radius + altitude)) * 180 / airlight::pi<double>;
        for (const double above : {40.0, 3.0, -1.0, -6.0}) {  // [degrees] the sun, above the horizon
            for (const double beside : {3.0, 150.0}) {        // [degrees] the sun, from the view's direction
                // Far from the landscape, over the ground sphere, looking away from it.
                deferred::Moment moment{
                    {"horizon", 1000e3, 0, altitude, false, 90, -dip, height * pixel_size(altitude)},
                    above - dip,
                    90 + beside};
                CAPTURE(altitude);
                CAPTURE(above);
                CAPTURE(beside);
                const LinearPicture dark = studio.draw(moment);
                for (Kind& kind : kinds) {
                    const Flaw flaw = kind.find(dark, kind.where);
                    CAPTURE(kind.name);
                    CAPTURE(flaw.x);
                    CAPTURE(flaw.y);
                    CHECK(flaw.size <= kind.tolerated);
                    kind.worst = std::max(kind.worst, flaw.size);
                }
            }
        }
    }
    for (const Kind& kind : kinds) {
        std::printf("%s: %.1e at worst, of %.0e\n", kind.name, kind.worst, kind.tolerated);
    }
}
