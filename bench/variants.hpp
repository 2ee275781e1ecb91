#pragma once

// Which forms of a function are measured: at which steps or nodes, with which flags.

#include <string>
#include <vector>

#include "support/manifest.hpp"

namespace bench {

/// A flag that is not at its default.
struct FlagValue {
    std::string flag;   ///< "ozone"
    std::string macro;  ///< "AIRLIGHT_OZONE"
    std::string value;  ///< of the macro: "0", "AIRLIGHT_OZONE_NONE"
};

struct Variant {
    std::string setting;            ///< steps or nodes, "16" or "16x6"; empty where the function has none
    std::string flags = "default";  ///< or what differs: "mie=0", "ozone=none"
    std::vector<FlagValue> values;
    std::vector<int> counts;  ///< of the function's numbers of steps, in their order
};

/// A function at each number of steps or nodes, all flags at their defaults. The first is its default.
std::vector<Variant> settings(const support::Manifest& manifest, const support::Function& function);

/// A variant with each flag that the function reads at each other value, one at a time.
std::vector<Variant> flag_variants(const support::Manifest& manifest, const support::Function& function,
                                   const Variant& variant);

/// How a flag's value is written: "mie=0", "ozone=lorentzian".
std::string flag_text(const support::Flag& flag, const std::string& value);

/// The value that turns a flag's term off: "0", or the choice that ends in _NONE; "" for a flag without such.
std::string off_value(const support::Flag& flag);

}  // namespace bench
