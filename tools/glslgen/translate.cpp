#include "translate.hpp"

#include <algorithm>

#include "declarations.hpp"
#include "subset.hpp"

namespace glslgen {
namespace {

const char* const cpu_only_mark = "AIRLIGHT_CPU_ONLY";

class Translator {
  public:
    Translator(const Header& header, Program& program, std::vector<Refusal>& refusals)
        : header_(header), program_(program), refusals_(refusals), edits_(header.tokens.size()) {}

    Translation run() {
        result_.header = header_.name;
        result_.stem = header_.stem;
        result_.shown = header_.shown;
        for (const Include& include : header_.includes) {
            result_.includes.push_back(include.header);
        }
        check_preprocessing();
        read_preface();
        std::size_t previous_end = header_.namespace_begin;
        for (std::size_t i = 0; i < header_.declarations.size(); ++i) {
            const Declaration& declaration = header_.declarations[i];
            const std::size_t next =
                i + 1 < header_.declarations.size() ? header_.declarations[i + 1].begin : header_.text.size();
            read(declaration, previous_end, next);
            previous_end = end_with_comments(declaration, next);
        }
        return std::move(result_);
    }

  private:
    void refuse(unsigned line, const std::string& reason) {
        refusals_.push_back({header_.shown, line, reason});
    }

    void check_preprocessing() {
        for (std::size_t i = 0; i + 1 < header_.tokens.size(); ++i) {
            const Token& token = header_.tokens[i];
            const std::string& word = header_.tokens[i + 1].text;
            const bool at_line_start = i == 0 || header_.tokens[i - 1].line != token.line;
            if (token.text == "#" && at_line_start && word != "include" &&
                !(word == "pragma" && i + 2 < header_.tokens.size() &&
                  header_.tokens[i + 2].text == "once")) {
                refuse(token.line, "#" + word +
                                       ": a header holds #pragma once and #include only; a term that can be "
                                       "off is an if constexpr");
            }
        }
        for (const MacroUse& use : header_.macro_uses) {
            if (use.name != cpu_only_mark) {
                refuse(use.line, "the macro " + use.name + ": write out what it stands for");
            }
        }
    }

    void read_preface() {
        for (const Token& token : header_.tokens) {
            if (token.kind != TokenKind::comment) {
                return;
            }
            result_.preface.push_back({"", glsl_comment(token.text), 0});
        }
    }

    /// Where the comments of the next declaration begin: behind what stands on this one's last line.
    std::size_t end_with_comments(const Declaration& declaration, std::size_t next) const {
        std::size_t end = declaration.end;
        for (const Token* comment : comments_between(declaration.end, next)) {
            if (comment->line == line_of(declaration.end) || continues_trailing(*comment, declaration)) {
                end = comment->end;
            }
        }
        return end;
    }

