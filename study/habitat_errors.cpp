// The price list of a habitat's air: what each way of computing its light costs in texels, time to bake and
// time a view ray, and how wrong it is against the exact isotropic integral and against the path tracer.

#include <airlight/habitats.hpp>
#include <airlight/tables/habitat.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "csv.hpp"
#include "error_metrics.hpp"
#include "scenes.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/files.hpp"
#include "support/machine.hpp"
#include "support/rows.hpp"
#include "table.hpp"

namespace {

using airlight::HabitatAir;
using airlight::HabitatLights;
using airlight::Table;
using airlight::vec3;
using airlight_test::Nodes;

/// What programs compute in.
using T = float;

/// A ray of the path tracer's table and what it found there, in three channels.
struct Ray {
    std::string kind;
    vec3<double> eye;
    vec3<double> direction;
    double distance = 0;
    vec3<double> once{0.0};
    vec3<double> evenly{0.0};  ///< scattered once, as if by isotropic phase functions
    vec3<double> all{0.0};
    vec3<double> straight{0.0};    ///< irradiance of the wall at its end, straight from the strips
    vec3<double> irradiance{0.0};  ///< and by all light
    vec3<double> exact{0.0};       ///< the isotropic integral, by many points
};

/// Standard errors of the path tracer over what it found.
struct TracerErrors {
    std::vector<double> once;
    std::vector<double> all;
    std::vector<double> irradiance;
};

/// The albedo of walls and caps in the path tracer's table.
constexpr double wall_albedo = 0.3;

struct Settings {
    std::string table = STUDY_ROOT "/reference/data/habitat.csv";
    std::string write;
    std::string check;
    bool quick = false;
};

struct World {
    HabitatAir<T> air = airlight::rama_air<T>();
    HabitatLights<T> lights = airlight::rama_lights<T>();
};

const World& world() {
    static const World rama;
    return rama;
}

std::vector<Ray> read_rays(const std::string& path, TracerErrors& errors) {
    std::vector<Ray> rays;
    for (const airlight_test::Row& row : airlight_test::read_table(path)) {
        const auto number = [&](const std::string& column) {
            return static_cast<double>(row.expected(column));
        };
        const int channel = static_cast<int>(number("channel"));
        if (channel == 0) {
            Ray ray;
            ray.kind = row.text("kind");
            ray.eye = vec3<double>(number("x"), number("y"), number("z"));
            ray.direction = glm::normalize(vec3<double>(number("dx"), number("dy"), number("dz")));
            ray.distance = number("distance");
            rays.push_back(ray);
        }
        Ray& ray = rays.back();
        ray.once[channel] = number("once");
        ray.evenly[channel] = number("evenly");
        ray.all[channel] = number("all");
        ray.straight[channel] = number("straight");
        ray.irradiance[channel] = number("irradiance");
        errors.once.push_back(number("once_error") / number("once"));
        errors.all.push_back(number("all_error") / number("all"));
        errors.irradiance.push_back(number("irradiance_error") / number("irradiance"));
    }
    return rays;
}

/// Integral over the ray of what its air scatters evenly, once, towards the eye: 5 points in each of cells
/// that are fine where the ray passes by strips, 64 points in every strip.
vec3<double> exact_isotropic(const Ray& ray) {
    const HabitatAir<double> air = airlight::rama_air<double>();
    const HabitatLights<double> lights = airlight::rama_lights<double>();
    std::vector<double> edges = {0, ray.distance};
    for (int strip = 0; strip < 6; ++strip) {
        const airlight::LinearLight<double> light = airlight::habitat_strip(air, lights, strip);
        const double peak = airlight::nearest_to_strip(light, ray.eye, ray.direction, ray.distance);
        const double width = airlight::peak_width(light, ray.eye + peak * ray.direction, ray.distance);
        constexpr int cells = 12;
        const double before = std::asinh(peak / width);
        const double reach = before + std::asinh((ray.distance - peak) / width);
        for (int i = 1; i < cells; ++i) {
            edges.push_back(
                std::clamp(peak + width * std::sinh(reach * i / cells - before), 0.0, ray.distance));
        }
    }
    std::sort(edges.begin(), edges.end());
    vec3<double> sum(0.0);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const double width = edges[i + 1] - edges[i];
        for (int k = 0; k < 5; ++k) {
            const vec3<double> place =
                ray.eye + (edges[i] + airlight::gauss_5_positions<double>[k] * width) * ray.direction;
            sum += width * airlight::gauss_5_weights<double>[k] *
                   airlight::habitat_transmittance(air, ray.eye, place) *
                   airlight::isotropic_source(air, place,
                                              airlight::habitat_mean_radiance(air, lights, place, 16));
        }
    }
    return sum;
}

