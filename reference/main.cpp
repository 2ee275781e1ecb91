// Traces light through the air: every order of scattering, by chance, until it is known well enough.

#include <cstdio>
#include <filesystem>
#include <string>

#include "picture.hpp"
#include "support/command_line.hpp"
#include "support/parallel.hpp"
#include "table.hpp"

namespace {

void print_view(const support::Preset& preset, const reference::View& view, double sun_diameter,
                const reference::Effort& effort) {
    std::array<reference::Radiance, 3> radiance;
    support::for_each_row(3, [&](int channel) {
        const reference::Air air(preset.air, preset.ozone, channel);
        radiance[static_cast<std::size_t>(channel)] = traced(air, view, sun_diameter, effort);
    });
    std::printf("%s: %s, %llu walks a channel\n\n", preset.name.c_str(), view.name().c_str(),
                static_cast<unsigned long long>(effort.walks));
    const auto line = [&](const std::string& label, auto estimate) {
        std::printf("%-16s", label.c_str());
        for (const reference::Radiance& channel : radiance) {
            const reference::Estimate value = estimate(channel);
            std::printf("  %12.6g +- %-8.2g", value.mean, value.error);
        }
        std::printf("\n");
    };
    std::printf("%-16s  %-24s  %-24s  %-24s\n", "[1/sr]", "red", "green", "blue");
    line("all orders", [](const reference::Radiance& r) { return r.total; });
    for (std::size_t k = 0; k < reference::kept_orders; ++k) {
        const bool last = k + 1 == reference::kept_orders;
        line((last ? "from order " : "order ") + std::to_string(k + 1),
             [&](const reference::Radiance& r) { return r.order[k]; });
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Follows light through the air of a planet, backwards from the eye, every order of scattering, and "
        "says\n"
        "how far off it may be. Prints one view, or writes a table of views or a panorama. Radiance is that "
        "of\n"
        "the air alone, per unit of solar irradiance above it.",
        "path_trace");
    std::string atmosphere = "earth";
    std::string table;
    std::string picture;
    std::string irradiance;
    reference::View view;
    reference::Effort effort;
    double sun_diameter = 0;
    int width = 128;
    support::add_value(app, "--atmosphere", "<name>", atmosphere, "earth, cs562, elek, leenman or mars");
    support::add_value(app, "--altitude", "<metres>", view.altitude, "of the eye (default 2)")
        ->check(CLI::Range(0.0, 1e9));
    support::add_value(app, "--sun", "<degrees>", view.sun_elevation, "over the horizontal (default 30)")
        ->check(CLI::Range(-90.0, 90.0));
    support::add_value(app, "--elevation", "<degrees>", view.elevation, "of the view (default 90)")
        ->check(CLI::Range(-90.0, 90.0));
    support::add_value(app, "--azimuth", "<degrees>", view.azimuth, "of the view, from the sun's (default 0)")
        ->check(CLI::Range(-360.0, 360.0));
    support::add_value(app, "--sun-diameter", "<degrees>", sun_diameter,
                       "of its disc; the sun's is 0.53 (default 0)")
        ->check(CLI::Range(0.0, 180.0));
    CLI::Option* const walks = support::add_value(app, "--walks", "<count>", effort.walks,
                                                  "a channel and view (default 1000000; 2000 in a picture)")
                                   ->check(CLI::Range(100.0, 1e12));
    support::add_value(app, "--seed", "<number>", effort.seed, "another one gives another error (default 1)");
    support::add_value(app, "--orders", "<count>", effort.orders, "of scattering to follow (default all)")
        ->check(CLI::Range(1, 1000000));
    CLI::Option* const into_table =
        support::add_value(app, "--table", "<file.csv>", table, "traces 66 views instead, into this file");
    support::add_value(app, "--picture", "<file.exr>", picture, "traces a panorama instead, into this file")
        ->excludes(into_table);
    support::add_value(app, "--irradiance", "<file.csv>", irradiance,
                       "traces what the sky sheds on the ground instead, into this file")
        ->excludes(into_table);
    support::add_value(app, "--width", "<pixels>", width, "of the picture; its height is half (default 128)")
        ->check(CLI::Range(2, 8192));
    return support::guarded_main(app, argc, argv, [&] {
        const support::Preset preset = support::preset(atmosphere);
        if (!table.empty()) {
            write_table(preset, sun_diameter, effort, table);
            std::printf("%s: %zu views\n", table.c_str(), reference::judged_views().size());
        } else if (!irradiance.empty()) {
            write_irradiance_table(preset, effort, irradiance);
            std::printf("%s\n", irradiance.c_str());
        } else if (!picture.empty()) {
            if (walks->count() == 0) {
                effort.walks = 2000;
            }
            effort.groups = 20;
            write_picture(preset, view, sun_diameter, width, effort, picture);
            std::printf("%s: %d x %d\n", picture.c_str(), width, width / 2);
        } else {
            print_view(preset, view, sun_diameter, effort);
        }
        return 0;
    });
}