    unsigned line_of(std::size_t offset) const {
        const auto lines = std::count(header_.text.begin(),
                                      header_.text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
        return static_cast<unsigned>(lines) + 1;
    }

    std::vector<const Token*> comments_between(std::size_t begin, std::size_t end) const {
        std::vector<const Token*> result;
        for (const Token& token : header_.tokens) {
            if (token.begin >= begin && token.end <= end && token.kind == TokenKind::comment &&
                token.text.compare(0, 12, "// namespace") != 0) {
                result.push_back(&token);
            }
        }
        return result;
    }

    /// A `///<` on a line of its own goes on with the one behind the declaration.
    bool continues_trailing(const Token& comment, const Declaration& declaration) const {
        return comment.text.compare(0, 4, "///<") == 0 && comment.line > line_of(declaration.end) &&
               comment.line <= line_of(declaration.end) + 8;
    }

    void read(const Declaration& declaration, std::size_t previous_end, std::size_t next) {
        std::vector<std::vector<const Token*>> blocks;  // comments above, split where a line is left blank
        for (const Token* comment : comments_between(previous_end, declaration.begin)) {
            if (blocks.empty() || blocks.back().back()->line + 1 != comment->line) {
                blocks.emplace_back();
            }
            blocks.back().push_back(comment);
        }
        Comments comments;
        const unsigned first_line = line_of(declaration.begin);
        if (!blocks.empty() && blocks.back().back()->line + 1 == first_line) {
            comments.doc = blocks.back();
            blocks.pop_back();
        }
        for (const Token* comment : comments_between(declaration.end, next)) {
            if (comment->line == line_of(declaration.end) || continues_trailing(*comment, declaration)) {
                comments.trailing.push_back(comment);
            }
        }
        const unsigned top = comments.doc.empty() ? first_line : comments.doc.front()->line;
        const bool adjacent = blocks.empty() && !result_.items.empty() && line_of(previous_end) + 1 == top;
        comments.in_group = adjacent;
        for (const std::vector<const Token*>& block : blocks) {
            add({comment_lines(block), true});
        }
        if (is_cpu_only(declaration, comments)) {
            program_.cpu_only.insert(declaration.full_name());
            return;
        }
        try {
            check_comments(declaration, comments);
            const Site site{header_, declaration, comments, edits_, program_};
            std::vector<Line> lines = read_kind(site);
            if (lines.empty()) {
                return;
            }
            if (lines.back().comment.empty() && !comments.trailing.empty()) {
                lines.back().comment = trailing_text(comments);
                lines.back().comment_column = comments.trailing.front()->column;
            }
            std::vector<Line> all = comment_lines(comments.doc);
            if (declaration.kind == Declaration::Kind::record) {
                all.push_back({"", "//", 0});
                all.push_back({"", "// In GLSL a macro that is defined before this line stays as it is.", 0});
                all.push_back({});
            }
            all.insert(all.end(), lines.begin(), lines.end());
            add({all, !adjacent || declaration.kind == Declaration::Kind::function});
        } catch (const Refused& refused) {
            refuse(refused.line() ? refused.line() : declaration.line, refused.what());
            program_.refused.insert(declaration.full_name());
        } catch (const FollowsFromRefusal&) {
            program_.refused.insert(declaration.full_name());
        }
    }

    void add(Item item) {
        result_.items.push_back(std::move(item));
    }

    bool is_cpu_only(const Declaration& declaration, const Comments& comments) const {
        const auto holds_mark = [](const std::string& text) {
            return text.find(cpu_only_mark) != std::string::npos;
        };
        for (const Token* comment : comments.doc) {
            if (holds_mark(comment->text)) {
                return true;
            }
        }
        // The macro may stand before the declaration or anywhere in its head.
        const std::size_t end = declaration.body_begin ? declaration.body_begin : declaration.end;
        const std::size_t first = first_token_at(header_, declaration.begin);
        const std::size_t start =
            first > 0 && header_.tokens[first - 1].text == cpu_only_mark ? first - 1 : first;
        for (std::size_t i = start; i < header_.tokens.size() && header_.tokens[i].begin < end; ++i) {
            if (header_.tokens[i].text == cpu_only_mark) {
                return true;
            }
        }
        return false;
    }

    void check_comments(const Declaration& declaration, const Comments& comments) const {
        std::vector<const Token*> all = comments_between(declaration.begin, declaration.end);
        all.insert(all.end(), comments.doc.begin(), comments.doc.end());
        all.insert(all.end(), comments.trailing.begin(), comments.trailing.end());
        for (const Token* comment : all) {
            check_ascii(*comment);
            if (comment->text.compare(0, 2, "/*") == 0) {
                throw Refused(comment->line, "a /* */ comment: write // lines");
            }
            if (comment->text.back() == '\\') {
                throw Refused(comment->line, "a comment that ends in a backslash swallows the next line");
            }
        }
        const bool needs_doc = declaration.kind == Declaration::Kind::function ||
                               declaration.kind == Declaration::Kind::struct_template;
        if (needs_doc && !comments.doc.empty() && comments.doc.front()->text.compare(0, 3, "///") != 0) {
            throw Refused(comments.doc.front()->line, "the comment above '" + declaration.name +
                                                          "' is no docstring: begin its lines with ///");
        }
    }

    std::vector<Line> read_kind(const Site& site) {
        const Declaration& declaration = site.declaration;
        switch (declaration.kind) {
            case Declaration::Kind::alias:
                if (declaration.name == "vec2" || declaration.name == "vec3" || declaration.name == "vec4") {
                    return {};
                }
                throw Refused(declaration.line,
                              "the alias '" + declaration.name + "': spell the type where it is used");
            case Declaration::Kind::variable:
                return read_choice(site);
            case Declaration::Kind::variable_template:
                return read_constant(site);
            case Declaration::Kind::struct_template:
                if (is_functor(declaration)) {
                    read_functor(site);
                    return {};
                }
                return read_structure(site);
            case Declaration::Kind::function: {
                std::vector<Line> lines = read_function(site);
                for (const std::string& hook : program_.functions.at(declaration.full_name()).hooks) {
                    if (std::find(result_.hooks.begin(), result_.hooks.end(), hook) == result_.hooks.end()) {
                        result_.hooks.push_back(hook);
                    }
                }
                return lines;
            }
            case Declaration::Kind::record:
                return read_record(site);
            case Declaration::Kind::other:
                break;
        }
        throw Refused(declaration.line,
                      "'" + declaration.name + "' (" + declaration.what +
                          ") is outside the subset: a header holds constants, structs and functions");
    }

    static bool is_functor(const Declaration& declaration) {
        const std::vector<MemberDeclaration>& members = declaration.members;
        return std::any_of(members.begin(), members.end(), [](const MemberDeclaration& member) {
            return member.kind == MemberDeclaration::Kind::call_operator;
        });
    }

    static std::vector<Line> read_record(const Site& site) {
        if (site.declaration.name == "DefaultScene") {
            return read_scene(site);
        }
        if (!is_functor(site.declaration)) {
            throw Refused(site.declaration.line,
                          "'" + site.declaration.name +
                              "' is no template: a struct is template <typename T>, the scene is "
                              "called DefaultScene, a hook's functor has operator()");
        }
        read_functor(site);
        return {};
    }

    const Header& header_;
    Program& program_;
    std::vector<Refusal>& refusals_;
    Edits edits_;
    Translation result_;
};

}  // namespace

Translation translate(const Header& header, Program& program, std::vector<Refusal>& refusals) {
    return Translator(header, program, refusals).run();
}

}  // namespace glslgen
