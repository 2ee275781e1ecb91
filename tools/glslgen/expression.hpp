#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model.hpp"
#include "token_stream.hpp"

namespace glslgen {

/// What is known about an expression besides its type.
struct Value {
    Type type;
    bool bare_literal = false;     ///< 2 or 0.5 outside T(...)
    std::optional<double> number;  ///< of T(literal)
    bool is_exp = false;           ///< a call of glm::exp
    bool writable = false;         ///< a local or parameter that is not const, or a part of one
};

struct Local {
    Type type;
    bool is_const = false;
    unsigned line = 0;
};

/// Names inside a function, innermost scope last.
class Locals {
  public:
    void open() {
        scopes_.emplace_back();
    }
    void close() {
        scopes_.pop_back();
    }
    void declare(const std::string& name, const Local& local);
    const Local* find(const std::string& name) const;

  private:
    std::vector<std::map<std::string, Local>> scopes_;
};

/// Reads expressions: gives each its type, refuses what is outside the subset, and edits the tokens.
class ExpressionReader {
  public:
    /// `space` is the namespace below airlight in which names are looked up first: "" or "detail::".
    ExpressionReader(const Program& program, TokenStream& tokens, Locals& locals, Function& function,
                     const std::string& space);

    Value expression();
    /// An expression whose value is used as `expected`.
    Value expression_of(const Type& expected, const std::string& where);
    /// A type; edits it to its GLSL spelling on its last token.
    Type type();
    bool at_type() const;
    /// The condition of `if constexpr`, as the text after #if; its tokens are dropped.
    std::string flag_condition();
    /// Size of an array or end of a loop: a literal, a Scene:: constant, or (for a loop) an int parameter.
    std::string int_bound(const std::string& where, bool parameter_allowed);
    /// `{a, b, c}` as the values of an array.
    void array_values(const Type& array);

    const std::map<std::string, unsigned>& called_builtins() const {
        return called_builtins_;
    }

  private:
    Value conditional();
    Value binary(int least_precedence);
    Value unary();
    Value postfix();
    Value primary();
    Value parenthesised();
    Value literal();
    Value scalar_conversion();
    Value vector_constructor();
    Value aggregate(const std::string& name);
    Value builtin_call();
    Value own_call(const std::string& name);
    Value hook_call(const std::string& hook);
    /// A structure that a hook takes: its macro's text names the caller's variable, so nothing is passed.
    void drop_structure_of_hook(const std::string& hook, const Variable& parameter);
    void note_call(const std::string& name);
    Value scene_member();
    Value infinity();
    Value named();
    Value constant(const std::string& name);
    Value arithmetic(const std::string& symbol, const Value& left, const Value& right, unsigned line);
    Value comparison(const std::string& symbol, const Value& left, const Value& right, unsigned line);
    void refuse_power_of_constant(const std::vector<Value>& arguments, unsigned line) const;
    void refuse_bare(const Value& value, unsigned line) const;

    std::vector<Value> arguments(const std::string& open, const std::string& close);
    void template_arguments(const Function& callee);
    void drop_hook_arguments(const Function& callee);
    const std::string* hook_of(const std::string& parameter) const;
    std::string flag_operand();
    std::string flag_comparison();
    /// Drops the next token and returns it.
    std::string drop_text();

    /// Full name of a declaration that the next tokens name; empty when they name none. `length` is the
    /// number of tokens that the name takes.
    template <typename Entry>
    std::string lookup(const std::map<std::string, Entry>& table, std::size_t& length) const;
    std::string written_name(std::size_t& length) const;
    void drop_qualifiers(std::size_t length);
    void check_visible(const Named& named, unsigned line) const;
    void refuse_unknown(const std::string& name) const;

    const Program& program_;
    TokenStream& tokens_;
    Locals& locals_;
    Function& function_;
    std::string space_;
    std::map<std::string, unsigned> called_builtins_;
};

}  // namespace glslgen
