#include "body.hpp"

#include <algorithm>

#include "expression.hpp"
#include "refusal.hpp"
#include "subset.hpp"

namespace glslgen {
namespace {

/// One branch of `if constexpr`. In GLSL its braces go, unless a name it declares would then clash.
struct FlagBlock {
    std::size_t chain = 0;  ///< branches of one if share it
    std::size_t head = 0;   ///< last token before the brace
    std::size_t open = 0;   ///< '{'
    std::size_t close = 0;  ///< '}'
    std::string directive;  ///< "#if ...", "#elif ..." or "#else"
    bool last = false;      ///< "#endif" follows
    unsigned column = 0;    ///< of the `if`
};

/// A brace that is open where a name is declared: -1 for one that stays, else the index of a FlagBlock.
using ScopePath = std::vector<int>;

struct DeclaredName {
    std::string name;
    unsigned line = 0;
    ScopePath path;
};

class BodyReader {
  public:
    BodyReader(const Program& program, const Header& header, Edits& edits, Function& function,
               const std::string& space, std::size_t begin, std::size_t end)
        : edits_(edits),
          function_(function),
          tokens_(header, edits, begin, end),
          expressions_(program, tokens_, locals_, function, space) {}

    void read() {
        locals_.open();
        for (const Variable& parameter : function_.parameters) {
            declare(parameter.name, {parameter.type, false, tokens_.line()});
        }
        block(-1);
        check_builtin_names();
        for (std::size_t i = 0; i < flag_blocks_.size(); ++i) {
            write_flag_block(i);
        }
    }

  private:
    void declare(const std::string& name, const Local& local) {
        check_identifier(name, local.line);
        locals_.declare(name, local);
        declared_.push_back({name, local.line, path_});
    }

    /// `{ statements }`; `flag_block` is the index of the branch it belongs to, or -1.
    void block(int flag_block) {
        const std::size_t open = tokens_.take("{", "a block");
        path_.push_back(flag_block);
        locals_.open();
        while (!tokens_.next_is("}")) {
            if (tokens_.at_end()) {
                tokens_.refuse("a block without an end");
            }
            statement(open);
        }
        const std::size_t close = tokens_.take();
        edits_[close].statement = true;
        locals_.close();
        path_.pop_back();
        if (flag_block >= 0) {
            flag_blocks_[static_cast<std::size_t>(flag_block)].open = open;
            flag_blocks_[static_cast<std::size_t>(flag_block)].close = close;
        }
    }

    void statement(std::size_t block_open) {
        const std::size_t first = mark_statement();
        if (tokens_.token(first).line == tokens_.token(block_open).line && !path_.empty() &&
            path_.back() >= 0) {
            edits_[first].column = flag_blocks_[static_cast<std::size_t>(path_.back())].column + 4;
        }
        if (tokens_.next_is("if")) {
            tokens_.text(1) == "constexpr" ? flag_branch() : branch();
        } else if (tokens_.next_is("for")) {
            loop();
        } else if (tokens_.next_is("return")) {
            tokens_.take();
            if (tokens_.next_is(";")) {
                tokens_.refuse("a return without a value");
            }
            expressions_.expression_of(function_.result, "the result");
            tokens_.take(";", "a return");
        } else if (tokens_.next_is("break")) {
            if (loops_ == 0) {
                tokens_.refuse("break outside a loop");
            }
            tokens_.take();
            tokens_.take(";", "a break");
        } else if (tokens_.next_is("{")) {
            tokens_.refuse("a block of its own: make it a function");
        } else if (tokens_.next_is("[") || tokens_.next_is("const") || expressions_.at_type()) {
            declaration();
        } else {
            assignment();
        }
    }

    /// Marks the next token as the first of a statement and returns its index.
    std::size_t mark_statement() {
        const std::size_t first = tokens_.index();
        edits_[first].statement = true;
        return first;
    }

    void condition() {
        tokens_.take("(", "if");
        expressions_.expression_of(boolean_type(), "if");
        tokens_.take(")", "if");
    }

    void braced(const std::string& after) {
        if (!tokens_.next_is("{")) {
            tokens_.refuse("braces belong around what follows " + after);
        }
    }

