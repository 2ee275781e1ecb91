#include "atmosphere_file.hpp"

#include <airlight/atmospheres.hpp>
#include <cmath>
#include <map>
#include <sstream>

#include "support/error.hpp"

namespace advise {
namespace {

/// A member of Atmosphere by its name; one of the two pointers is set.
struct Member {
    double Atmosphere::*number;
    Vector Atmosphere::*spectrum;
    bool positive;  ///< 0 makes no sense: a radius, a height
    bool signed_;   ///< may be negative
};

const std::map<std::string, Member>& members() {
    static const std::map<std::string, Member> all = {
        {"ground_radius", {&Atmosphere::ground_radius, nullptr, true, false}},
        {"top_altitude", {&Atmosphere::top_altitude, nullptr, true, false}},
        {"rayleigh_scattering", {nullptr, &Atmosphere::rayleigh_scattering, false, false}},
        {"rayleigh_scale_height", {&Atmosphere::rayleigh_scale_height, nullptr, true, false}},
        {"mie_scattering", {nullptr, &Atmosphere::mie_scattering, false, false}},
        {"mie_absorption", {nullptr, &Atmosphere::mie_absorption, false, false}},
        {"mie_scale_height", {&Atmosphere::mie_scale_height, nullptr, true, false}},
        {"mie_g", {&Atmosphere::mie_g, nullptr, false, true}},
        {"ozone_absorption", {nullptr, &Atmosphere::ozone_absorption, false, false}},
        {"ozone_altitude", {&Atmosphere::ozone_altitude, nullptr, false, true}},
        {"ozone_half_width", {&Atmosphere::ozone_half_width, nullptr, true, false}},
        {"ground_albedo", {nullptr, &Atmosphere::ground_albedo, false, false}},
    };
    return all;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string known_names() {
    std::string out;
    for (const auto& [name, member] : members()) {
        out += (out.empty() ? "" : ", ") + name;
    }
    return out;
}

double number_of(const std::string& word, const Member& member, const std::string& name,
                 const std::string& place) {
    std::size_t used = 0;
    double value = 0;
    try {
        value = std::stod(word, &used);
    } catch (const std::exception&) {
        used = 0;
    }
    if (used != word.size() || !std::isfinite(value)) {
        throw support::Error(place + "'" + word + "' is no finite number; write it like 8000 or 5.8e-6");
    }
    if ((member.positive && value <= 0) || (!member.signed_ && value < 0)) {
        throw support::Error(place + name + " is " + word + "; it must be " +
                             (member.positive ? "greater than 0" : "0 or more"));
    }
    return value;
}

void set(Atmosphere& air, const std::string& name, const std::string& values, const std::string& place) {
    const Member& member = members().at(name);
    std::vector<double> numbers;
    std::istringstream words(values);
    for (std::string word; words >> word;) {
        numbers.push_back(number_of(word, member, name, place));
    }
    const std::size_t wanted = member.spectrum != nullptr ? 3 : 1;
    if (numbers.size() != wanted) {
        throw support::Error(place + name + " has " + std::to_string(numbers.size()) + " numbers; give " +
                             (wanted == 3 ? "three, for red, green and blue" : "one"));
    }
    if (member.spectrum != nullptr) {
        air.*member.spectrum = Vector(numbers[0], numbers[1], numbers[2]);
    } else {
        air.*member.number = numbers[0];
    }
}

}  // namespace

std::vector<std::string> preset_names() {
    return {"earth", "cs562_earth", "elek_earth", "leenman_earth", "mars"};
}

Air preset(const std::string& name) {
    using namespace airlight;
    if (name == "earth") {
        return {earth<double>(), ozone_tent};
    }
    if (name == "cs562_earth") {
        return {cs562_earth<double>(), ozone_tent};
    }
    if (name == "elek_earth") {
        return {elek_earth<double>(), ozone_tent};
    }
    if (name == "leenman_earth") {
        return {leenman_earth<double>(), ozone_lorentzian};
    }
    if (name == "mars") {
        return {mars<double>(), ozone_tent};
    }
    throw support::Error("there is no preset '" + name +
                         "'; take earth, cs562_earth, elek_earth, leenman_earth or mars");
}

Atmosphere parsed_atmosphere(const std::string& text, const std::string& file) {
    Atmosphere air{};
    std::map<std::string, int> seen;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::string place = file + ":" + std::to_string(number) + ": ";
        const std::string content = trimmed(line.substr(0, line.find('#')));
        if (content.empty()) {
            continue;
        }
        const std::size_t equals = content.find('=');
        if (equals == std::string::npos) {
            throw support::Error(place + "'" + content + "' has no '='; write: name = number");
        }
        const std::string name = trimmed(content.substr(0, equals));
        if (members().count(name) == 0) {
            throw support::Error(place + "'" + name + "' is no member of an atmosphere; the names are " +
                                 known_names());
        }
        const auto [before, fresh] = seen.emplace(name, number);
        if (!fresh) {
            throw support::Error(place + name + " stands on line " + std::to_string(before->second) +
                                 " already; delete one of the two");
        }
        set(air, name, content.substr(equals + 1), place);
    }
    std::string missing;
    for (const auto& [name, member] : members()) {
        if (seen.count(name) == 0) {
            missing += (missing.empty() ? "" : ", ") + name;
        }
    }
    if (!missing.empty()) {
        throw support::Error(file + ":" + std::to_string(number) + ": the file ends without " + missing +
                             "; add a line for each, 0 0 0 for what is not there");
    }
    return air;
}

}  // namespace advise
