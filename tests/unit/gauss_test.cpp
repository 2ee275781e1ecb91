#include <doctest/doctest.h>
#include <airlight/gauss.hpp>

#include "scenes.hpp"
#include "story.hpp"

using namespace airlight_test;
using airlight::gauss_position;
using airlight::gauss_weight;

namespace {

template <typename T, int Count>
void exact_to_degree(int degree) {
    for (int power = 0; power <= degree; ++power) {
        long double sum = 0;
        for (int i = 0; i < Count; ++i) {
            long double term = gauss_weight<T, Nodes<Count>>(i);
            for (int k = 0; k < power; ++k) {
                term *= gauss_position<T, Nodes<Count>>(i);
            }
            sum += term;
        }
        // Positions and weights are rounded to T, powers up to 47 multiply the first; a few more for sums.
        CHECK_WITHIN(compare_ulp("gauss rule, integral of u^k", {{"points", Count}, {"k", T(power)}}, T(sum),
                                 1.0L / (power + 1)),
                     4.0L + power);
    }
}

template <typename T, int Count>
void is_a_rule() {
    exact_to_degree<T, Count>(2 * Count - 1);
    for (int i = 0; i < Count; ++i) {
        const T x = gauss_position<T, Nodes<Count>>(i);
        const T mirrored = gauss_position<T, Nodes<Count>>(Count - 1 - i);
        CHECK(x > (i == 0 ? T(0) : gauss_position<T, Nodes<Count>>(i - 1)));
        CHECK(x < T(1));
        // Both are rounded.
        CHECK_WITHIN(compare_relative("gauss_position", {{"points", Count}, {"i", T(i)}}, x + mirrored, 1.0L),
                     static_cast<long double>(std::numeric_limits<T>::epsilon()));
        CHECK(gauss_weight<T, Nodes<Count>>(i) > T(0));
    }
}

}  // namespace

TEST_SUITE_BEGIN("gauss");

TEST_CASE_TEMPLATE("a rule of n points integrates powers up to 2 n - 1 exactly, and is symmetric", T, float,
                   double, long double) {
    is_a_rule<T, 4>();
    is_a_rule<T, 5>();
    is_a_rule<T, 6>();
    is_a_rule<T, 8>();
    is_a_rule<T, 10>();
    is_a_rule<T, 12>();
    is_a_rule<T, 16>();
    is_a_rule<T, 24>();
}

TEST_CASE_TEMPLATE("another count of points gets the midpoint rule", T, float, double, long double) {
    exact_to_degree<T, 3>(1);
    CHECK(gauss_position<T, Nodes<3>>(1) == T(0.5));  // exact: the middle
}

TEST_SUITE_END();
