#include "emit.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace advise {
namespace {

std::string commented(const std::string& text, const std::string& mark) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        out += mark + " " + line + "\n";
    }
    return out;
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

const std::string& ozone_name(const Setting& setting) {
    return ozone_names()[static_cast<std::size_t>(setting.ozone)];
}

const std::string& phase_name(const Setting& setting) {
    return phase_names()[static_cast<std::size_t>(setting.mie_phase)];
}

}  // namespace

const std::vector<std::string>& ozone_names() {
    static const std::vector<std::string> all = {"none", "tent", "lorentzian"};
    return all;
}

const std::vector<std::string>& phase_names() {
    static const std::vector<std::string> all = {"cornette_shanks", "henyey_greenstein", "fog"};
    return all;
}

std::string cpp_text(const Setting& setting, const std::string& name, const std::string& comment) {
    const auto word = [](bool on) { return on ? "true" : "false"; };
    std::ostringstream out;
    out << "#include <airlight/scene.hpp>\n\n"
        << commented(comment, "///") << "struct " << name << " : airlight::DefaultScene {\n"
        << "    static constexpr bool mie = " << word(setting.mie) << ";\n"
        << "    static constexpr int ozone = airlight::ozone_" << ozone_name(setting) << ";\n"
        << "    static constexpr int mie_phase = airlight::phase_" << phase_name(setting) << ";\n"
        << "    static constexpr bool planet_shadow = " << word(setting.planet_shadow) << ";\n"
        << "    static constexpr int nodes = " << setting.nodes << ";\n"
        << "};\n";
    return out.str();
}

std::string glsl_text(const Setting& setting, const std::string& comment) {
    std::ostringstream out;
    out << commented(comment, "//") << "#define AIRLIGHT_MIE " << (setting.mie ? 1 : 0) << "\n"
        << "#define AIRLIGHT_OZONE AIRLIGHT_OZONE_" << upper(ozone_name(setting)) << "\n"
        << "#define AIRLIGHT_MIE_PHASE AIRLIGHT_PHASE_" << upper(phase_name(setting)) << "\n"
        << "#define AIRLIGHT_PLANET_SHADOW " << (setting.planet_shadow ? 1 : 0) << "\n"
        << "#define AIRLIGHT_NODES " << setting.nodes << "\n";
    return out.str();
}

}  // namespace advise
