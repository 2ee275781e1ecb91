// The three scenes of the README: the structs that advise wrote are compiled here, and measured again.

#include <doctest/doctest.h>
#include <airlight/airlight.hpp>

#include "Flight.hpp"
#include "Orbit.hpp"
#include "Valley.hpp"
#include "emit.hpp"
#include "report.hpp"
#include "support/files.hpp"

namespace {

using namespace advise;
constexpr double inf = std::numeric_limits<double>::infinity();

Question question(const char* name, Ranges ranges) {
    Question out;
    out.air_name = std::string("--preset ") + name;
    out.air = preset(name);
    out.ranges = ranges;
    return out;
}

/// What a compiled Scene changes in views, against the march: no node, no flag of the reference is in it.
template <typename Scene>
Change change_as_compiled(const Question& asked, const std::vector<View>& views, int steps) {
    const Atmosphere& air = asked.air.atmosphere;
    const auto lit = [&](const View& view) {
        return airlight::single_scattering_marched<double>(air, view.eye, view.direction, view.to_sun,
                                                           view.distance, steps);
    };
    const double floor = 1e-4 * airlight::luminance(lit(noon_zenith()).radiance);
    std::vector<double> out;
    for (const View& view : views) {
        const Light light = airlight::single_scattering<double, Scene>(air, view.eye, view.direction,
                                                                       view.to_sun, view.distance);
        out.push_back(change_of(light, lit(view), floor));
    }
    return summed_up(out);
}

template <typename Scene>
void check(const std::string& name, const Question& asked) {
    CAPTURE(name);
    const Answer answer = answered(asked, [](double) {});
    const Advice& advice = answer.advice;

    // Something is turned off, and what was written is what is recommended.
    const bool less = !Scene::mie || Scene::ozone == airlight::ozone_none || !Scene::planet_shadow;
    CHECK(less);
    const std::string head = "Chosen by advise: " + summary(asked, answer) + ".";
    CHECK(support::read_file(std::string(ADVISE_SCENES) + "/" + name + ".hpp") ==
          "#pragma once\n\n" + cpp_text(advice.setting, name, head));
    CHECK(support::read_file(std::string(ADVISE_SCENES) + "/" + name + ".glsl") ==
          glsl_text(advice.setting, head));
    CHECK(advice.change.worst <= asked.tolerance);

    const std::vector<View> views = sampled(asked.air.atmosphere, asked.ranges, asked.views, asked.seed);
    REQUIRE(views.size() == answer.views);
    // The march's and the reference's own errors are in the doubt.
    const double allowed = asked.tolerance + advice.doubt.worst;
    const Change again = change_as_compiled<Scene>(asked, views, doubt_steps);
    MESSAGE(name << ": worst change " << percent(again.worst) << " %, allowed " << percent(allowed) << " %");
    CHECK(again.worst <= allowed);

    // Views that advise never saw: 95 % of them within the tolerance that it kept in all of its own.
    const std::vector<View> others = sampled(asked.air.atmosphere, asked.ranges, asked.views, asked.seed + 1);
    const Change elsewhere = change_as_compiled<Scene>(asked, others, doubt_steps);
    MESSAGE(name << ": other views " << percent(elsewhere.p95) << " % (p95), " << percent(elsewhere.worst)
                 << " % (worst)");
    CHECK(elsewhere.p95 <= allowed);
}

}  // namespace

TEST_SUITE_BEGIN("scenes");

TEST_CASE("a valley at noon") {
    check<Valley>("Valley", question("earth", {{0, 1000}, {50, 70}, {10, 20000}}));
}

TEST_CASE("a sunset flight at 10 km") {
    check<Flight>("Flight", question("earth", {{9000, 11000}, {0, 5}, {1000, inf}}));
}

TEST_CASE("Mars from orbit") {
    check<Orbit>("Orbit", question("mars", {{200e3, 400e3}, {20, 70}, {1000, inf}}));
}

TEST_SUITE_END();
