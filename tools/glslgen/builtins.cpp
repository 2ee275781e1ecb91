#include "builtins.hpp"

#include <algorithm>
#include <map>

namespace glslgen {
namespace {

/// How the arguments of a built-in relate. "gen" is T or a vector; all gen of one call are the same type.
enum class Shape {
    gen,                  ///< (gen) -> gen
    gen_or_int,           ///< the same, and int
    gen_gen,              ///< (gen, gen) -> gen
    gen_last_scalar,      ///< (gen, gen) or (gen, T) -> gen
    gen_last_scalar_int,  ///< the same, and (int, int)
    clamp,                ///< (gen, gen, gen), (gen, T, T) or (int, int, int)
    mix,                  ///< (gen, gen, gen) or (gen, gen, T)
    step,                 ///< (gen, gen) or (T, gen)
    smoothstep,           ///< (gen, gen, gen) or (T, T, gen)
    cross,                ///< (vec3, vec3) -> vec3
};

/// Every function of GLM a header may call; it is spelled the same in GLSL, with the same meaning in GLSL
/// 330, 430, 450 and ES 3.00. A new line needs an accept test (README.md, "How to add a built-in").
const std::map<std::string, Shape>& table() {
    static const std::map<std::string, Shape> entries = {
        {"abs", Shape::gen_or_int},
        {"ceil", Shape::gen},
        {"clamp", Shape::clamp},
        {"cross", Shape::cross},
        {"exp", Shape::gen},
        {"exp2", Shape::gen},
        {"floor", Shape::gen},
        {"fract", Shape::gen},
        {"inversesqrt", Shape::gen},
        {"log", Shape::gen},
        {"log2", Shape::gen},
        {"max", Shape::gen_last_scalar_int},
        {"min", Shape::gen_last_scalar_int},
        {"mix", Shape::mix},
        {"mod", Shape::gen_last_scalar},
        {"pow", Shape::gen_gen},
        {"sign", Shape::gen_or_int},
        {"smoothstep", Shape::smoothstep},
        {"sqrt", Shape::gen},
        {"step", Shape::step},
        {"trunc", Shape::gen},
    };
    return entries;
}

const char* const no_trigonometry =
    "GLSL gives no useful bound for the error of trigonometry; carry cosines and sines instead of angles";

const char* const no_order =
    "drivers add its products in different orders; write dot_product, and the square root of it for a length";

const std::map<std::string, std::string>& refused_on_purpose() {
    static const std::map<std::string, std::string> entries = {
        {"sin", no_trigonometry},
        {"cos", no_trigonometry},
        {"tan", no_trigonometry},
        {"asin", no_trigonometry},
        {"acos", no_trigonometry},
        {"atan", no_trigonometry},
        {"sinh", no_trigonometry},
        {"cosh", no_trigonometry},
        {"tanh", no_trigonometry},
        {"asinh", no_trigonometry},
        {"acosh", no_trigonometry},
        {"atanh", no_trigonometry},
        {"dot", no_order},
        {"length", no_order},
        {"distance", no_order},
        {"normalize", no_order},
        {"radians", "angles do not cross function boundaries; carry cosines"},
        {"degrees", "angles do not cross function boundaries; carry cosines"},
        {"round", "GLSL rounds a half whichever way it likes; write floor(x + T(0.5))"},
        {"fma", "GLSL ES 3.00 and GLSL 3.30 have no fma"},
        {"isnan", "a GPU need not keep NaN; state the domain instead"},
        {"isinf", "a GPU need not keep infinity; state the domain instead"},
    };
    return entries;
}

bool takes_int(Shape shape) {
    return shape == Shape::gen_or_int || shape == Shape::gen_last_scalar_int || shape == Shape::clamp;
}

std::size_t argument_count(Shape shape) {
    switch (shape) {
        case Shape::gen:
        case Shape::gen_or_int:
            return 1;
        case Shape::clamp:
        case Shape::mix:
        case Shape::smoothstep:
            return 3;
        default:
            return 2;
    }
}

bool all_equal(const std::vector<Type>& types) {
    return std::all_of(types.begin(), types.end(), [&](const Type& type) { return type == types.front(); });
}

}  // namespace

bool is_builtin(const std::string& name) {
    return table().count(name) != 0;
}

std::string reason_against_builtin(const std::string& name) {
    const auto entry = refused_on_purpose().find(name);
    return entry == refused_on_purpose().end() ? "" : entry->second;
}

std::optional<Type> builtin_result(const std::string& name, const std::vector<Type>& arguments) {
    const Shape shape = table().at(name);
    if (arguments.size() != argument_count(shape)) {
        return std::nullopt;
    }
    if (arguments.front().is(Type::Kind::integer)) {
        return takes_int(shape) && all_equal(arguments) ? std::optional<Type>(integer_type()) : std::nullopt;
    }
    if (!std::all_of(arguments.begin(), arguments.end(), [](const Type& type) { return type.is_number(); })) {
        return std::nullopt;
    }
    const Type& first = arguments.front();
    const Type& last = arguments.back();
    const bool same = all_equal(arguments);
    const bool vectors = same && first.is(Type::Kind::vector);
    const auto when = [](bool accepted, const Type& type) {
        return accepted ? std::optional<Type>(type) : std::nullopt;
    };
    switch (shape) {
        case Shape::gen:
        case Shape::gen_or_int:
        case Shape::gen_gen:
            return when(same, first);
        case Shape::gen_last_scalar:
        case Shape::gen_last_scalar_int:
            return when(same || last == scalar_type(), first);
        case Shape::clamp:
            return when(same || (arguments[1] == scalar_type() && last == scalar_type()), first);
        case Shape::mix:
            return when(same || (arguments[1] == first && last == scalar_type()), first);
        case Shape::step:
            return when(same || first == scalar_type(), last);
        case Shape::smoothstep:
            return when(same || (first == scalar_type() && arguments[1] == scalar_type()), last);
        case Shape::cross:
            return when(vectors && first.components == 3, first);
    }
    return std::nullopt;
}

std::string builtin_usage(const std::string& name) {
    switch (table().at(name)) {
        case Shape::gen:
            return name + "(x) with a T or a vector";
        case Shape::gen_or_int:
            return name + "(x) with a T, a vector or an int";
        case Shape::gen_gen:
            return name + "(x, y) with two T or two vectors of one size";
        case Shape::gen_last_scalar:
            return name + "(x, y) with two of one type, or a vector and a T";
        case Shape::gen_last_scalar_int:
            return name + "(x, y) with two of one type (int too), or a vector and a T";
        case Shape::clamp:
            return name + "(x, low, high) with three of one type (int too), or a vector and two T";
        case Shape::mix:
            return name + "(x, y, a) with three of one type, or two vectors and a T";
        case Shape::step:
            return name + "(edge, x) with two of one type, or a T and a vector";
        case Shape::smoothstep:
            return name + "(low, high, x) with three of one type, or two T and a vector";
        case Shape::cross:
            return name + "(a, b) with two vec3<T>";
    }
    return name;
}

}  // namespace glslgen
