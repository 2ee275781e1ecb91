#include "subset.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "refusal.hpp"

namespace glslgen {
namespace {

/// Keywords and reserved words of GLSL 330 to 460 and ES 3.00 that C++ takes as names, and two macros of
/// Windows headers. Types by pattern: see is_glsl_type.
const std::set<std::string>& reserved_words() {
    static const std::set<std::string> words = {
        "active",
        "asm",
        "atomic_uint",
        "attribute",
        "buffer",
        "cast",
        "centroid",
        "coherent",
        "common",
        "discard",
        "external",
        "far",
        "filter",
        "fixed",
        "flat",
        "fvec2",
        "fvec3",
        "fvec4",
        "half",
        "highp",
        "hvec2",
        "hvec3",
        "hvec4",
        "image1D",
        "image2D",
        "image3D",
        "imageBuffer",
        "imageCube",
        "in",
        "inout",
        "input",
        "interface",
        "invariant",
        "layout",
        "lowp",
        "main",
        "mediump",
        "near",
        "noperspective",
        "out",
        "output",
        "packed",
        "partition",
        "patch",
        "precise",
        "precision",
        "readonly",
        "resource",
        "restrict",
        "sample",
        "sampler1D",
        "sampler2D",
        "sampler2DArray",
        "sampler2DShadow",
        "sampler3D",
        "samplerBuffer",
        "samplerCube",
        "shared",
        "smooth",
        "subroutine",
        "superp",
        "uint",
        "uniform",
        "varying",
        "writeonly",
        "defined",
    };
    return words;
}

bool is_glsl_type(const std::string& name) {
    static const std::vector<std::string> stems = {"vec", "ivec", "uvec", "bvec", "dvec", "mat", "dmat"};
    return std::any_of(stems.begin(), stems.end(), [&](const std::string& stem) {
        return name.rfind(stem, 0) == 0 && name.size() > stem.size() && name[stem.size()] >= '2' &&
               name[stem.size()] <= '4' &&
               (name.size() == stem.size() + 1 ||
                (name.size() == stem.size() + 3 && name[stem.size() + 1] == 'x'));
    });
}

const std::map<std::string, std::string>& refused_words() {
    static const std::string hidden_type = "hides the type; spell it: T, int, bool, vec3<T> or a struct";
    static const std::string one_loop = "the only loop is for (int i = 0; i < N; ++i)";
    static const std::string only_if = "branch with if and else";
    static const std::string only_int = "the only integer is int";
    static const std::string scalar = "write T: the scalar type is the caller's choice";
    static const std::string no_exceptions = "GLSL has no exceptions; state the domain in the docstring";
    static const std::string constructor_cast = "convert an int with T(...)";
    static const std::string no_memory = "GLSL has no pointers";
    static const std::string no_bits = "no formula needs bits or addresses; write it with + - * /";
    static const std::string symbols = "write the operator: &&, || or !";
    static const std::map<std::string, std::string> words = {
        {"auto", hidden_type},
        {"decltype", hidden_type},
        {"while", one_loop},
        {"do", one_loop},
        {"goto", only_if},
        {"switch", only_if},
        {"case", only_if},
        {"continue", "put the rest of the loop under an if"},
        {"unsigned", only_int},
        {"signed", only_int},
        {"long", only_int},
        {"short", only_int},
        {"char", only_int},
        {"size_t", only_int},
        {"ptrdiff_t", only_int},
        {"int8_t", only_int},
        {"int16_t", only_int},
        {"int32_t", only_int},
        {"int64_t", only_int},
        {"uint8_t", only_int},
        {"uint16_t", only_int},
        {"uint32_t", only_int},
        {"uint64_t", only_int},
        {"double", scalar},
        {"float", scalar},
        {"try", no_exceptions},
        {"catch", no_exceptions},
        {"throw", no_exceptions},
        {"noexcept", "GLSL has no exceptions; leave it out"},
        {"static", "GLSL has no static data; make it a constant at namespace scope"},
        {"thread_local", "GLSL has no static data; make it a constant at namespace scope"},
        {"mutable", "every value is plain data"},
        {"volatile", "every value is plain data"},
        {"extern", "a header holds the whole definition"},
        {"static_cast", constructor_cast},
        {"const_cast", constructor_cast},
        {"dynamic_cast", constructor_cast},
        {"reinterpret_cast", constructor_cast},
        {"new", no_memory},
        {"delete", no_memory},
        {"nullptr", no_memory},
        {"this", no_memory},
        {"->", no_memory},
        {"sizeof", "write the number, or a Scene:: constant"},
        {"alignas", "every value is plain data"},
        {"alignof", "every value is plain data"},
        {"typeid", "GLSL has no run-time types"},
        {"typedef", "spell the type where it is used"},
        {"using", "spell the type where it is used"},
        {"enum", "write inline constexpr int constants"},
        {"union", "every value is plain data"},
        {"class", "write a struct: a plain aggregate"},
        {"virtual", "a struct has no methods"},
        {"friend", "a struct has no methods"},
        {"private", "a struct is a plain aggregate"},
        {"public", "a struct is a plain aggregate"},
        {"protected", "a struct is a plain aggregate"},
        {"static_assert", "put the check into a test"},
        {"assert", "put the domain into the docstring and a test"},
        {"and", symbols},
        {"or", symbols},
        {"not", symbols},
        {"&", no_bits},
        {"|", no_bits},
        {"^", no_bits},
        {"~", no_bits},
        {"<<", no_bits},
        {">>", no_bits},
        {"...", "parameter packs are outside the subset"},
    };
    return words;
}

std::string lower_suffix(const std::string& text) {
    std::size_t end = text.size();
    while (end > 0 && std::isalpha(static_cast<unsigned char>(text[end - 1]))) {
        --end;
    }
    std::string suffix = text.substr(end);
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return suffix;
}

bool is_plain_number(const std::string& text) {
    if (text.empty() || !(std::isdigit(static_cast<unsigned char>(text[0])) || text[0] == '.')) {
        return false;
    }
    return text.size() < 2 || text[0] != '0' ||
           std::string("xXbB01234567").find(text[1]) == std::string::npos;
}

std::string without_quotes(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), '\''), text.end());
    return text;
}

}  // namespace

