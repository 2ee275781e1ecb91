#pragma once

// The atmospheres of the study.

#include <airlight/airlight.hpp>
#include <string>
#include <vector>

namespace study {

struct World {
    std::string name;
    std::string title;  ///< in a sentence
    airlight::Atmosphere<double> air;
    int ozone;  ///< profile of the absorbing layer, airlight::ozone_none and so on
};

/// All five: Leenman's, the CS562 renderer's, the default Earth, Mars, and a thick one.
const std::vector<World>& worlds();

}  // namespace study
