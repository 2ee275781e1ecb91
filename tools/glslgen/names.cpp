#include "names.hpp"

#include <cctype>

namespace glslgen {

std::string macro_name(const std::string& cpp_name) {
    std::string result = "AIRLIGHT_";
    bool after_lower = false;
    for (std::size_t i = 0; i < cpp_name.size(); ++i) {
        const auto letter = static_cast<unsigned char>(cpp_name[i]);
        if (letter == ':') {
            result += '_';
            ++i;  // past the second colon
            after_lower = false;
            continue;
        }
        if (std::isupper(letter) && after_lower) {
            result += '_';
        }
        after_lower = std::islower(letter) || std::isdigit(letter);
        result += static_cast<char>(std::toupper(letter));
    }
    return result;
}

}  // namespace glslgen
