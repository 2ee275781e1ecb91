#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "layout.hpp"
#include "type.hpp"

namespace glslgen {

/// Where a declaration stands, and how GLSL calls it.
struct Named {
    std::string name;  ///< C++ name without `airlight::`
    std::string glsl;
    std::string header;
};

struct Constant : Named {
    Type type;
    std::string value;
};

/// A named int, such as `ozone_tent`: a macro, so that `#if` can compare with it.
struct Choice : Named {
    std::string value;
};

/// A member of DefaultScene.
struct Flag : Named {
    Type type;
    std::string value;
    std::vector<std::string> choices;
};

struct Variable {
    std::string name;
    Type type;
};

struct Structure : Named {
    std::vector<Variable> members;
};

/// A functor of C++ that is the default of a hook.
struct Functor : Named {
    std::vector<Variable> parameters;
    Type result;
    bool has_scene = false;  ///< a template of the Scene, which its default passes on
    std::string body;        ///< the default as a GLSL expression
    std::set<std::string> flags;
    std::vector<std::string> calls;  ///< what the default calls
    std::vector<Line> comment;
};

/// A template parameter that a functor fills in C++ and a macro in GLSL.
struct Hook : Named {
    std::string functor;
};

struct Function : Named {
    std::vector<Variable> parameters;
    Type result;
    bool is_template = false;
    bool has_scene = false;
    std::vector<std::string> hooks;       ///< names of its own hooks, in order
    std::vector<std::string> hook_names;  ///< how the parameters that carry them are called
    std::vector<std::string> calls;       ///< in the order of the first call
    std::set<std::string> flags;          ///< own and reached through calls
    std::set<std::string> all_hooks;      ///< the same for hooks
    bool complete = false;                ///< false while its own body is read
};

/// Everything translated so far.
struct Program {
    std::map<std::string, Constant> constants;
    std::map<std::string, Choice> choices;
    std::map<std::string, Flag> flags;
    std::map<std::string, Structure> structures;
    std::map<std::string, Functor> functors;
    std::map<std::string, Hook> hooks;
    std::map<std::string, Function> functions;
    std::set<std::string> refused;  ///< names whose declaration was refused
    std::set<std::string> cpu_only;
    // The same in the order of declaration, for the manifest.
    std::vector<std::string> constant_order, flag_order, hook_order, structure_order, function_order;
};

}  // namespace glslgen