/// Light that the air adds to a ray.
using Light = std::function<vec3<T>(const vec3<T>& eye, const vec3<T>& direction, T distance)>;

/// Irradiance of the wall.
using WallLight = std::function<vec3<T>(const vec3<T>& position, const vec3<T>& normal)>;

struct Size {
    int width;
    int height;
    int depth;
    std::string text() const {
        return std::to_string(width) + " x " + std::to_string(height) + " x " + std::to_string(depth);
    }
    std::size_t texels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(depth);
    }
};

constexpr Size sizes[3] = {{25, 17, 17}, {49, 33, 33}, {97, 65, 65}};
constexpr Size small_size = {25, 9, 9};

/// The light that a method computes: scattered once and evenly, once by the phase functions, or with
/// indirect.
enum class Kind { isotropic, once, all };

/// A way of computing the light of the air. Nothing is baked until `make` is called.
struct Method {
    std::string name;
    std::size_t texels = 0;  ///< of three numbers each, that a ray reads
    Kind kind = Kind::once;  ///< what it is held against
    std::string shader;      ///< what it is called in the table of shader_cost; empty: not there
    std::string setting;     ///< and with which nodes
    int times = 1;           ///< and how often
    std::function<Light(bool quick)> make;
};

/// Hook: the strips' light itself, at 16 points of each.
struct ComputedLight {
    vec3<T> operator()(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                       const vec3<T>& position) const {
        return airlight::habitat_mean_radiance(air, lights, position, 4);
    }
};

Size made_size(Size size, bool quick) {
    return quick ? Size{size.width / 4 + 2, size.height / 4 + 2, size.depth / 4 + 2} : size;
}

using Texels = std::shared_ptr<Table<vec3<T>>>;

Texels light_table(Size size) {
    return std::make_shared<Table<vec3<T>>>(airlight::bake_habitat_light(
        world().air, world().lights, size.width, size.height, size.depth, 4, support::Rows{}));
}

Texels passed_table(Size size) {
    return std::make_shared<Table<vec3<T>>>(airlight::bake_habitat_passed(
        world().air, world().lights, size.width, size.height, size.depth, 4, support::Rows{}));
}

using Indirect = std::shared_ptr<airlight::HabitatIndirectTables<T>>;

Indirect indirect_tables(int bounces, bool quick) {
    const Size size = made_size(small_size, quick);
    const Texels passed = passed_table(size);
    return std::make_shared<airlight::HabitatIndirectTables<T>>(
        airlight::bake_habitat_indirect<T, airlight::DefaultScene>(
            world().air, world().lights, vec3<T>(T(wall_albedo)), bounces, size.width, size.height,
            size.depth, quick ? 16 : 128, airlight::HabitatPassedTable<T>{passed.get()}, support::Rows{}));
}

template <typename Hook>
Light marched(const Hook& hook) {
    return [hook](const vec3<T>& eye, const vec3<T>& direction, T distance) {
        return airlight::habitat_scattering_marched<T>(world().air, world().lights, eye, direction, distance,
                                                       30, hook);
    };
}

template <int Count, typename Hook>
Light by_nodes(const Hook& hook) {
    return [hook](const vec3<T>& eye, const vec3<T>& direction, T distance) {
        return airlight::habitat_scattering_by_nodes<T, Nodes<Count>>(world().air, world().lights, eye,
                                                                      direction, distance, hook);
    };
}

