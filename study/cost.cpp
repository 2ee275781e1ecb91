#include "cost.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "support/error.hpp"

namespace study {
namespace {

/// Seconds of processor time that this thread has had: other programs do not count.
double processor_seconds() {
    std::timespec now{};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) {
        throw support::Error("this system has no clock of a thread's processor time");
    }
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    return airlight_test::percentile(std::move(values), 0.5);
}

/// The suite's rays in float, by world.
class Batch {
  public:
    Batch() : rays_(worlds().size()) {
        for (const View& view : suite()) {
            rays_[view.world].push_back(converted<float>(view.ray));
        }
    }

    /// Per ray of one world. Repeats until the clock can tell.
    double nanoseconds(const Setting& setting, std::size_t world) {
        const Place<float>& place = places<float>()[world];
        const double begin = processor_seconds();
        int repeats = 0;
        double seconds = 0;
        while (seconds < 0.004) {
            const auto light = evaluated(setting, place, rays_[world]);
            sum_ += light.back().radiance.x;  // so that nothing can be left out
            ++repeats;
            seconds = processor_seconds() - begin;
        }
        return 1e9 * seconds / (repeats * static_cast<double>(rays_[world].size()));
    }

    float sum() const {
        return sum_;
    }

  private:
    std::vector<std::vector<Ray<float>>> rays_;
    float sum_ = 0;
};

/// The times of one setting, one entry a round: the mean of the worlds (all have as many rays), and each.
struct Times {
    std::vector<double> mean;
    std::vector<std::vector<double>> world;
};

std::vector<double> ratios(const std::vector<double>& times, const std::vector<double>& unit) {
    std::vector<double> out;
    for (std::size_t i = 0; i < times.size(); ++i) {
        out.push_back(times[i] / unit[i]);
    }
    return out;
}

}  // namespace

std::vector<Cost> costs(const std::vector<Setting>& settings, int rounds, const Progress& progress) {
    const auto found = std::find(settings.begin(), settings.end(), yardstick());
    if (found == settings.end()) {
        throw support::Error("the settings lack the one that times are compared with");
    }
    const std::size_t all = settings.size() * static_cast<std::size_t>(rounds + 1);
    std::size_t done = 0;

    const std::vector<View> views = suite();
    std::vector<Operations> counted;
    for (const Setting& setting : settings) {
        counted.push_back(operations(setting, views));
        progress(++done, all);
    }

    Batch batch;
    const std::size_t worlds_count = worlds().size();
    std::vector<Times> times(settings.size());
    for (Times& t : times) {
        t.world.resize(worlds_count);
    }
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < settings.size(); ++i) {
            double sum = 0;
            for (std::size_t world = 0; world < worlds_count; ++world) {
                times[i].world[world].push_back(batch.nanoseconds(settings[i], world));
                sum += times[i].world[world].back();
            }
            times[i].mean.push_back(sum / static_cast<double>(worlds_count));
            progress(++done, all);
        }
    }
    if (!std::isfinite(batch.sum())) {
        throw support::Error("a method gave a radiance that is no number; run study --quick to see which");
    }

    const Times& unit = times[static_cast<std::size_t>(found - settings.begin())];
    std::vector<Cost> out;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        Cost cost{counted[i], median(times[i].mean), median(ratios(times[i].mean, unit.mean)), {}};
        for (std::size_t world = 0; world < worlds_count; ++world) {
            cost.world_ratios.push_back(median(ratios(times[i].world[world], unit.world[world])));
        }
        out.push_back(cost);
    }
    return out;
}

}  // namespace study
