#include "habitat/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "by_name.hpp"
#include "option_values.hpp"

#ifndef DEFERRED_HEIGHT_MAP
#error "DEFERRED_HEIGHT_MAP is not defined"
#endif

namespace deferred::habitat {
namespace {

constexpr double gas_constant = 287.05;  // [J/(kg K)] of dry air

/// Around the ends of the strips a table is finer, as in rama_lights as far as there is room.
void set_table_stretches(airlight::HabitatLights<float>& lights) {
    const float half = lights.half_length;
    const float gap = lights.end - lights.begin;
    lights.fine = std::min({half / 120, 0.5f * lights.begin, 0.25f * gap, 0.5f * (half - lights.end)});
    lights.fine_share = std::min(
        {1.0f / 12, 0.5f * lights.begin / half, 0.25f * gap / half, 0.5f * (half - lights.end) / half});
}

}  // namespace

std::optional<Options> parse_options(int count, char** arguments) {
    CLI::App app(
        "Renders the inside of a spinning cylinder: land on its wall, six strips of light, and the air that\n"
        "the spin presses to the wall; and computes the same light on the CPU to compare. Writes an OpenEXR\n"
        "file and a PNG for each camera. Radiance is in units of the strips' own.");
    app.set_help_flag("--help", "Print this and stop");

    const airlight::HabitatAir<double> air = airlight::rama_air<double>();
    const airlight::HabitatLights<double> lights = airlight::rama_lights<double>();
    std::string scene;
    std::vector<std::string> camera_names;
    std::optional<double> along;
    std::optional<double> around;
    std::optional<double> height;
    std::optional<double> heading;
    std::optional<double> pitch;
    std::optional<double> fov;
    std::string size = "640x360";
    double radius = air.radius / 1e3;
    double half_length = lights.half_length / 1e3;
    std::vector<double> strips = {lights.begin / 1e3, lights.end / 1e3};
    double width = lights.width;
    double gravity = 9.81;
    double temperature = 288.15;
    double haze = 1;
    std::vector<double> albedo = {0.12, 0.13, 0.07};
    std::string air_light = "phase";
    std::string land = "hills";
    std::vector<double> steps_of_map = {74, 93};
    std::string exposure = "auto";
    bool headless = false;
    Options options{};
    options.world.bounces = 2;
    options.height_map = DEFERRED_HEIGHT_MAP;
    options.output = ".";

    app.add_option("--scene", scene, "habitat: this; planet has other options");
    app.add_option("--camera", camera_names,
                   "One or several of " + names(named_cameras()) + "; axis if none is given");
    app.add_option("--along", along, "Camera along the axis, from the middle [km]");
    app.add_option("--around", around, "Camera about the axis, from a strip of light [degrees]");
    app.add_option("--height", height, "Camera above the land [m]");
    app.add_option("--heading", heading, "View direction, from along the axis to spinward [degrees]");
    app.add_option("--pitch", pitch, "View direction up from the horizontal [degrees]");
    app.add_option("--fov", fov, "Angle of view from the lower to the upper edge [degrees]");
    app.add_option("--size", size, "Picture size, WxH; 640x360 if not given");
    app.add_option("--radius", radius, "Of the cylinder [km]; 8 if not given");
    app.add_option("--half-length", half_length, "From its middle to its caps [km]; 24 if not given");
    app.add_option("--strips", strips,
                   "Where the strips of light begin and end, from the middle [km]; 5 16 if not given")
        ->expected(2);
    app.add_option("--strip-width", width, "Of each strip [m]; 100 if not given");
    app.add_option("--gravity", gravity, "Of the spin, at the wall [m/s2]; 9.81 if not given");
    app.add_option("--temperature", temperature, "Of the air [K]; 288.15 if not given");
    app.add_option("--haze", haze, "Factor of the aerosol's coefficients; 1 if not given");
    app.add_option(
           "--air-light", air_light,
           "How the air's light comes from the strips: phase, with phase functions and no table; nodes, "
           "evenly to all sides by a table of what passes; marched, in 30 steps through a table of that "
           "light; phase if not given")
        ->check(CLI::IsMember(air_light_names()));
    app.add_option("--bounces", options.world.bounces,
                   "Of light off the walls and in the air, by a table; 0 for none, 2 if not given");
    app.add_option("--wall-albedo", albedo,
                   "Red, green and blue of the land in the mean, for light that bounces; "
                   "0.12 0.13 0.07 if not given")
        ->expected(3);
    app.add_option("--land", land,
                   "hills, by the height map, or plain, of one colour and flat; hills if not given")
        ->check(CLI::IsMember({"hills", "plain"}));
    std::vector<Switch> switches = {
        {"--air", "The air, its light and what it takes from light", &options.settings.air},
        {"--bloom", "A share of the light spreads in the PNG, as in an eye", &options.settings.bloom},
        {"--use-exposure", "1 - exp(-exposure x) in the PNG, else exposure x cut at 1",
         &options.settings.use_exposure},
        {"--use-gamma", "The PNG encoded as sRGB, else linear", &options.settings.use_gamma},
        {"--difference", "Compute the light on the CPU too and compare", &options.difference},
    };
    options.difference = true;
    for (Switch& s : switches) {
        s.word = *s.value ? "on" : "off";
        app.add_option(s.option, s.word, s.help + ": on or off; " + s.word + " if not given")
            ->check(CLI::IsMember({"on", "off"}));
    }
    app.add_option("--truth", options.truth,
                   "Walks a pixel and colour of a path tracer, which draws the same picture beside it; with "
                   "bounces all orders of light, else light scattered once; none if not given");
    app.add_option("--heightmap", options.height_map,
                   "Grey PNG (16 bits, a metre a level) or OpenEXR file (metres)");
    app.add_option("--heightmap-step", steps_of_map, "Its grid step east and north [m]; 74 93 if not given")
        ->expected(2);
    app.add_flag("--headless", headless, "Without a window; this scene has none")->disable_flag_override();
    app.add_flag("--times", options.times, "Print how long each pass kept the GPU");
    app.add_option("--shaders", options.shaders,
                   "Folder of this example's shaders, to try changed copies; the sources' own if not given");
    app.add_option("--output", options.output, "Folder of the pictures, made if missing; here if not given");
    app.add_option(
        "--exposure", exposure,
        "Factor before 1 - exp(-x), or auto, which follows each picture's mean; auto if not given");
    app.add_option("--tolerance", options.tolerance,
                   "Fail when the largest relative difference is above this");
    try {
        app.parse(count, arguments);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        refuse_option(std::string(error.what()) + " in the habitat");
    }

    parse_size("--size", size, options.width, options.height);
    require_range("--radius", radius, 0.1, 1e3);
    require_range("--half-length", half_length, 0.1, 1e4);
    require_range("--strips", strips[0], 1e-3 * half_length, half_length);
    require_range("--strips", strips[1], strips[0] + 1e-3 * half_length, 0.999 * half_length);
    require_range("--strip-width", width, 1e-3 * radius, 200 * radius);  // to a fifth of the radius
    require_range("--gravity", gravity, 0, 1e3);
    require_range("--temperature", temperature, 10, 1e4);
    require_range("--haze", haze, 0, 100);
    require_range("--bounces", options.world.bounces, 0, 100);
    require_range("--truth", options.truth, 0, 1e6);
    for (const double a : albedo) {
        require_range("--wall-albedo", a, 0, 1);
    }
    options.step_east = steps_of_map[0];
    options.step_north = steps_of_map[1];
    require_range("--heightmap-step", options.step_east, 10, 1000);
    require_range("--heightmap-step", options.step_north, 10, 1000);
    if (exposure != "auto") {
        options.exposure = float(parse_exposure(exposure));
    }
    for (const Switch& s : switches) {
        *s.value = s.word == "on";
    }
    if (options.tolerance) {
        require_range("--tolerance", *options.tolerance, 0, 1e6);
        if (!options.difference) {
            refuse_option("--tolerance needs --difference on");
        }
    }

    World& world = options.world;
    world.air = airlight::rama_air<float>();
    world.air.radius = float(1e3 * radius);
    world.air.density_rise = float(airlight::spun_density_rise(
        airlight::spin_for_gravity(1e3 * radius, gravity), gas_constant, temperature));
    world.air.mie_scattering *= float(haze);
    world.air.mie_absorption *= float(haze);
    if (!options.settings.air) {
        world.air.rayleigh_scattering = world.air.mie_scattering = world.air.mie_absorption = vec3(0);
    }
    world.lights = airlight::rama_lights<float>();
    world.lights.half_length = float(1e3 * half_length);
    world.lights.begin = float(1e3 * strips[0]);
    world.lights.end = float(1e3 * strips[1]);
    world.lights.width = float(width);
    set_table_stretches(world.lights);
    world.wall_albedo = vec3(airlight::vec3<double>(albedo[0], albedo[1], albedo[2]));
    world.air_light = AirLight(std::find(air_light_names().begin(), air_light_names().end(), air_light) -
                               air_light_names().begin());
    options.plain = land == "plain";

    if (camera_names.empty()) {
        camera_names = {"axis"};
    }
    for (const std::string& name : camera_names) {
        Camera camera = by_name(named_cameras(), name, "camera of the habitat");
        camera.along = along ? *along * 1e3 : camera.along * half_length * 1e3 / lights.half_length;
        camera.around = around.value_or(camera.around);
        camera.height = height.value_or(camera.height * radius * 1e3 / air.radius);
        camera.heading = heading.value_or(camera.heading);
        camera.pitch = pitch.value_or(camera.pitch);
        camera.field_of_view = fov.value_or(camera.field_of_view);
        require_range("--along", camera.along / 1e3, -0.999 * half_length, 0.999 * half_length);
        require_range("--around", camera.around, -360, 360);
        require_range("--height", camera.height, 0.2, 2e3 * radius);
        require_range("--heading", camera.heading, -360, 360);
        require_range("--pitch", camera.pitch, -90, 90);
        require_range("--fov", camera.field_of_view, 0.1, 150);
        options.cameras.push_back(camera);
    }
    return options;
}

}  // namespace deferred::habitat
