#include "expression_parts.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {

std::string ExpressionReader::written_name(std::size_t& length) const {
    std::string name = tokens_.text();
    length = 1;
    while (tokens_.text(length) == "::" && tokens_.kind(length + 1) == TokenKind::identifier) {
        name += "::" + tokens_.text(length + 1);
        length += 2;
    }
    return name.rfind("airlight::", 0) == 0 ? name.substr(10) : name;
}

void ExpressionReader::drop_qualifiers(std::size_t length) {
    for (std::size_t i = 1; i < length; ++i) {
        tokens_.drop();
    }
}

void ExpressionReader::check_visible(const Named& named, unsigned line) const {
    if (!tokens_.header().visible.count(named.header)) {
        throw Refused(line, "'" + named.name + "' is declared in " + named.header +
                                ", which this header does not include");
    }
}

void ExpressionReader::refuse_unknown(const std::string& name) const {
    for (const std::string& full : {space_ + name, name}) {
        if (program_.refused.count(full)) {
            throw FollowsFromRefusal();
        }
        if (program_.cpu_only.count(full)) {
            tokens_.refuse("'" + full + "' is marked AIRLIGHT_CPU_ONLY and has no GLSL");
        }
    }
    if (name.rfind("std::", 0) == 0) {
        tokens_.refuse("'" + name + "' is outside the subset: nothing of std:: exists in GLSL");
    }
    const std::string reason = reason_against_word(name);
    if (!reason.empty()) {
        tokens_.refuse("'" + name + "' is outside the subset: " + reason);
    }
    tokens_.refuse(
        "'" + name +
        "' is unknown here: not a local, a built-in (glm::), or a declaration of airlight that stands "
        "before this one");
}

std::string ExpressionReader::drop_text() {
    return tokens_.token(tokens_.drop()).text;
}

bool ExpressionReader::at_type() const {
    const std::string& text = tokens_.text();
    if (text == "T" || text == "int" || text == "bool") {
        return tokens_.text(1) != "(" && tokens_.text(1) != "{";
    }
    std::size_t length = 1;
    if (!is_vector_name(text) && lookup(program_.structures, length).empty()) {
        return false;
    }
    // Name<T> followed by a name or a reference; Name<T>( and Name<T>{ are values.
    return tokens_.text(length) == "<" && tokens_.text(length + 3) != "(" && tokens_.text(length + 3) != "{";
}

Type ExpressionReader::type() {
    const std::string text = tokens_.text();
    const unsigned line = tokens_.line();
    Type result;
    if (text == "T") {
        tokens_.replace("float");
        result = scalar_type();
    } else if (text == "int" || text == "bool") {
        tokens_.take();
        result = text == "int" ? integer_type() : boolean_type();
    } else {
        std::size_t length = 1;
        const std::string structure = is_vector_name(text) ? "" : lookup(program_.structures, length);
        if (!is_vector_name(text) && structure.empty()) {
            refuse_unknown(written_name(length));
        }
        if (structure.empty()) {
            result = vector_type(text[3] - '0');
        } else {
            check_visible(program_.structures.at(structure), line);
            result = structure_type(structure);
        }
        drop_qualifiers(length);
        tokens_.drop();
        tokens_.drop("<", "the type");
        tokens_.drop("T", "the type");
        if (!tokens_.next_is(">")) {
            tokens_.refuse("a type has the one template argument T");
        }
        tokens_.replace(glsl_type(result));
    }
    if (tokens_.next_is("&") || tokens_.next_is("&&")) {
        tokens_.refuse("a reference: GLSL copies values; leave the & away");
    }
    if (tokens_.next_is("*")) {
        tokens_.refuse("a pointer: GLSL has none");
    }
    return result;
}

}  // namespace glslgen
