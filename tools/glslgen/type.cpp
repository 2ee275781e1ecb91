#include "type.hpp"

namespace glslgen {

Type Type::element() const {
    Type result = *this;
    result.array.clear();
    return result;
}

Type Type::array_of(const std::string& size) const {
    Type result = *this;
    result.array = size;
    return result;
}

bool operator==(const Type& a, const Type& b) {
    return a.kind == b.kind && a.components == b.components && a.structure == b.structure &&
           a.array == b.array;
}

bool operator!=(const Type& a, const Type& b) {
    return !(a == b);
}

namespace {

Type plain(Type::Kind kind, int components) {
    Type type;
    type.kind = kind;
    type.components = components;
    return type;
}

std::string with_array(const std::string& element, const Type& type) {
    return type.is_array() ? element + "[" + type.array + "]" : element;
}

std::string builtin_type(const Type& type) {
    switch (type.kind) {
        case Type::Kind::scalar:
            return "float";
        case Type::Kind::integer:
            return "int";
        case Type::Kind::boolean:
            return "bool";
        case Type::Kind::vector:
            return "vec" + std::to_string(type.components);
        default:
            return "";
    }
}

}  // namespace

Type scalar_type() {
    return plain(Type::Kind::scalar, 1);
}
Type integer_type() {
    return plain(Type::Kind::integer, 1);
}
Type boolean_type() {
    return plain(Type::Kind::boolean, 1);
}
Type vector_type(int components) {
    return plain(Type::Kind::vector, components);
}

Type structure_type(const std::string& name) {
    Type type = plain(Type::Kind::structure, 1);
    type.structure = name;
    return type;
}

std::string glsl_name(const std::string& cpp_name) {
    std::string result = "airlight_";
    for (std::size_t i = 0; i < cpp_name.size(); ++i) {
        if (cpp_name[i] == ':') {
            result += '_';
            ++i;
        } else {
            result += cpp_name[i];
        }
    }
    return result;
}

std::string glsl_type(const Type& type) {
    return with_array(type.kind == Type::Kind::structure ? glsl_name(type.structure) : builtin_type(type),
                      type);
}

std::string manifest_type(const Type& type) {
    return with_array(type.kind == Type::Kind::structure ? type.structure : builtin_type(type), type);
}

std::string cpp_type(const Type& type) {
    switch (type.kind) {
        case Type::Kind::scalar:
            return with_array("T", type);
        case Type::Kind::vector:
            return with_array(builtin_type(type) + "<T>", type);
        case Type::Kind::structure:
            return with_array(type.structure + "<T>", type);
        default:
            return with_array(builtin_type(type), type);
    }
}

}  // namespace glslgen
