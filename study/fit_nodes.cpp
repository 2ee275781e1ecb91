// Fits the five numbers of node_fit for one count of nodes: the simplex of Nelder and Mead from where the
// header stands, on the errors over the suite and random rays of all worlds.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>
#include <vector>

#include "errors.hpp"
#include "support/progress.hpp"

namespace {

using Numbers = std::array<double, 5>;  // logarithms, so that all stay positive

/// The constants that the scenes below are compiled with.
airlight::NodeFit<double>& trial() {
    static airlight::NodeFit<double> fit{};
    return fit;
}

template <int Nodes, int Ozone>
struct Fitted : airlight::DefaultScene {
    static constexpr int nodes = Nodes;
    static constexpr int ozone = Ozone;
};
template <int Nodes>
struct Shipped : airlight::DefaultScene {
    static constexpr int nodes = Nodes;
};

}  // namespace

namespace airlight {
#define AIRLIGHT_FIT(nodes, ozone)                             \
    template <>                                                \
    NodeFit<double> node_fit<double, Fitted<nodes, ozone>>() { \
        return trial();                                        \
    }
#define AIRLIGHT_FIT_ALL(nodes)     \
    AIRLIGHT_FIT(nodes, ozone_none) \
    AIRLIGHT_FIT(nodes, ozone_tent) \
    AIRLIGHT_FIT(nodes, ozone_lorentzian)
AIRLIGHT_FIT_ALL(4)
AIRLIGHT_FIT_ALL(5)
AIRLIGHT_FIT_ALL(6)
AIRLIGHT_FIT_ALL(8)
AIRLIGHT_FIT_ALL(10)
AIRLIGHT_FIT_ALL(12)
AIRLIGHT_FIT_ALL(16)
AIRLIGHT_FIT_ALL(24)
}  // namespace airlight

