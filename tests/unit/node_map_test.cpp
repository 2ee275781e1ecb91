#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <airlight/gauss.hpp>
#include <airlight/node_map.hpp>
#include <airlight/nodes_for.hpp>

#include "samplers.hpp"
#include "scenes.hpp"
#include "story.hpp"

using namespace airlight_test;
using namespace airlight;

namespace {

/// A piece of a ray: where its low end is, how far it climbs, how long it is.
struct Piece {
    double low_radius;
    double low_along;
    double rise;
    double length;
    double height;
    double pulled;
};

Piece random_piece(Random& random) {
    const double radius = random.log_uniform(1e5, 1e8);
    const double along = random.below(4) == 0 ? 0.0 : radius * random.log_uniform(1e-4, 1.0);
    const double length = random.log_uniform(1.0, 1e6);
    // r_high^2 = r_low^2 + 2 along length + length^2.
    const double square = length * (2 * along + length);
    const double rise = square / (radius + std::sqrt(radius * radius + square));
    const double pulled = random.log_uniform(1e-2, 1e3) * (random.below(2) == 0 ? 1 : -1);
    return Piece{radius, along, rise, length, random.log_uniform(1e2, 1e5), pulled};
}

// As single_scattering does it: the rise from the length, so that the two agree in every type.
template <typename T>
T rise_of(const Piece& p) {
    return T(p.length) * (T(2) * T(p.low_along) + T(p.length)) / (T(p.low_radius) + T(p.low_radius + p.rise));
}

template <typename T>
NodeMap<T> map_of(const Piece& p) {
    return node_map(node_fit<T>(), T(p.low_radius), T(p.low_along), T(p.low_radius + p.rise), rise_of<T>(p),
                    T(p.height), T(p.pulled));
}

/// The fits of node_counts.
template <typename T, std::size_t... I>
std::vector<NodeFit<T>> fits_of(std::index_sequence<I...>) {
    return {node_fit<T, Nodes<node_counts[I]>>()...};
}

}  // namespace

TEST_SUITE_BEGIN("node_map");

TEST_CASE_TEMPLATE("the map runs from the low end to the high end of the piece", T, float, double,
                   long double) {
    Random random(611);
    Worst worst;
    for (int i = 0; i < 5000; ++i) {
        const Piece p = random_piece(random);
        const NodeMap<T> map = map_of<T>(p);
        CHECK_UNARY(node_at(map, T(0)).rise == T(0));  // exact: a product with 0
        const Node<T> high = node_at(map, T(1));
        const std::initializer_list<Input> inputs = {{"radius", p.low_radius},
                                                     {"along", p.low_along},
                                                     {"rise", p.rise},
                                                     {"height", p.height},
                                                     {"pulled", p.pulled}};
        // 1 - bend v cancels where the piece is many heights tall.
        const long double condition = 1 + p.rise / p.height;
        const T rise = rise_of<T>(p);
        worst.add(compare_roundoffs("node_at.rise", inputs, high.rise, rise, rise * condition));
        // The high radius is that of the piece to double's digits only.
        const long double length = T(p.length);
        const long double model = sizeof(T) > sizeof(double) ? 2e3L : 1.0L;
        worst.add(compare_roundoffs("node_at.way", inputs, high.way, length, length * condition * model));
    }
    worst.print("ends of the map, 5000 pieces");
    CHECK_WORST(worst, 20.0L);  // of the docstring
}

TEST_CASE("stretch is the derivative of the way, and the rule's sum of it the length of the piece") {
    Random random(612);
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
        const Piece p = random_piece(random);
        const NodeMap<double> map = map_of<double>(p);
        for (const double u : {0.1, 0.5, 0.9}) {
            const double step = 1e-5;
            const double slope = (node_at(map, u + step).way - node_at(map, u - step).way) / (2 * step);
            // Central difference: step^2 times the third derivative, which grows with (1 - bend v)^-4.
            const double steepness = 1 + std::fabs(p.pulled) * 0.2 + p.rise / p.height;
            CHECK(std::fabs(slope - node_at(map, u).stretch) <=
                  1e-9 * slope * steepness * steepness * steepness + 1e-6 * slope);
        }
        double length = 0;
        for (int j = 0; j < 24; ++j) {
            length += gauss_weight<double, Nodes<24>>(j) *
                      node_at(map, gauss_position<double, Nodes<24>>(j)).stretch;
        }
        if (p.rise < 10 * p.height && std::fabs(p.pulled) < 2) {
            largest = std::fmax(largest, std::fabs(length / p.length - 1));
        }
    }
    std::printf("24 nodes, pieces up to 10 heights and optical depth 2: length to %.1e\n", largest);
    // Where a piece begins just beside the closest approach, its root has a branch point next to the low end.
    CHECK(largest <= 3e-4);
}

TEST_CASE("an optical depth draws the nodes towards the light") {
    const Piece p{6.36e6, 0.0, 6e4, 8.7e5, 8e3, 0.0};
    const auto middle = [&](double pulled) {
        Piece q = p;
        q.pulled = pulled;
        return node_at(map_of<double>(q), 0.5).rise;
    };
    CHECK(middle(-5) < middle(0));
    CHECK(middle(0) < middle(5));
    CHECK(middle(5) < middle(500));
    CHECK(middle(500) < p.rise);
}

TEST_CASE_TEMPLATE("a piece at the closest approach whose rise is none in this type has finite nodes", T,
                   float, double, long double) {
    // Below the smallest normal number a rise loses its digits: 1e-42 m in float; and it may be none at all.
    for (const T rise : {T(0), std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min()}) {
        const NodeMap<T> map = node_map(node_fit<T>(), T(7e7), T(0), T(7e7), rise, T(8000), T(0));
        for (const T u : {T(0.02L), T(0.5L), T(0.98L)}) {
            const Node<T> node = node_at(map, u);
            CHECK(std::isfinite(node.rise));
            CHECK(std::isfinite(node.along));
            CHECK(std::isfinite(node.way));
            CHECK(std::isfinite(node.stretch));
            CHECK(node.stretch >= T(0));
        }
    }
}

TEST_CASE_TEMPLATE("every count of nodes has a fit of its own", T, float, double) {
    const std::vector<NodeFit<T>> fits = fits_of<T>(std::make_index_sequence<std::size(node_counts)>{});
    for (std::size_t i = 0; i < fits.size(); ++i) {
        CAPTURE(node_counts[i]);
        CHECK(fits[i].evenness > T(0));
        CHECK(fits[i].heights > T(0));
        CHECK(fits[i].pull > T(0));
        CHECK(fits[i].sun > T(0));
        CHECK(fits[i].view > T(0));
        CHECK_UNARY(i == 0 || fits[i].evenness != fits[i - 1].evenness);
    }
}

TEST_SUITE_END();