/// The strips one by one, with the air's phase functions.
template <int Count>
vec3<T> with_phases(const vec3<T>& eye, const vec3<T>& direction, T distance, int pieces) {
    vec3<T> sum(T(0));
    for (int i = 0; i < 6; ++i) {
        sum += airlight::strip_scattering<T, Nodes<Count>>(
            world().air, airlight::habitat_strip(world().air, world().lights, i), eye, direction, distance,
            pieces);
    }
    return sum;
}

/// A hook that keeps its tables.
struct LightOfTable {
    Texels table;
    vec3<T> operator()(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                       const vec3<T>& position) const {
        return airlight::sample_habitat(air, lights, *table, position);
    }
};
struct LightOfPassed {
    Texels table;
    vec3<T> operator()(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                       const vec3<T>& position) const {
        return airlight::HabitatPassedTable<T>{table.get()}(air, lights, position);
    }
};
struct IndirectLight {
    Indirect tables;
    vec3<T> operator()(const HabitatAir<T>& air, const HabitatLights<T>& lights,
                       const vec3<T>& position) const {
        return airlight::sample_habitat(air, lights, tables->mean, position);
    }
};

template <int Count>
void add_nodes(std::vector<Method>& methods) {
    const std::string nodes = std::to_string(Count) + " nodes, ";
    const std::string shader = "habitat_scattering_by_nodes";
    methods.push_back({nodes + "exact light", 0, Kind::isotropic, "", "", 1,
                       [](bool) { return by_nodes<Count>(ComputedLight{}); }});
    for (const Size size : {small_size, sizes[1]}) {
        methods.push_back({nodes + "what passes by " + size.text(), size.texels(), Kind::isotropic, shader,
                           std::to_string(Count), 1, [size](bool quick) {
                               return by_nodes<Count>(LightOfPassed{passed_table(made_size(size, quick))});
                           }});
    }
}

/// What the goal is set for: the isotropic method whose worst rays are looked at, and the one that is to
/// help.
constexpr const char* isotropic_name = "10 nodes, exact light";
constexpr const char* phases_name = "phases, 8 nodes, 1 piece";
constexpr const char* finer_name = "phases, 8 nodes, 2 pieces";
constexpr const char* finest_name = "phases, 24 nodes, 4 pieces";

/// The document's own, the unit of time.
constexpr const char* unit_name = "30 steps, light by 49 x 33 x 33";

std::vector<Method> all_methods() {
    std::vector<Method> methods;
    methods.push_back({"30 steps, exact light", 0, Kind::isotropic, "", "", 1,
                       [](bool) { return marched(ComputedLight{}); }});
    for (const Size size : sizes) {
        methods.push_back(
            {"30 steps, light by " + size.text(), size.texels(), Kind::isotropic, "", "", 1,
             [size](bool quick) { return marched(LightOfTable{light_table(made_size(size, quick))}); }});
    }
    for (const Size size : {small_size, sizes[0], sizes[1], sizes[2]}) {
        methods.push_back(
            {"30 steps, what passes by " + size.text(), size.texels(), Kind::isotropic, "", "", 1,
             [size](bool quick) { return marched(LightOfPassed{passed_table(made_size(size, quick))}); }});
    }
    add_nodes<4>(methods);
    add_nodes<8>(methods);
    add_nodes<10>(methods);
    const auto add_phases = [&](auto nodes, int pieces, const std::string& name, const std::string& shader) {
        methods.push_back({name, 0, Kind::once, shader, std::to_string(nodes.value), 6, [pieces](bool) {
                               return [pieces](const vec3<T>& eye, const vec3<T>& direction, T distance) {
                                   return with_phases<decltype(nodes)::value>(eye, direction, distance,
                                                                              pieces);
                               };
                           }});
    };
    add_phases(std::integral_constant<int, 8>{}, 1, phases_name, "strip_scattering");
    add_phases(std::integral_constant<int, 8>{}, 2, finer_name, "");
    add_phases(std::integral_constant<int, 24>{}, 4, finest_name, "");
    const std::string bounced = ", indirect by bounces: ";
    methods.push_back({"8 nodes, what passes by 25 x 9 x 9" + bounced + "2", 2 * small_size.texels(),
                       Kind::all, "", "", 1, [](bool quick) {
                           const LightOfPassed straight{passed_table(made_size(small_size, quick))};
                           const IndirectLight more{indirect_tables(2, quick)};
                           return by_nodes<8>([straight, more](const HabitatAir<T>& air,
                                                               const HabitatLights<T>& lights,
                                                               const vec3<T>& position) {
                               return straight(air, lights, position) + more(air, lights, position);
                           });
                       }});
    for (const int bounces : {1, 2, 4, 8}) {
        methods.push_back({phases_name + bounced + std::to_string(bounces), small_size.texels(), Kind::all,
                           "", "", 1, [bounces](bool quick) {
                               const Light more = by_nodes<8>(IndirectLight{indirect_tables(bounces, quick)});
                               return [more](const vec3<T>& eye, const vec3<T>& direction, T distance) {
                                   return with_phases<8>(eye, direction, distance, 1) +
                                          more(eye, direction, distance);
                               };
                           }});
    }
    return methods;
}

