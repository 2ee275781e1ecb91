#pragma once

// A row: one function of the manifest, where its inputs come from, its C++ call, and what "equal" means.
//
//     row("rayleigh_phase")
//         .inputs([](Draw& draw) { return std::make_tuple(draw.cosine()); })
//         .cpu([](auto cos_theta) { return airlight::rayleigh_phase(cos_theta); })
//         .to_the_bit();
//
// The call is generic: it runs in float, in double, and on `Bounded`, which derives the tolerances.

#include "bounded.hpp"
// Bounded first: the headers below look its overloads up.
#include <airlight/scene.hpp>
#include <airlight/transmittance_table.hpp>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "draw.hpp"
#include "flatten.hpp"
#include "scenes.hpp"

namespace parity {

/// One call, in all three scalar types.
struct Evaluation {
    std::vector<float> in_float;
    std::vector<double> in_double;
    std::vector<Bounded::Bounds> bounds;
    std::array<bool, comparisons> undecided{};  ///< rounding could have turned a branch the other way
};

/// What a row of one function asks of the two sides.
enum class Tolerance {
    to_the_bit,    ///< 0 ulp on software GL: nothing but + - * / sqrt, comparisons and conversions
    within_bound,  ///< calls exp, log or pow: error of those times the condition of what follows
};

/// The hooks of a run: those that stand in scenes.hpp, or the library's defaults.
struct TestHooks {
    using Visibility = PartlyLit;
    using LightVisibility = PartlySeen;
    using MultipleScattering = UnevenLight;
    using GroundIrradiance = LitGround;
    using FroxelTable = UnevenFroxels;
    using SlantTable = UnevenSlants;
    using HabitatLight = UnevenHabitat;
    using IndirectIrradiance = UnevenWall;
    template <typename Scene>
    using TransmittanceToSpace = EveningLight;
};
struct DefaultHooks {
    using Visibility = airlight::AlwaysLit;
    using LightVisibility = airlight::AlwaysSeen;
    using MultipleScattering = airlight::NoDiffuseLight;
    using GroundIrradiance = airlight::NoIrradiance;
    using FroxelTable = airlight::NoFroxels;
    using SlantTable = airlight::NoSlantTable;
    using HabitatLight = airlight::BareHabitatLight;
    using IndirectIrradiance = airlight::NoIndirectIrradiance;
    template <typename Scene>
    using TransmittanceToSpace = airlight::ComputedTransmittance<Scene>;
};

/// What a row's call may ask about the run it is part of: Run::T, Run::Scene, and the hooks.
template <typename Scalar, typename SceneType, typename Hooks>
struct Run {
    using T = Scalar;
    using Scene = SceneType;
    typename Hooks::Visibility visibility{};
    typename Hooks::LightVisibility light_visibility{};
    typename Hooks::MultipleScattering multiple_scattering{};
    typename Hooks::GroundIrradiance ground_irradiance{};
    typename Hooks::FroxelTable froxel_table{};
    typename Hooks::SlantTable slant_table{};
    typename Hooks::HabitatLight habitat_light{};
    typename Hooks::IndirectIrradiance indirect_irradiance{};
    typename Hooks::template TransmittanceToSpace<SceneType> transmittance_to_space{};
};

/// A row without its types, as the test program handles it.
struct Row {
    std::string function;
    Tolerance tolerance = Tolerance::to_the_bit;
    std::size_t count = 16384;
    std::string note;                ///< stated beside the row, in the report too
    bool hooked_everywhere = false;  ///< the tests' hooks in every scene, and no run without them
    double most_undecided = 0.25;    ///< share of inputs that hardware's rounding may leave undecided
    double most_unbounded = 0.01;    ///< share of numbers that may have no bound
    std::string input_signature;     ///< one letter per float: f, i, b
    std::string result_signature;    ///< likewise
    std::function<std::vector<float>(Draw&)> draw;
    /// Scene number, whether the tests' hooks are on, the flat input.
    std::function<Evaluation(std::size_t, bool, const std::vector<float>&)> evaluate;
};

namespace detail {

template <typename V>
void append_floats(const V& value, std::vector<float>& out) {
    for_each_leaf(value, [&](const auto& leaf) { out.push_back(static_cast<float>(leaf)); });
}

template <typename... A>
std::vector<float> flat(const std::tuple<A...>& arguments) {
    std::vector<float> out;
    std::apply([&](const auto&... argument) { (append_floats(argument, out), ...); }, arguments);
    return out;
}

template <typename V>
void read_floats(V& value, const std::vector<float>& in, std::size_t& at) {
    for_each_leaf(value, [&](auto& leaf) { leaf = static_cast<std::decay_t<decltype(leaf)>>(in[at++]); });
}

template <typename Tuple>
Tuple unflat(const std::vector<float>& in) {
    Tuple out{};
    std::size_t at = 0;
    std::apply([&](auto&... argument) { (read_floats(argument, in, at), ...); }, out);
    return out;
}

template <typename T, typename Scene, typename Hooks, typename Call, typename Tuple>
auto call_in(const Call& call, const Tuple& inputs) {
    return std::apply(
        [&](const auto&... argument) {
            using R = Run<T, Scene, Hooks>;
            if constexpr (std::is_invocable_v<Call, R, decltype(converted<T>(argument))...>) {
                return call(R{}, converted<T>(argument)...);
            } else {
                return call(converted<T>(argument)...);
            }
        },
        inputs);
}

template <typename Scene, typename Hooks, typename Call, typename Tuple>
Evaluation evaluate(const Call& call, const Tuple& inputs) {
    Evaluation out;
    const auto in_float = call_in<float, Scene, Hooks>(call, inputs);
    const auto in_double = call_in<double, Scene, Hooks>(call, inputs);
    undecided_branches() = {};
    const auto bounded = call_in<Bounded, Scene, Hooks>(call, inputs);
    out.undecided = undecided_branches();
    for_each_leaf(in_float, [&](const auto& x) { out.in_float.push_back(static_cast<float>(x)); });
    for_each_leaf(in_double, [&](const auto& x) { out.in_double.push_back(static_cast<double>(x)); });
    for_each_leaf(bounded, [&](const auto& x) {
        if constexpr (std::is_same_v<std::decay_t<decltype(x)>, Bounded>) {
            out.bounds.push_back(x.bound());
        } else {
            out.bounds.push_back({0, 0, 0});  // a decision or a count: equal or wrong
        }
    });
    return out;
}

/// Whether the call asks about its run; one that does not is the same in every scene and compiled once.
template <typename Call, typename Tuple>
struct takes_run : std::false_type {};
template <typename Call, typename... A>
struct takes_run<Call, std::tuple<A...>>
    : std::is_invocable<Call, Run<float, airlight::DefaultScene, DefaultHooks>, A...> {};

template <bool HookedEverywhere, typename Call, typename Tuple, std::size_t... Others>
Evaluation evaluate_in_scene(std::size_t scene, bool hooked, const Call& call, const Tuple& inputs,
                             std::index_sequence<Others...>) {
    using Default = airlight::DefaultScene;
    if constexpr (takes_run<Call, Tuple>::value) {
        using Hooks = std::conditional_t<HookedEverywhere, TestHooks, DefaultHooks>;
        if (hooked && scene == 0) {
            return evaluate<Default, TestHooks>(call, inputs);
        }
        Evaluation out;
        const bool other =
            ((scene == Others + 1 &&
              (out = evaluate<std::tuple_element_t<Others + 1, SceneTypes>, Hooks>(call, inputs), true)) ||
             ...);
        return other ? out : evaluate<Default, Hooks>(call, inputs);
    } else {
        return evaluate<Default, DefaultHooks>(call, inputs);
    }
}

}  // namespace detail

/// All rows, in the order of the files that state them.
std::vector<Row>& all_rows();

/// States a row step by step; the last step, the tolerance, enters it.
template <typename Inputs = int, typename Call = int, bool HookedEverywhere = false>
class RowBuilder {
  public:
    RowBuilder(Row row, Inputs draw, Call call)
        : row_(std::move(row)), inputs_(std::move(draw)), call_(std::move(call)) {}
    template <typename I>
    auto inputs(I draw) const {
        return RowBuilder<I, Call, HookedEverywhere>(row_, draw, call_);
    }
    /// For a function without inputs.
    auto no_inputs() const {
        const auto none = [](Draw&) { return std::tuple<>(); };
        return RowBuilder<decltype(none), Call, HookedEverywhere>(row_, none, call_).count(1);
    }
    template <typename C>
    auto cpu(C call) const {
        return RowBuilder<Inputs, C, HookedEverywhere>(row_, inputs_, call);
    }
    RowBuilder count(std::size_t n) const {
        RowBuilder out = *this;
        out.row_.count = n;
        return out;
    }
    /// For a function that without hooks returns 0 in many scenes, which compares nothing.
    auto hooked_everywhere() const {
        Row row = row_;
        row.hooked_everywhere = true;
        return RowBuilder<Inputs, Call, true>(row, inputs_, call_);
    }
    RowBuilder note(const std::string& text) const {
        RowBuilder out = *this;
        out.row_.note = text;
        return out;
    }
    /// For a function whose end points meet more often than others': shares that may be left out, and why.
    RowBuilder left_out(double undecided, double unbounded, const std::string& why) const {
        RowBuilder out = *this;
        out.row_.most_undecided = undecided;
        out.row_.most_unbounded = unbounded;
        return out.note(why);
    }
    bool to_the_bit() const {
        return enter(Tolerance::to_the_bit);
    }
    bool within_bound() const {
        return enter(Tolerance::within_bound);
    }

  private:
    bool enter(Tolerance tolerance) const {
        Row row = row_;
        row.tolerance = tolerance;
        using Tuple = std::decay_t<std::invoke_result_t<Inputs, Draw&>>;
        const Inputs draw = inputs_;
        const Call call = call_;
        const Tuple example{};
        std::apply([&](const auto&... argument) { (append_signature(argument, row.input_signature), ...); },
                   example);
        using Result = decltype(detail::call_in<float, airlight::DefaultScene, DefaultHooks>(call, example));
        append_signature(Result{}, row.result_signature);
        row.draw = [draw](Draw& d) { return detail::flat(draw(d)); };
        row.evaluate = [call](std::size_t scene, bool hooked, const std::vector<float>& in) {
            return detail::evaluate_in_scene<HookedEverywhere>(
                scene, hooked, call, detail::unflat<Tuple>(in),
                std::make_index_sequence<std::tuple_size_v<SceneTypes> - 1>{});
        };
        all_rows().push_back(std::move(row));
        return true;
    }

    Row row_;
    Inputs inputs_;
    Call call_;
};

inline RowBuilder<> row(const std::string& function) {
    Row r;
    r.function = function;
    return RowBuilder<>(r, 0, 0);
}

}  // namespace parity
