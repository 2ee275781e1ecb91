#include <doctest/doctest.h>
#include <airlight/tables/table.hpp>

#include <atomic>
#include <limits>
#include <thread>

#include "samplers.hpp"
#include "story.hpp"

using namespace airlight;
using namespace airlight_test;

TEST_SUITE_BEGIN("tables_table");

TEST_CASE("texels lie as OpenGL takes them, x fastest") {
    Table<double> table = make_table<double>(3, 2, 2);
    bake_table(table, [](int i, int j, int k) { return i + 10.0 * j + 100.0 * k; });
    const std::vector<double> expected = {0, 1, 2, 10, 11, 12, 100, 101, 102, 110, 111, 112};
    CHECK(table.texels == expected);
    CHECK(table.texel(2, 1, 1) == 112.0);
}

TEST_CASE_TEMPLATE("a texel's centre returns the texel, half way the mean, beyond the edge the edge", T,
                   float, double) {
    Table<T> table = make_table<T>(4, 2);
    bake_table(table, [](int i, int j, int) { return T(i * i) + T(8 * j); });
    CHECK(sample(table, vec2<T>(T(0.625L), T(0.25L))) == T(4));  // exact: the centre of (2, 0)
    CHECK(sample(table, vec2<T>(T(0.5), T(0.25L))) == T(2.5L));  // exact: (1 + 4) / 2
    CHECK(sample(table, vec2<T>(T(0.5), T(0.5))) == T(6.5L));    // exact: with 9 and 12 above
    CHECK(sample(table, vec2<T>(T(0), T(0))) == T(0));
    CHECK(sample(table, vec2<T>(T(-7), T(0))) == T(0));
    CHECK(sample(table, vec2<T>(T(1), T(1))) == T(17));
    CHECK(sample(table, vec2<T>(T(1e30), T(1e30))) == T(17));
}

TEST_CASE_TEMPLATE("a table of a linear function is that function between its first and last centre", T,
                   float, double) {
    Table<vec3<T>> table = make_table<vec3<T>>(5, 4, 3);
    const auto linear = [](const vec3<T>& p) { return vec3<T>(p.x + p.y, p.y - p.z, p.z * T(2)); };
    bake_table(table, [&](int i, int j, int k) { return linear(texel_centre<T>(table, i, j, k)); });
    Random random(3);
    Worst worst;
    for (int n = 0; n < 2000; ++n) {
        const vec3<T> uvw(T(random.uniform(0.1, 0.9)), T(random.uniform(0.125, 0.875)),
                          T(random.uniform(1.0 / 6, 5.0 / 6)));
        const vec3<T> got = sample(table, uvw);
        worst.add(compare_roundoffs("sample", {{"u", uvw.x}, {"v", uvw.y}, {"w", uvw.z}}, got.x,
                                    static_cast<long double>(uvw.x) + uvw.y, 2.0L));
        worst.add(compare_roundoffs("sample", {{"u", uvw.x}, {"v", uvw.y}, {"w", uvw.z}}, got.y,
                                    static_cast<long double>(uvw.y) - uvw.z, 2.0L));
    }
    CHECK_WORST(worst, 12.0L);  // three weights and three mixtures
}

TEST_CASE_TEMPLATE("a sample lies between the texels it mixes", T, float, double) {
    Table<T> table = make_table<T>(3, 3, 3);
    Random random(9);
    bake_table(table, [&](int, int, int) { return T(random.unit()); });
    T low = T(1);
    T high = T(0);
    for (const T texel : table.texels) {
        low = std::min(low, texel);
        high = std::max(high, texel);
    }
    for (int n = 0; n < 2000; ++n) {
        const T got = sample(table, random.direction<T>());
        CHECK(got >= low * (T(1) - T(4) * std::numeric_limits<T>::epsilon()));  // weights sum to 1 +- 1 ulp
        CHECK(got <= high * (T(1) + T(4) * std::numeric_limits<T>::epsilon()));
    }
}

TEST_CASE("NaN and infinity read an edge") {
    Table<float> table = make_table<float>(2, 2, 2);
    bake_table(table, [](int i, int j, int k) { return float(1 + i + 2 * j + 4 * k); });
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
#ifndef __FAST_MATH__
    CHECK(sample(table, vec3<float>(nan, nan, nan)) == 1.0F);
#endif
    CHECK(sample(table, vec3<float>(infinity, infinity, infinity)) == 8.0F);
    CHECK(sample(table, vec2<float>(-infinity, infinity)) == 3.0F);
}

TEST_CASE("an empty table is black") {
    const Table<vec3<float>> table = make_table<vec3<float>>(0, 4);
    CHECK(sample(table, vec2<float>(0.5F, 0.5F)) == vec3<float>(0.0F));
    CHECK(sample(table, vec3<float>(0.5F, 0.5F, 0.5F)) == vec3<float>(0.0F));
    CHECK(sample(Table<float>{0, 0, 0, {}}, vec2<float>(0.5F, 0.5F)) == 0.0F);
}

TEST_CASE("the caller's threads fill every texel once, in any order") {
    Table<int> one = make_table<int>(7, 5, 3);
    Table<int> other = make_table<int>(7, 5, 3);
    std::atomic<int> calls{0};
    const auto number = [&](int i, int j, int k) {
        ++calls;
        return 1 + i + 7 * j + 35 * k;
    };
    bake_table(one, number);
    CHECK(calls == 105);
    bake_table(other, number, [](int count, const auto& body) {
        std::thread upper([&] {
            for (int row = count - 1; row >= count / 2; --row) {
                body(row);
            }
        });
        for (int row = 0; row < count / 2; ++row) {
            body(row);
        }
        upper.join();
    });
    CHECK(one.texels == other.texels);
}

TEST_SUITE_END();