struct WallMethod {
    std::string name;
    bool straight;  ///< is held against the light straight from the strips
    std::function<WallLight(bool quick)> make;
};

std::vector<WallMethod> wall_methods() {
    std::vector<WallMethod> methods;
    for (const int pieces : {1, 4}) {
        methods.push_back(
            {"habitat_irradiance, " + std::to_string(pieces) + (pieces == 1 ? " piece" : " pieces"), true,
             [pieces](bool) {
                 return [pieces](const vec3<T>& position, const vec3<T>& normal) {
                     return airlight::habitat_irradiance<T>(world().air, world().lights, position, normal,
                                                            pieces);
                 };
             }});
    }
    for (const int bounces : {1, 2, 4, 8}) {
        methods.push_back(
            {"habitat_irradiance, 1 piece, and the table of bounces: " + std::to_string(bounces), false,
             [bounces](bool quick) {
                 const Indirect tables = indirect_tables(bounces, quick);
                 return [tables](const vec3<T>& position, const vec3<T>& normal) {
                     return airlight::habitat_irradiance<T>(world().air, world().lights, position, normal,
                                                            1) +
                            airlight::sample_habitat(world().air, world().lights, tables->irradiance,
                                                     position);
                 };
             }});
    }
    return methods;
}

std::string errors_text(const std::vector<double>& errors) {
    const airlight_test::ErrorMetrics m = airlight_test::error_metrics(errors);
    char text[96];
    std::snprintf(text, sizeof text, "%.3g, %.3g, %.3g", 100 * m.median, 100 * m.p95, 100 * m.largest);
    return text;
}

std::vector<double> errors_of(const std::vector<vec3<double>>& got,
                              const std::function<vec3<double>(std::size_t)>& truth) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < got.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            errors.push_back(std::fabs(got[i][c] / truth(i)[c] - 1));
        }
    }
    return errors;
}

vec3<T> narrowed(const vec3<double>& v) {
    return vec3<T>(static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z));
}

/// Processor seconds for all rays, the least of a few rounds.
double seconds_of(const std::vector<Ray>& rays, const Light& light) {
    constexpr double all_rounds = 0.05;
    double best = 1e30;
    double spent = 0;
    T kept = 0;
    while (spent < all_rounds) {
        const std::clock_t begun = std::clock();
        for (int repeat = 0; repeat < 4; ++repeat) {
            for (const Ray& ray : rays) {
                kept += light(narrowed(ray.eye), narrowed(ray.direction), static_cast<T>(ray.distance)).y;
            }
        }
        const double seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
        best = std::min(best, seconds);
        spent += seconds + 1e-6;  // a clock may not have moved
    }
    return kept < 0 ? 0 : best;
}

