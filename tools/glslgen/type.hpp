#pragma once

#include <string>

namespace glslgen {

/// A type of the subset. A vector has 2 to 4 components; an array holds scalars, vectors or ints.
struct Type {
    enum class Kind { none, scalar, integer, boolean, vector, structure };
    Kind kind = Kind::none;
    int components = 1;
    std::string structure;  ///< C++ name of a struct
    std::string array;      ///< GLSL text of the array's size; empty for what is no array

    bool is_array() const {
        return !array.empty();
    }
    bool is(Kind other) const {
        return kind == other && !is_array();
    }
    bool is_number() const {
        return is(Kind::scalar) || is(Kind::vector);
    }
    Type element() const;
    Type array_of(const std::string& size) const;
};

bool operator==(const Type& a, const Type& b);
bool operator!=(const Type& a, const Type& b);

Type scalar_type();
Type integer_type();
Type boolean_type();
Type vector_type(int components);
Type structure_type(const std::string& name);

/// Name of a declaration in GLSL: the prefix, and `::` read as `_`.
std::string glsl_name(const std::string& cpp_name);

/// "float", "vec3", "airlight_Column", "float[8]".
std::string glsl_type(const Type& type);

/// The same, with a struct called by its C++ name: what the manifest says.
std::string manifest_type(const Type& type);

/// As a C++ author writes it: "T", "vec3<T>", "Column<T>"; for messages.
std::string cpp_type(const Type& type);

}  // namespace glslgen