    void branch() {
        tokens_.take();
        condition();
        braced("if");
        block(-1);
        if (!tokens_.next_is("else")) {
            return;
        }
        edits_[tokens_.index()].statement = true;
        tokens_.take();
        if (tokens_.next_is("if")) {
            if (tokens_.text(1) == "constexpr") {
                tokens_.refuse(
                    "else if constexpr after an if that is decided at run time: nest it in braces");
            }
            branch();
            return;
        }
        braced("else");
        block(-1);
    }

    void flag_branch() {
        const std::size_t chain = flag_blocks_.size();
        const unsigned column = tokens_.token(tokens_.index()).column;
        std::string word = "#if ";
        for (bool more = true; more;) {
            FlagBlock current;
            current.chain = chain;
            current.column = column;
            if (tokens_.next_is("if")) {
                tokens_.drop();
                if (!tokens_.next_is("constexpr")) {
                    tokens_.refuse(
                        "else if after if constexpr: nest it in braces, or write else if constexpr");
                }
                tokens_.drop();
                tokens_.drop("(", "if constexpr");
                current.directive = word + expressions_.flag_condition();
                current.head = tokens_.drop(")", "if constexpr");
            } else {
                current.directive = "#else";
                current.head = last_dropped_;
            }
            const bool is_else = current.directive == "#else";
            braced(is_else ? "else" : "if constexpr");
            const std::size_t index = flag_blocks_.size();
            flag_blocks_.push_back(current);
            block(static_cast<int>(index));
            more = !is_else && tokens_.next_is("else");
            flag_blocks_[index].last = !more;
            if (more) {
                last_dropped_ = tokens_.drop();
            }
            word = "#elif ";
        }
    }

    void loop() {
        tokens_.take();
        const std::string shape = "a loop, for (int i = 0; i < N; ++i),";
        tokens_.take("(", shape);
        tokens_.take("int", shape);
        const std::string name = tokens_.text();
        const unsigned line = tokens_.line();
        locals_.open();
        path_.push_back(-1);
        declare(name, {integer_type(), true, line});
        tokens_.take();
        tokens_.take("=", shape);
        expressions_.int_bound("the start of a loop", false);
        tokens_.take(";", shape);
        tokens_.take(name, shape);
        tokens_.take("<", shape);
        expressions_.int_bound("the end of a loop", true);
        tokens_.take(";", shape);
        tokens_.take("++", shape);
        tokens_.take(name, shape);
        tokens_.take(")", shape);
        braced("for");
        ++loops_;
        block(-1);
        --loops_;
        path_.pop_back();
        locals_.close();
    }

    void declaration() {
        drop_attribute();
        const bool is_const = tokens_.drop_if("const");
        if (is_const && tokens_.kind() == TokenKind::identifier && !expressions_.at_type()) {
            expressions_.type();  // says what is wrong with it
        }
        Type type = expressions_.type();
        const unsigned line = tokens_.line();
        const std::string name = tokens_.text();
        if (tokens_.kind() != TokenKind::identifier) {
            tokens_.refuse("'" + name + "' where a declaration needs a name");
        }
        tokens_.take();
        if (tokens_.next_is("[")) {
            tokens_.take();
            type = type.array_of(expressions_.int_bound("the size of an array", false));
            tokens_.take("]", "an array");
        }
        if (tokens_.next_is("(") || tokens_.next_is("{")) {
            tokens_.refuse("'" + name + "' is given its value otherwise than with =");
        }
        if (tokens_.next_is("=")) {
            tokens_.take();
            if (type.is_array()) {
                expressions_.array_values(type);
            } else {
                expressions_.expression_of(type, "'" + name + "'");
            }
        } else if (!type.is_array()) {
            tokens_.refuse("'" + name + "' has no value: give it one where it is declared");
        }
        if (tokens_.next_is(",")) {
            tokens_.refuse("two declarations in one: write a line for each");
        }
        tokens_.take(";", "a declaration");
        declare(name, {type, is_const, line});
    }

    void drop_attribute() {
        if (tokens_.next_is("[") && tokens_.text(2) == "maybe_unused") {
            for (int i = 0; i < 5; ++i) {
                tokens_.drop();
            }
        } else if (tokens_.next_is("[")) {
            tokens_.refuse("a lambda or an attribute: outside the subset");
        }
    }