struct Result {
    const Method* method;
    Light light;
    double bake_seconds = 0;
    double time = 1e30;  ///< processor seconds for all rays
    std::vector<double> exact;
    std::vector<double> once;
    std::vector<double> all;
};

std::string gpu_text(const Method& method) {
    if (method.shader.empty()) {
        return "-";
    }
    static const char* const path = STUDY_ROOT "/bench/shader_cost/results.csv";
    static const study::Csv prices = study::read_csv(path);
    const std::size_t row =
        prices.find({{"method", method.shader}, {"setting", method.setting}, {"flags", "default"}});
    if (row == prices.rows.size()) {
        return "-";
    }
    return std::to_string(std::lround(method.times * prices.number(row, "instructions")));
}

const Result& result_named(const std::vector<Result>& results, const std::string& name) {
    return *std::find_if(results.begin(), results.end(),
                         [&](const Result& result) { return result.method->name == name; });
}

/// The worst tenth of the isotropic method's rays, against light scattered once, and both methods there.
std::string worst_rays(const std::vector<Result>& results) {
    const Result& isotropic = result_named(results, isotropic_name);
    std::vector<std::size_t> order(isotropic.once.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return isotropic.once[a] > isotropic.once[b]; });
    order.resize((order.size() + 9) / 10);
    std::string text = "| method | error on those rays: median, p95, max % |\n|---|---|\n";
    for (const Result* result : {&isotropic, &result_named(results, phases_name),
                                 &result_named(results, finer_name), &result_named(results, finest_name)}) {
        std::vector<double> errors;
        for (const std::size_t i : order) {
            errors.push_back(result->once[i]);
        }
        text += "| " + result->method->name + " | " + errors_text(errors) + " |\n";
    }
    return text;
}

/// Whether the ray ends on a strip or within 4 widths of one.
bool ends_by_strip(const Ray& ray) {
    const HabitatAir<double> air = airlight::rama_air<double>();
    const HabitatLights<double> lights = airlight::rama_lights<double>();
    const vec3<double> end = ray.eye + ray.distance * ray.direction;
    for (int i = 0; i < 6; ++i) {
        if (airlight::peak_width(airlight::habitat_strip(air, lights, i), end, 0.0) < 4 * lights.width) {
            return true;
        }
    }
    return false;
}

/// Some methods by kind of ray.
std::string by_kind(const std::vector<Ray>& rays, const std::vector<Result>& results) {
    std::vector<std::string> kinds;
    for (const Ray& ray : rays) {
        if (std::find(kinds.begin(), kinds.end(), ray.kind) == kinds.end()) {
            kinds.push_back(ray.kind);
        }
    }
    struct Column {
        const char* name;
        const char* against;
        std::vector<double> Result::*errors;
    };
    const Column columns[] = {
        {unit_name, "isotropic", &Result::exact},
        {"10 nodes, what passes by 49 x 33 x 33", "isotropic", &Result::exact},
        {isotropic_name, "once", &Result::once},
        {phases_name, "once", &Result::once},
        {finer_name, "once", &Result::once},
        {finest_name, "once", &Result::once},
        {"phases, 8 nodes, 1 piece, indirect by bounces: 8", "all", &Result::all},
    };
    std::string text = "| method | against";
    for (const std::string& kind : kinds) {
        text += " | " + kind;
    }
    text += " |\n|---|---";
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        text += "|---";
    }
    text += "|\n";
    for (const Column& column : columns) {
        const std::vector<double>& all = result_named(results, column.name).*column.errors;
        text += std::string("| ") + column.name + " | " + column.against;
        for (const std::string& kind : kinds) {
            std::vector<double> errors;
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (rays[i / 3].kind == kind) {
                    errors.push_back(all[i]);
                }
            }
            text += " | " + errors_text(errors);
        }
        text += " |\n";
    }
    return text;
}

