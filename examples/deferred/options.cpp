#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "by_name.hpp"
#include "option_values.hpp"
#include "support/error.hpp"

#ifndef DEFERRED_HEIGHT_MAP
#error "DEFERRED_HEIGHT_MAP is not defined"
#endif

namespace deferred {
namespace {

// North is not defined further from the landscape than a quarter of the planet.
constexpr double largest_offset_km = 3000;
constexpr int most_frames = 10000;  // four digits

}  // namespace

bool asks_for_habitat(int count, char** arguments) {
    std::string scene;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        if (argument == "--scene" && i + 1 < count) {
            scene = arguments[i + 1];
        } else if (argument.rfind("--scene=", 0) == 0) {
            scene = argument.substr(8);
        }
    }
    return scene == scene_names()[1];
}

std::optional<Options> parse_options(int count, char** arguments) {
    CLI::App app(
        "Renders a real landscape on a planet in its air, by OpenGL without a window, and computes the same\n"
        "light on the CPU to compare. Writes an OpenEXR file and a PNG for each camera and sun elevation.\n"
        "Or, with --window, lets you fly through it.");
    app.set_help_flag("--help", "Print this and stop");

    std::vector<std::string> camera_names;
    std::vector<double> sun_elevations = {20};
    std::vector<double> steps_of_map = {74, 93};
    std::string size = "640x360";
    std::vector<std::string> window_sizes;
    std::string preset = "earth";
    std::string scene;
    std::string exposure = "auto";
    std::string shafts = "none";
    std::string glint = "microfacets";
    std::string ground = "lambert";
    std::optional<double> east;
    std::optional<double> north;
    std::optional<double> altitude;
    std::optional<double> height;
    std::optional<double> heading;
    std::optional<double> pitch;
    std::optional<double> fov;
    double haze = 1;
    std::string method = "nodes";
    std::string tables = "diffuse";
    Options options{};
    options.sun_azimuth = 250;
    options.steps = 40;
    options.sky_steps = 12;
    options.height_map = DEFERRED_HEIGHT_MAP;
    options.output = ".";
    options.coarseness = 1;
    options.frames = 100;
    options.latitude = 36.3;
    bool headless = false;
    std::string sequence;

    app.add_option("--scene", scene,
                   "planet, or habitat: the inside of a cylinder with lights of its own, see --scene habitat "
                   "--help; planet if not given")
        ->check(CLI::IsMember(scene_names()));
    app.add_flag("--window", options.window,
                 "Open a window on the first camera and sun; it says there which keys do what");
    app.add_option("--coarseness", options.coarseness,
                   "Pixels of the window each way that share one of the picture; 1 if not given");
    app.add_option("--screenshot", options.screenshot,
                   "PNG of the window in the last of its --frames, panel and all");
    app.add_option("--window-sizes", window_sizes,
                   "Sizes, WxH, that the window takes one after another in its --frames");
    app.add_flag("--times", options.times, "Print how long each pass kept the GPU");
    app.add_option("--nodes", options.world.nodes,
                   "Samples in each lit piece of a ray: 4, 5, 6, 8, 10, 12, 16 or 24; 8 if not given")
        ->check(CLI::IsMember(node_counts()));
    app.add_option("--camera", camera_names,
                   "One or several of " + names(named_cameras()) + "; ground if none is given");
    app.add_option("--east", east, "Camera east of the landscape's centre [km]");
    app.add_option("--north", north, "Camera north of the landscape's centre [km]");
    app.add_option("--altitude", altitude, "Camera above the ground sphere [m]");
    app.add_option("--height", height, "Camera above the landscape [m], instead of --altitude");
    app.add_option("--heading", heading, "View direction clockwise from north [degrees]");
    app.add_option("--pitch", pitch, "View direction up from the horizontal [degrees]");
    app.add_option("--fov", fov, "Angle of view from the lower to the upper edge [degrees]");
    app.add_option("--sun-elevation", sun_elevations,
                   "Sun above the horizontal under the camera [degrees], one or several; 20 if not given");
    app.add_option("--sun-azimuth", options.sun_azimuth,
                   "Sun clockwise from north [degrees]; 250 if not given");
    app.add_option("--moon-elevation", options.settings.moon_elevation,
                   "Moon above the horizontal under the camera [degrees]; 35 if not given");
    app.add_option("--moon-azimuth", options.settings.moon_azimuth,
                   "Moon clockwise from north [degrees]; 120 if not given");
    app.add_option(
           "--method", method,
           "Light of the air: nodes, a few samples where the light is, or marched, by even steps; nodes "
           "if not given")
        ->check(CLI::IsMember({"nodes", "marched"}));
    app.add_option(
           "--tables", tables,
           "Light beyond single scattering: none, or from a table: diffuse (light from all sides, tiny), "
           "hillaire, inscatter3d, bruneton; transmittance only speeds up the march. diffuse if not given")
        ->check(CLI::IsMember(table_names()));
    app.add_option("--steps", options.steps, "Even steps along a view ray when marched; 40 if not given");
    app.add_option("--sky-steps", options.sky_steps,
                   "Even steps up from a surface, for its skylight, when marched; 12 if not given");
    app.add_option(
           "--shafts", shafts,
           "Light shafts: none; march, by looks at the shadow maps along each ray; epipolar, by rays in half "
           "planes through the sun; reference, in 800 even steps; none if not given")
        ->check(CLI::IsMember(shaft_names()));
    std::vector<Count> counts = counts_of(options.settings);
    for (const Count& count_option : counts) {
        app.add_option(count_option.option, *count_option.value,
                       count_option.help + "; " + std::to_string(*count_option.value) + " if not given");
    }
    std::vector<Switch> switches = switches_of(options.settings);
    switches.push_back({"--difference", "Compute the light on the CPU too and compare", &options.difference});
    options.difference = true;
    for (Switch& s : switches) {
        s.word = *s.value ? "on" : "off";
        app.add_option(s.option, s.word, s.help + ": on or off; " + s.word + " if not given")
            ->check(CLI::IsMember({"on", "off"}));
    }
    app.add_option("--glint", glint,
                   "Sunlight that surfaces mirror: microfacets or phong; microfacets if not given")
        ->check(CLI::IsMember({"microfacets", "phong"}));
    app.add_option("--ground", ground,
                   "How ground scatters light: lambert or lommel-seeliger; lambert if not given")
        ->check(CLI::IsMember({"lambert", "lommel-seeliger"}));
    app.add_option("--size", size, "Picture size, WxH; 640x360 if not given");
    app.add_option("--preset", preset, "Atmosphere, one of " + names(worlds()) + "; earth if not given");
    app.add_option("--haze", haze, "Factor of the aerosol's coefficients; 1 if not given");
    app.add_option("--heightmap", options.height_map,
                   "Grey PNG (16 bits, a metre a level) or OpenEXR file (metres), north up");
    app.add_option("--heightmap-step", steps_of_map, "Its grid step east and north [m]; 74 93 if not given")
        ->expected(2);
    app.add_flag("--headless", headless, "Without a window, which is so when --window is not given")
        ->disable_flag_override();
    app.add_option("--sequence", sequence,
                   "Instead of single pictures a sequence of PNGs: flight (from 1 m to 1e8 m), day (24 hours "
                   "at an equinox) or turntable (once around)")
        ->check(CLI::IsMember(sequence_names()));
    app.add_option("--frames", options.frames,
                   "Pictures of the sequence, 100 if not given, or of a window before it closes");
    app.add_option(
        "--latitude", options.latitude,
        "Where the day passes, or the window's sun, north of the equator [degrees]; 36.3 if not given");
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
        refuse_option(error.what());
    }

    parse_size("--size", size, options.width, options.height);
    for (const std::string& text : window_sizes) {
        options.window_sizes.emplace_back();
        parse_size("--window-sizes", text, options.window_sizes.back().first,
                   options.window_sizes.back().second);
    }
    const int nodes = options.world.nodes;
    options.world = by_name(worlds(), preset, "preset");
    options.world.nodes = nodes;
    require_range("--haze", haze, 0, 100);
    options.world.atmosphere.mie_scattering *= float(haze);
    options.world.atmosphere.mie_absorption *= float(haze);
    if (camera_names.empty()) {
        camera_names = {"ground"};
    }
    if (altitude && height) {
        refuse_option("--altitude and --height both say how high the camera is; give one");
    }
    for (const std::string& name : camera_names) {
        Camera camera = by_name(named_cameras(), name, "camera");
        camera.east = east ? *east * 1e3 : camera.east;
        camera.north = north ? *north * 1e3 : camera.north;
        camera.heading = heading.value_or(camera.heading);
        camera.pitch = pitch.value_or(camera.pitch);
        camera.field_of_view = fov.value_or(camera.field_of_view);
        if (altitude || height) {
            camera.above_landscape = height.has_value();
            camera.altitude = height.value_or(altitude.value_or(0));
        }
        require_range("--east", camera.east / 1e3, -largest_offset_km, largest_offset_km);
        require_range("--north", camera.north / 1e3, -largest_offset_km, largest_offset_km);
        require_range(height ? "--height" : "--altitude", camera.altitude, -1e5, 1e9);
        require_range("--heading", camera.heading, -360, 360);
        require_range("--pitch", camera.pitch, -90, 90);
        require_range("--fov", camera.field_of_view, 0.1, 150);
        options.cameras.push_back(camera);
    }
    for (const double elevation : sun_elevations) {
        require_range("--sun-elevation", elevation, -90, 90);
    }
    options.sun_elevations = sun_elevations;
    require_range("--sun-azimuth", options.sun_azimuth, -360, 360);
    require_range("--moon-elevation", options.settings.moon_elevation, -90, 90);
    require_range("--moon-azimuth", options.settings.moon_azimuth, -360, 360);
    options.tables =
        TableKind(std::find(table_names().begin(), table_names().end(), tables) - table_names().begin());
    // Nodes have all air in closed form: a table of transmittance is of use to the march alone.
    options.marched = method == "marched" || options.tables == TableKind::transmittance;
    require_range("--steps", options.steps, 1, 10000);
    require_range("--sky-steps", options.sky_steps, 1, 10000);
    options.step_east = steps_of_map[0];
    options.step_north = steps_of_map[1];
    require_range("--heightmap-step", options.step_east, 10, 1000);
    require_range("--heightmap-step", options.step_north, 10, 1000);
    if (exposure != "auto") {
        options.exposure = parse_exposure(exposure);
    }
    for (const Switch& s : switches) {
        *s.value = s.word == "on";
    }
    options.settings.phong = glint == "phong";
    options.settings.lommel_seeliger = ground == "lommel-seeliger";
    options.settings.shafts =
        Shafts(std::find(shaft_names().begin(), shaft_names().end(), shafts) - shaft_names().begin());
    for (const Count& count_option : counts) {
        require_range(count_option.option, *count_option.value, count_option.least, count_option.most);
    }
    if (!sequence.empty()) {
        options.sequence = SequenceKind(
            std::find(sequence_names().begin(), sequence_names().end(), sequence) - sequence_names().begin());
        require_range("--frames", options.frames, 1, most_frames);
        if (options.cameras.size() > 1 || sun_elevations.size() > 1) {
            refuse_option(
                "--sequence is of one camera and one sun; give one --camera and one --sun-elevation");
        }
    }
    require_range("--latitude", options.latitude, -90, 90);
    // What a sequence decides itself is not silently ignored.
    const auto refuse = [&](bool when, const std::string& why, const std::vector<std::string>& given) {
        for (const std::string& option : given) {
            if (when && app.count(option) > 0) {
                refuse_option(option + " has no effect: " + why);
            }
        }
    };
    refuse(!options.sequence && !options.window, "it is for a --sequence or a --window", {"--frames"});
    refuse(options.sequence != SequenceKind::day && !options.window, "it is for --sequence day or a --window",
           {"--latitude"});
    refuse(options.sequence == SequenceKind::day, "--sequence day moves the sun",
           {"--sun-elevation", "--sun-azimuth"});
    refuse(options.sequence == SequenceKind::flight, "--sequence flight moves the camera",
           {"--altitude", "--height", "--pitch", "--fov"});
    refuse(options.sequence.has_value(), "a --sequence is not computed on the CPU",
           {"--difference", "--tolerance"});
    refuse(options.window, "it is for pictures", {"--headless", "--sequence", "--difference", "--tolerance"});
    if (options.window && app.count("--frames") > 0) {
        require_range("--frames", options.frames, 1, most_frames);
        options.window_frames = options.frames;
    }
    refuse(!options.window, "it is for a --window", {"--coarseness"});
    require_range("--coarseness", options.coarseness, 1, largest_coarseness);
    refuse(!options.window_frames, "it is for a --window with --frames", {"--screenshot", "--window-sizes"});
    if (nodes != airlight::DefaultScene::nodes && options.difference && !options.window &&
        !options.sequence) {
        refuse_option("the CPU has " + std::to_string(airlight::DefaultScene::nodes) +
                      " nodes: --nodes needs --difference off");
    }
    if (options.tolerance) {
        require_range("--tolerance", *options.tolerance, 0, 1e6);
        if (!options.difference) {
            refuse_option("--tolerance needs --difference on");
        }
    }
    return options;
}

}  // namespace deferred
