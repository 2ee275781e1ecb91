#include "methods.hpp"

namespace study {

std::string name_of(Method method) {
    switch (method) {
        case Method::nodes:
            return "single_scattering";
        case Method::marched:
            return "single_scattering_marched";
        case Method::leenman:
            return "leenman";
        case Method::cs562:
            return "cs562";
        case Method::double_loop:
            return "double_loop";
        case Method::hillaire:
            return "hillaire";
        case Method::schueler:
            return "schueler";
        case Method::hdrp:
            return "hdrp";
    }
    return "";
}

std::string title_of(Method method) {
    switch (method) {
        case Method::nodes:
            return "airlight, nodes";
        case Method::marched:
            return "airlight, marched";
        case Method::leenman:
            return "Leenman's shader";
        case Method::cs562:
            return "CS562 renderer, 256x256 table";
        case Method::double_loop:
            return "double loop of the notes";
        case Method::hillaire:
            return "Hillaire, 256x64 table";
        case Method::schueler:
            return "Schueler's Chapman function";
        case Method::hdrp:
            return "HDRP's Chapman function";
    }
    return "";
}

std::string text_of(const Setting& s) {
    const std::string steps = std::to_string(s.steps);
    if (s.method == Method::double_loop) {
        return steps + "x(" + steps + "+" + steps + ")";
    }
    return s.sun_steps > 0 ? steps + "x" + std::to_string(s.sun_steps) : steps;
}

Setting yardstick() {
    return {Method::leenman, 16, 6};
}

const std::vector<Setting>& settings() {
    static const std::vector<Setting> all = [] {
        std::vector<Setting> out;
        const auto add = [&](Method method, const std::vector<int>& steps) {
            for (const int n : steps) {
                out.push_back({method, n, 0});
            }
        };
        add(Method::nodes, {4, 5, 6, 8, 10, 12, 16, 24});
        add(Method::marched, {8, 16, 32, 64, 128, 256, 512});
        for (const auto& [view, sun] : {std::pair(12, 4), {16, 6}, {32, 8}, {64, 16}, {256, 64}}) {
            out.push_back({Method::leenman, view, sun});
        }
        add(Method::cs562, {20, 30, 100, 800});
        add(Method::double_loop, {8, 16, 32, 64});
        add(Method::hillaire, {15, 30, 60, 240});
        add(Method::schueler, {16, 64, 256});
        add(Method::hdrp, {16, 64, 256});
        return out;
    }();
    return all;
}

}  // namespace study
