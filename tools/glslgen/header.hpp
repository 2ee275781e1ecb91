#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace glslgen {

enum class TokenKind { punctuation, keyword, identifier, literal, comment };

struct Token {
    TokenKind kind = TokenKind::punctuation;
    std::string text;
    unsigned line = 0;
    unsigned column = 0;    ///< counted from 1
    std::size_t begin = 0;  ///< offset in the file
    std::size_t end = 0;
};

struct TemplateParameter {
    std::string name;
    std::string default_type;  ///< empty without a default
    bool is_type = true;
};

struct ParameterDeclaration {
    std::string name;
    std::string type;  ///< as clang spells it: "const vec3<T> &"
    unsigned line = 0;
    bool has_default = false;
};

/// A member of a struct, a scene or a hook functor.
struct MemberDeclaration {
    enum class Kind { field, constant, call_operator, base, other };
    Kind kind = Kind::other;
    std::string what;  ///< clang's name of the kind, for messages
    std::string name;
    std::string type;
    unsigned line = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::vector<ParameterDeclaration> parameters;  ///< of a call operator
    std::string result_type;
    std::size_t body_begin = 0;
    std::size_t body_end = 0;
};

/// One declaration of namespace airlight, as libclang's cursors describe it.
struct Declaration {
    enum class Kind { alias, variable, variable_template, record, struct_template, function, other };
    Kind kind = Kind::other;
    std::string what;
    std::string name;   ///< without the namespace
    std::string scope;  ///< "" or "detail::"
    unsigned line = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    std::vector<TemplateParameter> template_parameters;
    std::vector<ParameterDeclaration> parameters;
    std::string result_type;
    std::vector<MemberDeclaration> members;
    std::size_t body_begin = 0;  ///< offset of the '{' of a function; 0 without a body
    std::size_t body_end = 0;

    std::string full_name() const {
        return scope + name;
    }
};

struct MacroUse {
    std::string name;
    unsigned line = 0;
    std::size_t begin = 0;
};

struct Include {
    std::string header;  ///< name of the project header that is included
    unsigned line = 0;
};

/// One header of the project, read.
struct Header {
    std::string name;   ///< "ray_sphere.hpp"
    std::string stem;   ///< "ray_sphere"
    std::string shown;  ///< as messages and generated files call it: "include/airlight/ray_sphere.hpp"
    std::string text;
    std::vector<Token> tokens;
    std::vector<Include> includes;
    std::vector<Declaration> declarations;
    std::vector<MacroUse> macro_uses;
    std::size_t namespace_begin = 0;  ///< offset of the first `namespace airlight`; text.size() without one
    std::set<std::string> visible;    ///< names of this header and of all it includes, directly or not
};

}  // namespace glslgen