namespace {

template <int Nodes>
double luminance_of(const study::View& view) {
    const study::World& world = study::worlds()[view.world];
    const auto seen = [&](auto scene) {
        return airlight::luminance(
            airlight::single_scattering<double, decltype(scene)>(world.air, view.ray.eye, view.ray.direction,
                                                                 view.ray.to_sun, view.ray.distance)
                .radiance);
    };
    if (world.ozone == airlight::ozone_none) {
        return seen(Fitted<Nodes, airlight::ozone_none>{});
    }
    return world.ozone == airlight::ozone_tent ? seen(Fitted<Nodes, airlight::ozone_tent>{})
                                               : seen(Fitted<Nodes, airlight::ozone_lorentzian>{});
}

/// Largest error, 95th percentile and fourth mean, of all and of each world, multiplied; logarithm.
template <int Nodes>
double badness(const study::Judged& judged, const Numbers& numbers, bool print) {
    trial() = {std::exp(numbers[0]), std::exp(numbers[1]), std::exp(numbers[2]), std::exp(numbers[3]),
               std::exp(numbers[4])};
    std::vector<double> all;
    std::vector<std::vector<double>> by_world(study::worlds().size());
    for (std::size_t i = 0; i < judged.views.size(); ++i) {
        const double error = std::fabs(luminance_of<Nodes>(judged.views[i]) - judged.luminance[i]) /
                                 std::max(judged.luminance[i], judged.floor[i]) +
                             1e-6;  // below that the closed forms' own error counts
        all.push_back(error);
        by_world[judged.views[i].world].push_back(error);
    }
    const auto score = [](const std::vector<double>& errors) {
        const airlight_test::ErrorMetrics m = airlight_test::error_metrics(errors);
        double fourth = 0;
        for (const double e : errors) {
            fourth += e * e * e * e;
        }
        return std::log(m.largest) + 1.5 * std::log(m.p95) +
               std::log(std::pow(fourth / static_cast<double>(errors.size()), 0.25));
    };
    double sum = score(all);
    for (const std::vector<double>& errors : by_world) {
        sum += 0.15 * score(errors);
    }
    if (print) {
        const airlight_test::ErrorMetrics m = airlight_test::error_metrics(all);
        std::printf("%2d nodes {%.3f, %.3f, %.4f, %.3f, %.3f}: max %.3g %%, p95 %.3g %%\n", Nodes,
                    trial().evenness, trial().heights, trial().pull, trial().sun, trial().view,
                    100 * m.largest, 100 * m.p95);
    }
    return sum;
}

/// Nelder and Mead's simplex from `start`, its edges `edge` long.
Numbers descend(const std::function<double(const Numbers&)>& f, const Numbers& start, double edge,
                int steps) {
    std::vector<std::pair<double, Numbers>> simplex;
    for (std::size_t i = 0; i <= start.size(); ++i) {
        Numbers corner = start;
        if (i > 0) {
            corner[i - 1] += edge;
        }
        simplex.emplace_back(f(corner), corner);
    }
    for (int step = 0; step < steps; ++step) {
        std::sort(simplex.begin(), simplex.end());
        auto& worst = simplex.back();
        Numbers centre{};
        for (std::size_t i = 0; i + 1 < simplex.size(); ++i) {
            for (std::size_t k = 0; k < centre.size(); ++k) {
                centre[k] += simplex[i].second[k] / static_cast<double>(start.size());
            }
        }
        const auto moved = [&](double by) {
            Numbers to{};
            for (std::size_t k = 0; k < to.size(); ++k) {
                to[k] = centre[k] + by * (worst.second[k] - centre[k]);
            }
            return std::pair<double, Numbers>{f(to), to};
        };
        auto reflected = moved(-1);
        if (reflected.first < simplex.front().first) {
            worst = std::min(reflected, moved(-2));
        } else if (reflected.first < simplex[simplex.size() - 2].first) {
            worst = reflected;
        } else if (auto contracted = moved(0.5); contracted.first < worst.first) {
            worst = contracted;
        } else {
            for (std::size_t i = 1; i < simplex.size(); ++i) {
                for (std::size_t k = 0; k < centre.size(); ++k) {
                    simplex[i].second[k] = (simplex[i].second[k] + simplex[0].second[k]) / 2;
                }
                simplex[i].first = f(simplex[i].second);
            }
        }
    }
    return std::min_element(simplex.begin(), simplex.end())->second;
}

template <int Nodes>
void fit(const study::Judged& judged, int steps) {
    const airlight::NodeFit<double> shipped = airlight::node_fit<double, Shipped<Nodes>>();
    Numbers numbers = {std::log(shipped.evenness), std::log(shipped.heights), std::log(shipped.pull),
                       std::log(shipped.sun), std::log(shipped.view)};
    const auto f = [&](const Numbers& x) { return badness<Nodes>(judged, x, false); };
    std::printf("the header's ");
    badness<Nodes>(judged, numbers, true);
    for (const double edge : {0.4, -0.3}) {
        numbers = descend(f, numbers, edge, steps);
    }
    std::printf("fitted       ");
    badness<Nodes>(judged, numbers, true);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Fits the numbers of node_fit for one count of nodes and prints them beside the header's.",
                 "fit_nodes");
    int nodes = 8;
    int steps = 120;
    app.add_option("--nodes", nodes, "4, 5, 6, 8, 10, 12, 16 or 24; 8 if not given")
        ->check(CLI::IsMember({4, 5, 6, 8, 10, 12, 16, 24}));
    app.add_option("--steps", steps, "Of the simplex, twice; 120 if not given")->check(CLI::Range(1, 100000));
    CLI11_PARSE(app, argc, argv);
    std::vector<study::View> views = study::suite();
    const std::vector<study::View> random = study::random_views(500);
    views.insert(views.end(), random.begin(), random.end());
    support::ProgressBar bar("truth");
    const study::Judged judged =
        study::judged(std::move(views), [&](std::size_t done, std::size_t all) { bar(done, all); });
    switch (nodes) {
        case 4:
            fit<4>(judged, steps);
            break;
        case 5:
            fit<5>(judged, steps);
            break;
        case 6:
            fit<6>(judged, steps);
            break;
        case 8:
            fit<8>(judged, steps);
            break;
        case 10:
            fit<10>(judged, steps);
            break;
        case 12:
            fit<12>(judged, steps);
            break;
        case 16:
            fit<16>(judged, steps);
            break;
        default:
            fit<24>(judged, steps);
            break;
    }
    return 0;
}