std::string page(const Settings& settings) {
    TracerErrors tracer;
    std::vector<Ray> rays = read_rays(settings.table, tracer);
    if (settings.quick) {
        for (std::size_t i = 0; i < rays.size() / 8; ++i) {
            rays[i] = rays[8 * i];
        }
        rays.resize(rays.size() / 8);
    }
    support::Rows("exact isotropic light")(static_cast<int>(rays.size()), [&](int i) {
        Ray& ray = rays[static_cast<std::size_t>(i)];
        ray.exact = exact_isotropic(ray);
    });

    const std::vector<Method> methods = all_methods();
    std::vector<Result> results;
    const support::Rows bar("methods");
    for (std::size_t k = 0; k < methods.size(); ++k) {
        const auto begun = std::chrono::steady_clock::now();
        Result result;
        result.method = &methods[k];
        result.light = methods[k].make(settings.quick);
        result.bake_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        std::vector<vec3<double>> got;
        for (const Ray& ray : rays) {
            const vec3<T> seen =
                result.light(narrowed(ray.eye), narrowed(ray.direction), static_cast<T>(ray.distance));
            got.emplace_back(seen.x, seen.y, seen.z);
        }
        result.exact = errors_of(got, [&](std::size_t i) { return rays[i].exact; });
        result.once = errors_of(got, [&](std::size_t i) { return rays[i].once; });
        result.all = errors_of(got, [&](std::size_t i) { return rays[i].all; });
        results.push_back(result);
        bar.report(k + 1, methods.size());
    }
    // In turns, so that a machine that is slow for a while is slow for all.
    for (int turn = 0; turn < (settings.quick ? 1 : 9); ++turn) {
        for (Result& result : results) {
            result.time = std::min(result.time, seconds_of(rays, result.light));
        }
    }
    double unit = 0;
    for (const Result& result : results) {
        unit = result.method->name == unit_name ? result.time : unit;
    }

    std::vector<vec3<double>> exact;
    for (const Ray& ray : rays) {
        exact.push_back(ray.exact);
    }
    const std::string cores = std::to_string(std::max(1U, std::thread::hardware_concurrency()));
    std::string text =
        "# What a habitat's air costs, and how wrong it is\n\n"
        "Written by `habitat_errors --write docs/habitat.md` (" +
        support::processor_name() + ", " + cores + " cores). Do not edit.\n" + R"(
Light that the air of )" +
        std::to_string(rays.size()) +
        R"( rays adds in the habitat of `rama_air` and `rama_lights`, each of three channels, in float: from
everywhere, from within 100 m of the ground, on the axis, within 4 widths of a strip; to everywhere, towards strips and along
them. Errors are median, 95 % and largest, in per cent of the light itself, against

- *isotropic*: the exact integral as if the air scattered evenly, once;
- *once*: the path tracer's light scattered once, with the air's phase functions;
- *all*: the path tracer's light of all orders, between walls of albedo 0.3.

The path tracer's own standard errors are, median, 95 % and largest, )" +
        errors_text(tracer.once) + " % (once) and\n" + errors_text(tracer.all) +
        " % (all); its isotropic light and the exact integral differ by " +
        errors_text(errors_of(exact, [&](std::size_t i) { return rays[i].evenly; })) +
        R"( %.

"Light by" is the document's table of mean radiance, "what passes by" the table of the share that the air lets through; "exact
light" is asked at 16 points of each strip; "phases" sums `strip_scattering` over the six strips. Bounces are those of
`bake_habitat_indirect` with 25 x 9 x 9 texels and 128 directions. Time is that of a ray, over that of
the document's, )" +
        unit_name + R"(.
GPU instructions are those of `shader_cost`, see [bench](../bench/README.md), without the fetch of a table and with both
stretches of a ray by nodes, though only a ray past an end of a strip has two; a dash where they were not counted.

| method | kB in 16 bits | bake, s on )" +
        cores +
        R"( cores | time a ray | GPU instructions | isotropic: median, p95, max % | once: median, p95, max % | all: median, p95, max % |
