#pragma once

#include <vector>

#include "methods.hpp"

namespace study {

/// Per ray, the mean over some views.
struct Operations {
    double exponentials;  ///< exp and pow
    double roots;         ///< sqrt
    double divisions;
};

Operations operations(const Setting& setting, const std::vector<View>& views);

}  // namespace study
