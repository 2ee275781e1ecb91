#include "table.hpp"

#include <sstream>

#include "support/files.hpp"
#include "support/rows.hpp"

namespace reference {

void write_table(const support::Preset& preset, double sun_diameter, const Effort& effort,
                 const std::filesystem::path& path) {
    support::make_writable_directory_of(path);
    const std::vector<View> views = judged_views();
    std::vector<Radiance> radiances(3 * views.size());
    const support::Rows jobs("tracing " + preset.name);
    jobs(static_cast<int>(radiances.size()), [&](int job) {
        const auto i = static_cast<std::size_t>(job);
        const Air air(preset.air, preset.ozone, job % 3);
        Effort own = effort;
        own.seed = effort.seed + 1000003 * i;  // or all would be off the same way
        radiances[i] = traced(air, views[i / 3], sun_diameter, own);
    });

    std::ostringstream out;
    out.precision(7);
    out << "# Radiance that the air of '" << preset.name
        << "' adds to a view ray, all orders of scattering, light off the ground included [1/sr] per unit "
           "of\n"
        << "# solar irradiance above the air. Written by path_trace --table: " << effort.walks
        << " walks a channel, seed " << effort.seed << ", sun " << sun_diameter
        << " degrees wide. Angles in degrees.\n"
        << "altitude,sun_elevation,elevation,azimuth,channel,total,total_error,order_1_error";
    for (int k = 1; k < kept_orders; ++k) {
        out << ",order_" << k;
    }
    out << ",order_" << kept_orders << "_and_more\n";
    for (std::size_t i = 0; i < radiances.size(); ++i) {
        const View& view = views[i / 3];
        const Radiance& radiance = radiances[i];
        out << view.altitude << "," << view.sun_elevation << "," << view.elevation << "," << view.azimuth
            << "," << i % 3 << "," << radiance.total.mean << "," << radiance.total.error << ","
            << radiance.order[0].error;
        for (const Estimate& order : radiance.order) {
            out << "," << order.mean;
        }
        out << "\n";
    }
    support::write_file(path, out.str());
}

void write_irradiance_table(const support::Preset& preset, const Effort& effort,
                            const std::filesystem::path& path) {
    support::make_writable_directory_of(path);
    const std::vector<double> suns = {60, 40, 20, 10, 5, 2, 0, -1.5, -3, -4.5, -6};
    std::vector<Estimate> irradiances(3 * suns.size());
    const support::Rows jobs("irradiance of " + preset.name);
    jobs(static_cast<int>(irradiances.size()), [&](int job) {
        const auto i = static_cast<std::size_t>(job);
        Light light;
        light.to_sun = direction_at(suns[i / 3]);
        Effort own = effort;
        own.seed = effort.seed + 1000003 * i;
        irradiances[i] = sky_irradiance(Air(preset.air, preset.ozone, job % 3), light, own);
    });

    std::ostringstream out;
    out.precision(7);
    out << "# Irradiance of level ground by the sky of '" << preset.name
        << "', all orders of scattering, light off the ground included, without the sun\n"
        << "# itself, per unit of solar irradiance above the air. Written by path_trace --irradiance: "
        << effort.walks << " walks a channel, seed " << effort.seed << ". Angles in degrees.\n"
        << "sun_elevation,channel,irradiance,error\n";
    for (std::size_t i = 0; i < irradiances.size(); ++i) {
        out << suns[i / 3] << "," << i % 3 << "," << irradiances[i].mean << "," << irradiances[i].error
            << "\n";
    }
    support::write_file(path, out.str());
}

}  // namespace reference