|---|---|---|---|---|---|---|---|
)";
    for (const Result& result : results) {
        char numbers[96];
        std::snprintf(numbers, sizeof numbers, "%.4g | %.2g | %.2g",
                      6e-3 * static_cast<double>(result.method->texels),
                      result.method->texels > 0 ? result.bake_seconds : 0.0, result.time / unit);
        text += "| " + result.method->name + " | " + numbers + " | " + gpu_text(*result.method) + " | " +
                (result.method->kind == Kind::isotropic ? errors_text(result.exact) : "-") + " | " +
                (result.method->kind == Kind::all ? "-" : errors_text(result.once)) + " | " +
                errors_text(result.all) + " |\n";
    }
    text += "\n## Where isotropy is worst\n\nThe worst tenth of the rays and channels of `" +
            std::string(isotropic_name) + "`, against light scattered once, and what the phase\n" +
            "functions make of the same ones.\n\n" + worst_rays(results) +
            "\n## By kind of ray\n\nWhere the eye is, or what the ray makes for; median, p95 and max %.\n\n" +
            by_kind(rays, results) +
            "\n## The wall\n\nIrradiance of the wall where the rays end, some of them on a strip or beside "
            "one, against the path tracer's, whose\nown standard errors are " +
            errors_text(tracer.irradiance) +
            " %. \"Straight\" is light from the strips alone.\n\n"
            "| method | against | off the strips: median, p95, max % | within 4 widths of one "
            "|\n|---|---|---|---|\n";
    const auto by_strip = [&](const std::vector<double>& errors, bool wanted) {
        std::vector<double> chosen;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            if (ends_by_strip(rays[i / 3]) == wanted) {
                chosen.push_back(errors[i]);
            }
        }
        return errors_text(chosen);
    };
    for (const WallMethod& method : wall_methods()) {
        const WallLight light = method.make(settings.quick);
        std::vector<vec3<double>> got;
        for (const Ray& ray : rays) {
            const vec3<T> end = narrowed(ray.eye + ray.distance * ray.direction);
            const vec3<T> seen = light(end, airlight::habitat_normal(world().air, world().lights, end));
            got.emplace_back(seen.x, seen.y, seen.z);
        }
        const std::vector<double> errors = errors_of(
            got, [&](std::size_t i) { return method.straight ? rays[i].straight : rays[i].irradiance; });
        text += "| " + method.name + " | " + (method.straight ? "straight" : "all") + " | " +
                by_strip(errors, false) + " | " + by_strip(errors, true) + " |\n";
    }
    return text;
}

/// Whether a page has a row for every method.
int check_page(const std::string& path) {
    const std::string text = support::read_file(path);
    int missing = 0;
    const auto check = [&](const std::string& name) {
        if (text.find("| " + name + " |") == std::string::npos) {
            std::printf("%s has no row '%s'; write it anew: habitat_errors --write %s\n", path.c_str(),
                        name.c_str(), path.c_str());
            ++missing;
        }
    };
    for (const Method& method : all_methods()) {
        check(method.name);
    }
    for (const WallMethod& method : wall_methods()) {
        check(method.name);
    }
    return missing > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("What each way of computing the light of a habitat's air costs, and how wrong it is.",
                 "habitat_errors");
    Settings settings;
    support::add_value(app, "--reference", "<file>", settings.table,
                       "the path tracer's table (default: reference/data/habitat.csv)");
    support::add_value(app, "--write", "<file.md>", settings.write, "the page (default: standard output)");
    support::add_value(app, "--check-page", "<file.md>", settings.check,
                       "whether the page has a row for every method; computes nothing");
    support::add_switch(app, "--quick", settings.quick, "an eighth of the rays and small tables");
    app.footer("Exit status: 0 done, 1 an error, 2 wrong use.");
    return support::guarded_main(app, argc, argv, [&] {
        if (!settings.check.empty()) {
            return check_page(settings.check);
        }
        if (!settings.write.empty()) {
            support::make_writable_directory_of(settings.write);
        }
        support::print_or_write(settings.write, page(settings));
        return 0;
    });
}
