#pragma once

#include <string>

namespace glslgen {

/// "ozone_tent" becomes "AIRLIGHT_OZONE_TENT", "TransmittanceToSpace" "AIRLIGHT_TRANSMITTANCE_TO_SPACE".
std::string macro_name(const std::string& cpp_name);

}  // namespace glslgen
