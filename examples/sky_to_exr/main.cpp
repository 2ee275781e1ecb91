// A whole sky on the CPU: an equirectangular panorama as OpenEXR (radiance) and PNG (exposed).
#include <CLI/CLI.hpp>
#include <airlight/airlight.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "support/error.hpp"
#include "support/image.hpp"
#include "support/parallel.hpp"

using vec3 = airlight::vec3<float>;

// What the eye sees: the air, before space or before the sunlit ground sphere [1/sr].
static vec3 panorama_radiance(const airlight::Atmosphere<float>& atmosphere,
                              const airlight::Viewpoint<float>& eye, const vec3& direction,
                              const vec3& to_sun) {
    const float anywhere = airlight::no_surface<float>();
    const airlight::ViewPath<float> path = airlight::view_path(atmosphere, eye, direction, anywhere);
    vec3 ground(0);
    if (path.reaches_ground) {
        const vec3 position = eye.altitude * eye.up + direction * path.end;
        const airlight::Viewpoint<float> there =
            airlight::viewpoint_from_surface(atmosphere.ground_radius, position, eye.up);
        const float mu_s = glm::clamp(glm::dot(there.up, to_sun), -1.0f, 1.0f);
        ground = atmosphere.ground_albedo / airlight::pi<float> * glm::max(mu_s, 0.0f) *
                 airlight::transmittance_to_space(atmosphere, 0.0f, mu_s);
    }
    const airlight::Scattered<float> air =
        airlight::single_scattering(atmosphere, eye, direction, to_sun, anywhere);
    return airlight::compose(ground, air, vec3(1));
}

static void render(int width, float sun_elevation, float altitude, const std::string& preset, float exposure,
                   const std::string& output) {
    using Make = airlight::Atmosphere<float> (*)();
    const std::map<std::string, Make> presets = {{"earth", airlight::earth<float>},
                                                 {"cs562", airlight::cs562_earth<float>},
                                                 {"elek", airlight::elek_earth<float>},
                                                 {"mars", airlight::mars<float>}};
    const airlight::Atmosphere<float> atmosphere = presets.at(preset)();
    const airlight::Viewpoint<float> eye{altitude, vec3(0, 0, 1)};
    const float degree = airlight::pi<float> / 180;
    const vec3 to_sun(0, std::cos(sun_elevation * degree), std::sin(sun_elevation * degree));

    // Azimuth from -180 to 180 degrees around the sun, from the zenith in the top row to the nadir.
    const int height = width / 2;
    const std::size_t count = std::size_t(width) * std::size_t(height);
    support::ExrImage image{
        width, height, {}, {{"units", "1/sr: radiance per solar irradiance above the air"}}};
    for (const char* name : {"R", "G", "B"}) {
        image.channels.push_back({name, std::vector<float>(count)});
    }
    support::Picture picture{width, height, std::vector<std::uint8_t>(3 * count)};
    support::for_each_row(height, [&](int y) {
        const float elevation = (90 - (float(y) + 0.5f) * 180 / float(height)) * degree;
        for (int x = 0; x < width; ++x) {
            const float azimuth = ((float(x) + 0.5f) * 360 / float(width) - 180) * degree;
            const vec3 direction(std::cos(elevation) * std::sin(azimuth),
                                 std::cos(elevation) * std::cos(azimuth), std::sin(elevation));
            const vec3 radiance = panorama_radiance(atmosphere, eye, direction, to_sun);
            const vec3 display = airlight::srgb_from_linear(airlight::exposed(radiance, exposure));
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            for (int c = 0; c < 3; ++c) {
                image.channels[std::size_t(c)].pixels[i] = radiance[c];
                picture.pixels[3 * i + std::size_t(c)] = std::uint8_t(255 * display[c] + 0.5f);
            }
        }
    });
    support::write_exr(output + ".exr", image);
    support::write_png(output + ".png", picture);
    std::cout << output << ".exr and " << output << ".png: " << width << " x " << height << "\n";
}

int main(int argc, char** argv) {
    int size = 512;
    float sun_elevation = 30, altitude = 2, exposure = 15;
    std::string preset = "earth", output = "sky";
    CLI::App app("Writes a panorama of the sky as OpenEXR (radiance) and PNG (exposed by 1 - exp(-kx)).");
    app.add_option("--size", size, "Width in pixels; the height is half of it")->check(CLI::Range(2, 8192));
    app.add_option("--sun-elevation", sun_elevation, "[degrees]")->check(CLI::Range(-90.0, 90.0));
    app.add_option("--altitude", altitude, "Of the eye [m]")->check(CLI::Range(0.0, 1e9));
    app.add_option("--preset", preset)->check(CLI::IsMember({"earth", "cs562", "elek", "mars"}));
    app.add_option("--exposure", exposure, "The k of the PNG")->check(CLI::Range(0.0, 1e9));
    app.add_option("--output", output, "Path of both files, without .exr and .png");
    try {
        app.parse(argc, argv);
        render(size, sun_elevation, altitude, preset, exposure, output);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
    } catch (const std::exception& error) {
        std::cerr << "sky_to_exr: " << error.what() << "\n";
        return 1;
    }
}
