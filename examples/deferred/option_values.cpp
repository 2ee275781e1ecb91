#include "option_values.hpp"

#include <cstdio>
#include <cstdlib>

#include "support/error.hpp"

namespace deferred {
namespace {

// Larger pictures are no use here: the CPU's pass alone would take an hour.
constexpr int largest_size = 8192;

}  // namespace

void refuse_option(const std::string& what) {
    throw support::Error(what + "; see --help");
}

void require_range(const std::string& option, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
        char text[160];
        std::snprintf(text, sizeof text, "%s %g is out of range; give %g to %g", option.c_str(), value, least,
                      most);
        refuse_option(text);
    }
}

void parse_size(const std::string& option, const std::string& text, int& width, int& height) {
    char rest = 0;
    long w = 0;
    long h = 0;
    if (text.size() > 20 || std::sscanf(text.c_str(), "%ldx%ld%c", &w, &h, &rest) != 2) {
        refuse_option(option + " '" + text + "' is not understood; write it like 640x360");
    }
    if (w < 1 || h < 1 || w > largest_size || h > largest_size) {
        refuse_option(option + " " + text + " is out of range; give 1 to " + std::to_string(largest_size) +
                      " pixels each way");
    }
    width = int(w);
    height = int(h);
}

double parse_exposure(const std::string& text) {
    char* end = nullptr;
    const double exposure = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != 0) {
        refuse_option("--exposure '" + text + "' is neither auto nor a number");
    }
    require_range("--exposure", exposure, 1e-6, 1e12);
    return exposure;
}

}  // namespace deferred
