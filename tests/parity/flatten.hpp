#pragma once

// Values as rows of floats, the form in which they travel to the shader and back: structs member by member,
// vec3 as three floats, int and bool as float. Works for every plain aggregate without naming its members.

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "bounded.hpp"

namespace parity {

template <typename V>
struct is_vector : std::false_type {};
template <glm::length_t L, typename T, glm::qualifier Q>
struct is_vector<glm::vec<L, T, Q>> : std::true_type {};

template <typename V>
inline constexpr bool is_leaf_v = std::is_arithmetic_v<V> || std::is_same_v<V, Bounded>;

namespace detail {

struct AnyValue {
    template <typename V>
    constexpr operator V() const noexcept;
};
template <typename S, std::size_t... I>
auto takes(std::index_sequence<I...>) -> decltype(S{(static_cast<void>(I), AnyValue{})...}, std::true_type{});
template <typename S, std::size_t N>
constexpr auto takes_n(int) -> decltype(takes<S>(std::make_index_sequence<N>{})) {
    return {};
}
template <typename S, std::size_t N>
constexpr std::false_type takes_n(...) {
    return {};
}
inline constexpr std::size_t most_members = 16;
template <typename S, std::size_t N = most_members>
constexpr std::size_t member_count() {
    static_assert(N > 0, "not an aggregate with 1 to 16 members");
    if constexpr (takes_n<S, N>(0)) {
        return N;
    } else {
        return member_count<S, N - 1>();
    }
}

}  // namespace detail

/// The members of an aggregate, as a tuple of references.
template <typename S>
auto members(S& s) {
    constexpr std::size_t n = detail::member_count<std::remove_const_t<S>>();
    if constexpr (n == 1) {
        auto& [a] = s;
        return std::tie(a);
    } else if constexpr (n == 2) {
        auto& [a, b] = s;
        return std::tie(a, b);
    } else if constexpr (n == 3) {
        auto& [a, b, c] = s;
        return std::tie(a, b, c);
    } else if constexpr (n == 4) {
        auto& [a, b, c, d] = s;
        return std::tie(a, b, c, d);
    } else if constexpr (n == 5) {
        auto& [a, b, c, d, e] = s;
        return std::tie(a, b, c, d, e);
    } else if constexpr (n == 6) {
        auto& [a, b, c, d, e, f] = s;
        return std::tie(a, b, c, d, e, f);
    } else if constexpr (n == 7) {
        auto& [a, b, c, d, e, f, g] = s;
        return std::tie(a, b, c, d, e, f, g);
    } else if constexpr (n == 8) {
        auto& [a, b, c, d, e, f, g, h] = s;
        return std::tie(a, b, c, d, e, f, g, h);
    } else if constexpr (n == 9) {
        auto& [a, b, c, d, e, f, g, h, i] = s;
        return std::tie(a, b, c, d, e, f, g, h, i);
    } else if constexpr (n == 10) {
        auto& [a, b, c, d, e, f, g, h, i, j] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j);
    } else if constexpr (n == 11) {
        auto& [a, b, c, d, e, f, g, h, i, j, k] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k);
    } else if constexpr (n == 12) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
    } else if constexpr (n == 13) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m);
    } else if constexpr (n == 14) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, o] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, o);
    } else if constexpr (n == 15) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, o, p] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, o, p);
    } else {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, o, p, q);
    }
}

/// Calls visit(leaf) for every scalar inside `value`, in declaration order.
template <typename V, typename Visit>
void for_each_leaf(V& value, const Visit& visit) {
    using Plain = std::remove_const_t<V>;
    if constexpr (is_leaf_v<Plain>) {
        visit(value);
    } else if constexpr (is_vector<Plain>::value) {
        for (glm::length_t i = 0; i < Plain::length(); ++i) {
            visit(value[i]);
        }
    } else {
        std::apply([&](auto&... member) { (for_each_leaf(member, visit), ...); }, members(value));
    }
}

/// One letter per scalar: f, i or b. The manifest's types have the same spelling, so the two can be compared.
template <typename V>
void append_signature(const V& value, std::string& signature) {
    for_each_leaf(value, [&](const auto& leaf) {
        using Leaf = std::decay_t<decltype(leaf)>;
        signature += std::is_same_v<Leaf, bool> ? 'b' : (std::is_same_v<Leaf, int> ? 'i' : 'f');
    });
}

/// The type of a value when its scalar is T: float becomes T, vec3<float> vec3<T>, Atmosphere<float>
/// Atmosphere<T>.
template <typename V, typename T>
struct with_scalar {
    using type = V;
};
template <typename T>
struct with_scalar<float, T> {
    using type = T;
};
template <glm::length_t L, typename T>
struct with_scalar<glm::vec<L, float, glm::defaultp>, T> {
    using type = glm::vec<L, T, glm::defaultp>;
};
template <template <typename> class S, typename T>
struct with_scalar<S<float>, T> {
    using type = S<T>;
};

/// The same numbers in another scalar type; exact, because inputs are floats.
template <typename T, typename V>
auto converted(const V& value) {
    using Out = typename with_scalar<V, T>::type;
    if constexpr (std::is_same_v<Out, V>) {
        return value;
    } else if constexpr (is_leaf_v<V>) {
        return Out(value);
    } else if constexpr (is_vector<V>::value) {
        Out out(T(0));
        for (glm::length_t i = 0; i < V::length(); ++i) {
            out[i] = T(value[i]);
        }
        return out;
    } else {
        return std::apply([](const auto&... member) { return Out{converted<T>(member)...}; }, members(value));
    }
}

}  // namespace parity
