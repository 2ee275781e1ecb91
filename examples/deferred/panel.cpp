#include "panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cstdio>

#include "options.hpp"

namespace deferred {
namespace {

constexpr ImGuiSliderFlags clamped = ImGuiSliderFlags_AlwaysClamp;
constexpr ImGuiSliderFlags logarithmic = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;

/// "--cascade-colors" as "cascade colors".
std::string label_of(const std::string& option) {
    std::string label = option.substr(2);
    std::replace(label.begin(), label.end(), '-', ' ');
    return label;
}

void help(const std::string& text) {
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", text.c_str());
    }
}

bool slider(const char* label, double& value, double least, double most, const char* format,
            ImGuiSliderFlags flags = clamped) {
    return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &least, &most, format, flags);
}

/// A choice by name.
bool choice(const char* label, int& chosen, const std::vector<std::string>& names) {
    bool changed = false;
    if (ImGui::BeginCombo(label, names[std::size_t(chosen)].c_str())) {
        for (int i = 0; i < int(names.size()); ++i) {
            if (ImGui::Selectable(names[std::size_t(i)].c_str(), i == chosen) && i != chosen) {
                chosen = i;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

void sun_section(Controls& controls, Wishes& wishes) {
    wishes.changed |= slider("elevation", controls.sun_elevation, -90, 90, "%.2f deg");
    wishes.changed |= slider("azimuth", controls.sun_azimuth, 0, 360, "%.1f deg");
    ImGui::Checkbox("moves", &controls.sun_moves);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::SliderFloat("##speed", &controls.sun_speed, 0.01f, 10, "%.2f hours a second", logarithmic);
}

void camera_section(Controls& controls, const Status& status, Wishes& wishes) {
    for (const Camera& camera : named_cameras()) {
        if (&camera != &named_cameras().front()) {
            ImGui::SameLine();
        }
        if (ImGui::Button(camera.name.c_str())) {
            controls.camera = camera;
            controls.riding = false;
            wishes.changed = true;
        }
    }
    ImGui::Checkbox("ride", &controls.riding);
    help("From the ground into space and back");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::SliderFloat("##share", &controls.ride, 0, 1, "%.3f of the way up", clamped)) {
        controls.riding = true;
        controls.ride_pauses = true;
        wishes.changed = true;
    }
    wishes.changed |= slider("heading", controls.camera.heading, 0, 360, "%.1f deg");
    wishes.changed |= slider("pitch", controls.camera.pitch, -90, 90, "%.1f deg");
    wishes.changed |= slider("angle", controls.camera.field_of_view, 5, 120, "%.0f deg");
    ImGui::Text("%s, at %.6g m", controls.camera.name.c_str(), status.altitude);
}

void picture_section(Controls& controls, Wishes& wishes) {
    wishes.changed |= ImGui::Checkbox("automatic exposure", &controls.automatic_exposure);
    ImGui::BeginDisabled(controls.automatic_exposure);
    ImGui::SliderFloat("exposure", &controls.exposure, 1e-2f, 1e7f, "%.4g", logarithmic);
    ImGui::EndDisabled();
    ImGui::SliderInt("coarseness", &controls.coarseness, 1, largest_coarseness, "1 : %d", clamped);
    help("Pixels of the window each way that share one of the picture");
}

/// A slider that tells whether it was let go with another value.
bool air_slider(const char* label, float& value, float unit, float most, const char* format, Wishes& wishes) {
    float shown = value / unit;
    if (ImGui::DragFloat(label, &shown, most / 500, 1e-3f, most, format, clamped)) {
        value = shown * unit;
        wishes.changed = true;
    }
    return ImGui::IsItemDeactivatedAfterEdit();
}

bool air_sliders(const char* label, airlight::vec3<float>& value, float unit, float most, const char* format,
                 Wishes& wishes) {
    airlight::vec3<float> shown = value / unit;
    if (ImGui::DragFloat3(label, &shown.x, most / 500, 0, most, format, clamped)) {
        value = shown * unit;
        wishes.changed = true;
    }
    return ImGui::IsItemDeactivatedAfterEdit();
}

void air_section(Controls& controls, Wishes& wishes) {
    std::vector<std::string> names;
    int preset = 0;
    for (const World& world : worlds()) {
        if (world.name == controls.world.name) {
            preset = int(names.size());
        }
        names.push_back(world.name);
    }
    if (choice("preset", preset, names)) {
        const int nodes = controls.world.nodes;
        controls.world = worlds()[std::size_t(preset)];
        controls.world.nodes = nodes;
        wishes.changed = wishes.air = true;
    }
    airlight::Atmosphere<float>& a = controls.world.atmosphere;
    ImGui::TextDisabled("Scattered and absorbed in 1000 km, red green blue");
    wishes.air |= air_sliders("molecules", a.rayleigh_scattering, 1e-6f, 200, "%.3f", wishes);
    wishes.air |= air_sliders("aerosol", a.mie_scattering, 1e-6f, 200, "%.3f", wishes);
    wishes.air |= air_sliders("it absorbs", a.mie_absorption, 1e-6f, 200, "%.3f", wishes);
    wishes.air |= air_sliders("ozone", a.ozone_absorption, 1e-6f, 20, "%.3f", wishes);
    ImGui::TextDisabled("Heights in km");
    wishes.air |= air_slider("molecules' scale", a.rayleigh_scale_height, 1e3f, 30, "%.2f", wishes);
    wishes.air |= air_slider("aerosol's scale", a.mie_scale_height, 1e3f, 30, "%.2f", wishes);
    wishes.air |= air_slider("ozone's middle", a.ozone_altitude, 1e3f, 60, "%.2f", wishes);
    wishes.air |= air_slider("ozone's half width", a.ozone_half_width, 1e3f, 30, "%.2f", wishes);
    wishes.air |= air_slider("top", a.top_altitude, 1e3f, 300, "%.1f", wishes);
    wishes.air |= air_slider("ground radius", a.ground_radius, 1e3f, 10000, "%.0f", wishes);
    ImGui::TextDisabled("Without a unit");
    if (ImGui::SliderFloat("aerosol's g", &a.mie_g, -0.95f, 0.95f, "%.3f", clamped)) {
        wishes.changed = true;
    }
    wishes.air |= ImGui::IsItemDeactivatedAfterEdit();
    if (ImGui::ColorEdit3("ground", &a.ground_albedo.x, ImGuiColorEditFlags_Float)) {
        wishes.changed = true;
    }
    wishes.air |= ImGui::IsItemDeactivatedAfterEdit();
    int profile = int(controls.world.lorentzian_ozone);
    if (choice("ozone's profile", profile, {"tent", "lorentzian"})) {
        controls.world.lorentzian_ozone = profile != 0;
        wishes.changed = wishes.air = true;
    }
}

void method_section(Controls& controls, const Status& status, Wishes& wishes) {
    int tables = int(controls.tables);
    if (choice("tables", tables, table_names())) {
        controls.tables = TableKind(tables);
        wishes.changed = wishes.air = true;
    }
    help("Where light beyond single scattering comes from");
    if (status.baked) {
        ImGui::ProgressBar(float(*status.baked), ImVec2(-FLT_MIN, 0), "baking tables");
    }
    std::vector<std::string> counts;
    int chosen = 0;
    for (const int nodes : node_counts()) {
        if (nodes == controls.world.nodes) {
            chosen = int(counts.size());
        }
        counts.push_back(std::to_string(nodes));
    }
    if (choice("nodes", chosen, counts)) {
        controls.world.nodes = node_counts()[std::size_t(chosen)];
        wishes.changed = true;
    }
    help("Samples in each lit piece of a ray; the shaders are compiled with them");
    wishes.changed |= ImGui::Checkbox("marched, by even steps", &controls.marched);
    ImGui::BeginDisabled(!controls.marched);
    wishes.changed |= ImGui::SliderInt("steps", &controls.steps, 1, 1000, "%d", logarithmic);
    wishes.changed |= ImGui::SliderInt("steps to the sky", &controls.sky_steps, 1, 1000, "%d", logarithmic);
    ImGui::EndDisabled();
}

void switch_section(Controls& controls, Wishes& wishes) {
    for (const Switch& s : switches_of(controls.settings)) {
        if (ImGui::Checkbox(label_of(s.option).c_str(), s.value)) {
            wishes.changed = wishes.rebuild = true;
        }
        help(s.help);
    }
    if (controls.settings.moon) {
        wishes.changed |= slider("moon's elevation", controls.settings.moon_elevation, -90, 90, "%.1f deg");
        wishes.changed |= slider("moon's azimuth", controls.settings.moon_azimuth, 0, 360, "%.1f deg");
    }
    wishes.changed |= ImGui::Checkbox("glint after Phong", &controls.settings.phong);
    wishes.changed |= ImGui::Checkbox("ground after Lommel and Seeliger", &controls.settings.lommel_seeliger);
    int shafts = int(controls.settings.shafts);
    if (choice("light shafts", shafts, shaft_names())) {
        controls.settings.shafts = Shafts(shafts);
        wishes.changed = wishes.rebuild = true;
    }
    for (const Count& count : counts_of(controls.settings)) {
        ImGui::SliderInt(label_of(count.option).c_str(), count.value, count.least, count.slider_most, "%d",
                         clamped);
        wishes.rebuild |= ImGui::IsItemDeactivatedAfterEdit();
        help(count.help);
    }
}

void compare_section(Controls& controls, const Status& status, Wishes& wishes) {
    int reference = int(controls.reference);
    if (choice("with", reference, {"nothing", "24 nodes, 800 steps", "the CPU"})) {
        controls.reference = Reference(reference);
        wishes.changed = true;
    }
    if (controls.reference == Reference::none) {
        return;
    }
    const DifferenceScale scale = scale_of(controls.reference);
    const ImVec4 colors[] = {{0.4f, 0.4f, 1, 1}, {0, 1, 0, 1}, {1, 0.3f, 0.3f, 1}, {1, 1, 1, 1}};
    const char* const names[] = {"blue", "green", "red", "white"};
    for (int i = 0; i < 4; ++i) {
        if (i > 0) {
            ImGui::SameLine();
        }
        ImGui::TextColored(colors[i], "%s 1e%g", names[i], double(scale.blue_at + float(i) * scale.decades));
    }
    ImGui::TextWrapped("%s", status.reference.c_str());
}

void time_section(const Status& status) {
    double sum = 0;
    for (const PassTime& pass : status.times) {
        ImGui::Text("%-14s %8.3f ms", pass.name.c_str(), pass.milliseconds);
        sum += pass.milliseconds;
    }
    ImGui::Text("%-14s %8.3f ms", "sum", sum);
}

void keys_section() {
    ImGui::TextUnformatted(
        "drag       sun: time of day, height\n"
        "right drag look around\n"
        "wheel      angle of view\n"
        "W A S D    fly; Q E down and up\n"
        "shift      faster, ctrl slower\n"
        "1 to 5     the named cameras\n"
        "space      ride into space\n"
        "M          moving sun\n"
        "F1         this panel\n"
        "F5         read the shaders again\n"
        "F12        screenshot, PNG and EXR");
}

}  // namespace

DifferenceScale scale_of(Reference reference) {
    return reference == Reference::cpu ? DifferenceScale{-8, 2} : DifferenceScale{-4, 1};
}

Wishes draw_panel(Controls& controls, const Status& status) {
    Wishes wishes;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    if (!status.error.empty()) {
        ImGui::SetNextWindowPos(ImVec2(display.x, display.y), ImGuiCond_Always, ImVec2(1, 1));
        ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(0.9f * display.x, 0.9f * display.y));
        ImGui::Begin("The shaders do not compile; the last ones that did go on", nullptr,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_HorizontalScrollbar);
        ImGui::TextUnformatted(status.error.c_str());
        ImGui::End();
    }
    if (!controls.panel) {
        return wishes;
    }
    // Always along the left edge: a window that was small for a while must not push it out.
    const float width = std::min(340 * std::max(ImGui::GetIO().FontGlobalScale, 1.0f), 0.5f * display.x);
    ImGui::SetNextWindowPos(ImVec2(4, 4));
    ImGui::SetNextWindowSize(ImVec2(width, std::max(display.y - 8, 1.0f)));
    if (ImGui::Begin("airlight", nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize)) {
        ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
        ImGui::TextWrapped("%.1f frames/s, %d x %d", 1 / std::max(status.frame_seconds, 1e-6), status.width,
                           status.height);
        if (!status.note.empty()) {
            ImGui::TextWrapped("%s", status.note.c_str());
        }
        const auto section = [](const char* title, bool open) {
            return ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
        };
        if (section("Sun", true)) {
            sun_section(controls, wishes);
        }
        if (section("Camera", true)) {
            camera_section(controls, status, wishes);
        }
        if (section("Picture", true)) {
            picture_section(controls, wishes);
        }
        if (section("Air", false)) {
            air_section(controls, wishes);
        }
        if (section("Method", true)) {
            method_section(controls, status, wishes);
        }
        if (section("Switches and shafts", false)) {
            switch_section(controls, wishes);
        }
        if (section("Compare", false)) {
            compare_section(controls, status, wishes);
        }
        if (section("GPU time", false)) {
            time_section(status);
        }
        if (section("Keep", false)) {
            wishes.copy_cpp = ImGui::Button("copy as C++");
            ImGui::SameLine();
            wishes.copy_glsl = ImGui::Button("copy as GLSL");
            wishes.screenshot = ImGui::Button("screenshot");
            ImGui::SameLine();
            wishes.reload = ImGui::Button("reload shaders");
        }
        if (section("Keys", false)) {
            keys_section();
            ImGui::TextDisabled("%s", status.driver.c_str());
        }
        ImGui::PopItemWidth();
    }
    ImGui::End();
    return wishes;
}

}  // namespace deferred
