#pragma once

#include <map>
#include <string>

#include "support/manifest.hpp"

namespace cpu_bench {

/// Template arguments of a call: "<T>", or "<T, Scene>" where the function reads flags.
std::string template_arguments(const support::Function& function);

/// What the parameters of functions are given, as C++ in which `draw` is a Draw<T>.
class Parameters {
  public:
    explicit Parameters(const support::Manifest& manifest) : manifest_(manifest) {}

    std::string value(const std::string& function, const support::Member& parameter) {
        return value(function, parameter, 0);
    }

    /// Names of parameters that have no entry, and a function of each.
    const std::map<std::string, std::string>& unknown() const {
        return unknown_;
    }

  private:
    std::string value(const std::string& function, const support::Member& parameter, int depth);
    std::string structure(const std::string& function, const support::Member& parameter, int depth);

    const support::Manifest& manifest_;
    std::map<std::string, std::string> unknown_;
};

}  // namespace cpu_bench