void check_identifier(const std::string& name, unsigned line) {
    if (reserved_words().count(name) || is_glsl_type(name)) {
        throw Refused(
            line, "'" + name + "' is a reserved word of GLSL (or of Windows headers): choose another name");
    }
    if (name.find("__") != std::string::npos) {
        throw Refused(line, "'" + name + "' holds two underscores in a row, which GLSL reserves");
    }
    if (name.rfind("gl_", 0) == 0) {
        throw Refused(line, "'" + name + "' begins with gl_, which GLSL reserves");
    }
}

std::string reason_against_word(const std::string& word) {
    const auto entry = refused_words().find(word);
    return entry == refused_words().end() ? "" : entry->second;
}

void check_words(const std::vector<Token>& tokens, std::size_t begin, std::size_t end, std::size_t head_end) {
    for (const Token& token : tokens) {
        // '&' is judged where the type or the expression is read; '>>' closes two lists in a head.
        if (token.begin < begin || token.end > end || token.kind == TokenKind::comment || token.text == "&" ||
            (token.text == ">>" && token.begin < head_end)) {
            continue;
        }
        const std::string reason = reason_against_word(token.text);
        if (!reason.empty()) {
            throw Refused(token.line, "'" + token.text + "' is outside the subset: " + reason);
        }
    }
}

void check_function_docstring(const std::vector<std::string>& lines, const std::string& name, unsigned line) {
    if (lines.empty()) {
        throw Refused(
            line,
            "'" + name + "' has no docstring: /// lines with Units, Domain, Accuracy, Errors and Source");
    }
    for (const char* label : {"Units:", "Domain:", "Accuracy:", "Errors:", "Source:"}) {
        const bool found = std::any_of(lines.begin(), lines.end(), [&](const std::string& text) {
            const std::size_t start = text.find_first_not_of("/ ");
            return start != std::string::npos && text.compare(start, std::string(label).size(), label) == 0;
        });
        if (!found) {
            throw Refused(line, "the docstring of '" + name + "' lacks the label " + label +
                                    " (write \"none\" where there is nothing to say)");
        }
    }
}

void check_ascii(const Token& token) {
    const bool ascii = std::all_of(token.text.begin(), token.text.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 128; });
    if (!ascii) {
        throw Refused(token.line,
                      "a character outside ASCII, which a shader compiler may reject: spell it out");
    }
}

bool is_fractional(const std::string& text) {
    return text.find_first_of(".eEfFlL") != std::string::npos && text.compare(0, 2, "0x") != 0;
}

std::string scalar_literal(const std::string& text, unsigned line) {
    const std::string suffix = lower_suffix(text);
    if (suffix == "f") {
        throw Refused(line, text + " is rounded to float before T sees it: leave the f away");
    }
    if (!is_plain_number(text) || !(suffix.empty() || suffix == "l")) {
        throw Refused(line, text + ": write a plain decimal number");
    }
    std::string result = without_quotes(text.substr(0, text.size() - suffix.size()));
    if (result.find_first_of(".eE") == std::string::npos) {
        result += ".0";
    } else if (result.back() == '.') {
        result += "0";
    } else if (result.front() == '.') {
        result = "0" + result;
    }
    const double value = std::strtod(result.c_str(), nullptr);
    if (value != 0 && (std::fabs(value) > 3.4028234e38 || std::fabs(value) < 1.1754944e-38)) {
        throw Refused(line, text + " is beyond what a GLSL float can hold");
    }
    return result;
}

void check_integer_literal(const std::string& text, unsigned line) {
    if (!is_plain_number(text) || text.find_first_not_of("0123456789") != std::string::npos) {
        throw Refused(line, text + ": write a plain decimal int");
    }
    if (text.size() > 10 || std::strtoll(text.c_str(), nullptr, 10) > 2147483647LL) {
        throw Refused(line, text + " does not fit into a 32-bit int");
    }
}

}  // namespace glslgen
