#pragma once

#include <stdexcept>
#include <string>

namespace glslgen {

/// Why a header has no GLSL, and where: printed as "file:line: reason".
struct Refusal {
    std::string file;
    unsigned line = 0;
    std::string reason;
};

/// Thrown where one declaration leaves the subset; the caller knows the file.
class Refused : public std::runtime_error {
  public:
    Refused(unsigned line, const std::string& reason) : std::runtime_error(reason), line_(line) {}
    unsigned line() const {
        return line_;
    }

  private:
    unsigned line_;
};

/// Thrown instead of Refused where the cause is a declaration that was refused already.
class FollowsFromRefusal : public std::runtime_error {
  public:
    FollowsFromRefusal() : std::runtime_error("follows from an earlier refusal") {}
};

/// The tool itself cannot go on: unreadable file, unwritable folder. One line that says what to do.
class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace glslgen
