#include "cost.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>

#include "counting.hpp"
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
            ++count_;
        }
    }

    double nanoseconds(const Setting& setting) {
        const std::vector<Place<float>>& all = places<float>();
        const double begin = processor_seconds();
        int repeats = 0;
        double seconds = 0;
        // Short enough to change little of the machine's mood, long enough for the clock.
        while (seconds < 0.02) {
            for (std::size_t world = 0; world < all.size(); ++world) {
                const auto light = evaluated(setting, all[world], rays_[world]);
                sum_ += light.back().radiance.x;  // so that nothing can be left out
            }
            ++repeats;
            seconds = processor_seconds() - begin;
        }
        return 1e9 * seconds / (repeats * static_cast<double>(count_));
    }

    float sum() const {
        return sum_;
    }

  private:
    std::vector<std::vector<Ray<float>>> rays_;
    std::size_t count_ = 0;
    float sum_ = 0;
};

}  // namespace

std::vector<Cost> costs(const std::vector<Setting>& settings, int rounds, const Progress& progress) {
    const auto found = std::find(settings.begin(), settings.end(), yardstick());
    if (found == settings.end()) {
        throw support::Error("the settings lack the one that times are compared with");
    }
    const auto unit = static_cast<std::size_t>(found - settings.begin());
    const std::size_t all = settings.size() * static_cast<std::size_t>(rounds + 1);
    std::size_t done = 0;

    const std::vector<View> views = suite();
    std::vector<Cost> out;
    for (const Setting& setting : settings) {
        const Operations ops = operations(setting, views);
        out.push_back({ops.exponentials, ops.roots, ops.divisions, 0, 0});
        progress(++done, all);
    }

    Batch batch;
    std::vector<std::vector<double>> times(settings.size());
    std::vector<std::vector<double>> ratios(settings.size());
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> now;
        for (const Setting& setting : settings) {
            now.push_back(batch.nanoseconds(setting));
            progress(++done, all);
        }
        for (std::size_t i = 0; i < settings.size(); ++i) {
            times[i].push_back(now[i]);
            ratios[i].push_back(now[i] / now[unit]);
        }
    }
    if (!std::isfinite(batch.sum())) {
        throw support::Error("a method gave a radiance that is no number; run study --quick to see which");
    }
    for (std::size_t i = 0; i < settings.size(); ++i) {
        out[i].nanoseconds = median(times[i]);
        out[i].ratio = median(ratios[i]);
    }
    return out;
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line)) {
        const std::size_t colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "an unnamed processor";
}

}  // namespace study