    void assignment() {
        const unsigned line = tokens_.line();
        const Value target = expressions_.expression();
        const std::string symbol = tokens_.text();
        const bool compound = symbol == "+=" || symbol == "-=" || symbol == "*=" || symbol == "/=";
        if (symbol != "=" && !compound) {
            tokens_.refuse(symbol == ";" ? "a statement without an effect"
                                         : "'" + symbol + "' where a statement needs =, +=, -=, *= or /=");
        }
        if (!target.writable) {
            throw Refused(line, "an assignment to something that is const or no variable");
        }
        tokens_.take();
        if (compound && target.type.is(Type::Kind::vector)) {
            const Value value = expressions_.expression();
            if (value.type != target.type && value.type != scalar_type()) {
                throw Refused(line, "'" + symbol + "' between " + cpp_type(target.type) + " and " +
                                        cpp_type(value.type));
            }
        } else if (compound && target.type != scalar_type() && target.type != integer_type()) {
            throw Refused(line, "'" + symbol + "' on " + cpp_type(target.type));
        } else {
            expressions_.expression_of(target.type, "'" + symbol + "'");
        }
        if (tokens_.next_is("=")) {
            tokens_.refuse("two assignments in one");
        }
        tokens_.take(";", "an assignment");
    }

    /// A local hides a built-in of the same name, and GLSL then cannot call it.
    void check_builtin_names() const {
        for (const DeclaredName& declared : declared_) {
            if (expressions_.called_builtins().count(declared.name)) {
                throw Refused(declared.line, "'" + declared.name +
                                                 "' hides the built-in glm::" + declared.name +
                                                 ", which this function calls: choose another name");
            }
        }
    }

    /// True when a name is declared in this branch outside braces that stay.
    bool declares_directly(std::size_t block, const DeclaredName& declared) const {
        const auto place = std::find(declared.path.begin(), declared.path.end(), static_cast<int>(block));
        return place != declared.path.end() &&
               std::all_of(place, declared.path.end(), [](int scope) { return scope >= 0; });
    }

    bool inside_chain(std::size_t chain, const DeclaredName& declared) const {
        return std::any_of(declared.path.begin(), declared.path.end(), [&](int scope) {
            return scope >= 0 && flag_blocks_[static_cast<std::size_t>(scope)].chain == chain;
        });
    }

    bool needs_braces(std::size_t block) const {
        for (const DeclaredName& own : declared_) {
            if (!declares_directly(block, own)) {
                continue;
            }
            for (const DeclaredName& other : declared_) {
                if (other.name == own.name && !inside_chain(flag_blocks_[block].chain, other)) {
                    return true;
                }
            }
        }
        return false;
    }

    void write_flag_block(std::size_t index) {
        const FlagBlock& block = flag_blocks_[index];
        const auto directive = [&](std::size_t token, const std::string& text) {
            edits_[token].kind = Edit::Kind::directive;
            edits_[token].text = text;
        };
        if (needs_braces(index)) {
            directive(block.head, block.directive);
            edits_[block.open].column = block.column;
            edits_[block.close].after = block.last ? "#endif" : "";
            return;
        }
        directive(block.open, block.directive);
        if (block.last) {
            directive(block.close, "#endif");
        } else {
            edits_[block.close].kind = Edit::Kind::drop;
        }
        for (std::size_t i = block.open + 1; i < block.close; ++i) {
            ++edits_[i].dedent;
        }
    }

    Edits& edits_;
    Function& function_;
    TokenStream tokens_;
    Locals locals_;
    ExpressionReader expressions_;
    std::vector<FlagBlock> flag_blocks_;
    std::vector<DeclaredName> declared_;
    ScopePath path_;
    std::size_t last_dropped_ = 0;
    int loops_ = 0;
};

}  // namespace

void read_body(const Program& program, const Header& header, Edits& edits, Function& function,
               const std::string& space, std::size_t begin, std::size_t end) {
    BodyReader(program, header, edits, function, space, begin, end).read();
}

}  // namespace glslgen
