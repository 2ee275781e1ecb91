#pragma once

// glsl/manifest.json as the generator writes it.

#include <filesystem>
#include <string>
#include <vector>

namespace support {

struct Member {
    std::string type;
    std::string name;
};

struct Struct {
    std::string name;  ///< in C++
    std::string glsl;
    std::string file;
    std::vector<Member> members;
};

struct Function {
    std::string name;  ///< in C++
    std::string glsl;
    std::string header;
    std::string file;  ///< relative to the folder of the GLSL
    std::vector<Member> parameters;
    std::string result;
    std::vector<std::string> flags;  ///< names, those of the functions it calls included
    std::vector<std::string> hooks;  ///< likewise
    std::vector<std::string> calls;  ///< functions of the library that it calls itself
};

struct Flag {
    std::string name;
    std::string macro;
    std::string type;
    std::string default_value;         ///< in GLSL
    std::vector<std::string> choices;  ///< empty for bool and for plain counts
};

struct Hook {
    std::string name;
    std::string macro;
    std::vector<std::string> parameters;
    std::string default_value;  ///< in GLSL
};

struct Constant {
    std::string name;
    std::string glsl;
    std::string type;
    std::string value;
    std::string header;
    std::string file;
};

struct Manifest {
    std::vector<Constant> constants;
    std::vector<Flag> flags;
    std::vector<Hook> hooks;
    std::vector<Struct> structs;
    std::vector<Function> functions;

    const Function* function(const std::string& name) const;
    const Struct& struct_named(const std::string& name) const;  ///< throws Error when there is none
    const Flag& flag(const std::string& name) const;            ///< likewise
    const Hook& hook(const std::string& name) const;            ///< likewise
    std::vector<std::string> files() const;                     ///< each generated file once

    /// One letter per float of a type: "float" f, "vec3" fff, structs member by member.
    std::string signature(const std::string& type) const;
};

/// Throws Error when the file is missing or not as expected.
Manifest read_manifest(const std::filesystem::path& file);

}  // namespace support
