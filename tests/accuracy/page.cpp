#include "page.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "accuracy_page.hpp"

namespace float_error {
namespace {

constexpr const char* machine = "Compiled by ";

std::string without_machine(const std::string& section) {
    std::istringstream lines(section);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        kept += line.rfind(machine, 0) == 0 ? "" : line + "\n";
    }
    return kept;
}

}  // namespace

std::string section_of(const std::string& page) {
    return airlight_test::float_error_section(page);
}

std::string with_section(const std::string& page, const std::string& section) {
    return page.substr(0, page.size() - section_of(page).size()) + section;
}

std::string machine_line() {
#if defined(__clang__)
    return std::string(machine) + __VERSION__ + " for " + std::to_string(8 * sizeof(void*)) + " bits.";
#elif defined(__GNUC__)
    return std::string(machine) + "g++ " + __VERSION__ + " for " + std::to_string(8 * sizeof(void*)) +
           " bits.";
#else
    return std::string(machine) + "another compiler.";
#endif
}

std::string difference(const std::string& committed, const std::string& measured) {
    std::istringstream old_words(without_machine(committed));
    std::istringstream new_words(without_machine(measured));
    std::string before;
    std::string now;
    while (old_words >> before) {
        if (!(new_words >> now)) {
            return "the page has more: '" + before + "'";
        }
        if (before == now) {
            continue;
        }
        char* end = nullptr;
        const double old_figure = std::strtod(before.c_str(), &end);
        const bool number = *end == '\0';
        const double new_figure = std::strtod(now.c_str(), &end);
        if (!number || *end != '\0' ||
            std::fabs(new_figure - old_figure) > 0.5 * std::fmax(old_figure, new_figure)) {
            return "the page says '" + before + "', measured '" + now + "'";
        }
    }
    return new_words >> now ? "the page ends before '" + now + "'" : "";
}

}  // namespace float_error
