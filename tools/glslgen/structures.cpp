#include "declarations.hpp"
#include "expression.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {
namespace {

void check_members(const Declaration& declaration) {
    for (const MemberDeclaration& member : declaration.members) {
        switch (member.kind) {
            case MemberDeclaration::Kind::field:
                break;
            case MemberDeclaration::Kind::base:
                throw Refused(member.line,
                              "'" + declaration.name + "' has a base: a struct is a plain aggregate");
            case MemberDeclaration::Kind::constant:
                throw Refused(member.line,
                              "'" + member.name + "' is static: a struct holds plain members only");
            default:
                throw Refused(member.line,
                              "'" + member.name + "' (" + member.what +
                                  ") in a struct: it has no methods, write a function that takes it");
        }
    }
}

}  // namespace

std::vector<Line> read_structure(const Site& site) {
    const Declaration& declaration = site.declaration;
    if (site.comments.doc.empty()) {
        throw Refused(declaration.line, "'" + declaration.name + "' has no docstring: one sentence");
    }
    check_members(declaration);
    check_words(site.header.tokens, declaration.begin, declaration.end);
    TokenStream tokens = stream_of(site);
    Locals locals;
    Function no_function;
    ExpressionReader expressions(site.program, tokens, locals, no_function, declaration.scope);
    Structure structure;
    static_cast<Named&>(structure) = named(site);

    drop_scalar_template(tokens);
    const std::size_t first = tokens.take("struct", "a struct");
    tokens.edit(first).statement = true;
    tokens.replace(structure.glsl);
    tokens.take("{", "a struct");
    while (!tokens.next_is("}")) {
        const std::size_t begin = tokens.index();
        tokens.edit(begin).statement = true;
        Variable member;
        member.type = expressions.type();
        member.name = tokens.text();
        const unsigned line = tokens.line();
        check_identifier(member.name, line);
        if (member.name == "length") {
            tokens.refuse("a member called length: shader compilers read .length as the method of arrays");
        }
        tokens.take();
        if (tokens.next_is("=") || tokens.next_is("{")) {
            tokens.refuse("'" + member.name + "' has a default: GLSL structs have none");
        }
        if (tokens.next_is("[")) {
            tokens.refuse("'" + member.name + "' is an array inside a struct: outside the subset");
        }
        if (tokens.next_is(",")) {
            tokens.refuse("two members in one declaration: write a line for each");
        }
        const std::size_t semicolon = tokens.take(";", "a member");
        if (member_comments(site.header, begin, semicolon).empty()) {
            throw Refused(line, "'" + member.name + "' has no comment: unit in brackets and meaning, ///<");
        }
        structure.members.push_back(member);
    }
    tokens.edit(tokens.take()).statement = true;
    tokens.take(";", "a struct");
    if (structure.members.empty()) {
        throw Refused(declaration.line, "'" + declaration.name + "' has no members: GLSL needs one");
    }
    site.program.structures[structure.name] = structure;
    site.program.structure_order.push_back(structure.name);
    const TokenRange range = range_of(site);
    return lay_out(site.header, site.edits, range.first, range.last);
}

}  // namespace glslgen
