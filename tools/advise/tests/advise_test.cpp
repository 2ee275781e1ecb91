#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <airlight/airlight.hpp>
#include <limits>

#include "emit.hpp"
#include "report.hpp"
#include "support/error.hpp"
#include "warnings.hpp"

namespace {

using namespace advise;
constexpr double inf = std::numeric_limits<double>::infinity();

std::string earth_text() {
    return "ground_radius = 6360e3\ntop_altitude = 100e3\n"
           "rayleigh_scattering = 5.802e-6 13.558e-6 33.1e-6  # spectrum\nrayleigh_scale_height = 8e3\n"
           "mie_scattering = 3.996e-6 3.996e-6 3.996e-6\nmie_absorption = 0.444e-6 0.444e-6 0.444e-6\n"
           "mie_scale_height = 1.2e3\n\nmie_g = 0.8\r\nozone_absorption = 0.65e-6 1.881e-6 0.085e-6\n"
           "ozone_altitude = 25e3\nozone_half_width = 15e3\nground_albedo = 0.1 0.1 0.1\n";
}

/// What is said about a text; empty when it is read.
std::string refusal(const std::string& text) {
    try {
        parsed_atmosphere(text, "file");
    } catch (const support::Error& error) {
        return error.what();
    }
    return "";
}

bool begins(const std::string& text, const std::string& with) {
    INFO(text);
    return text.rfind(with, 0) == 0;
}

bool any_has(const std::vector<std::string>& texts, const std::string& part) {
    for (const std::string& text : texts) {
        if (text.find(part) != std::string::npos) {
            return true;
        }
    }
    return false;
}

Question question(const Air& air, Ranges ranges) {
    Question out;
    out.air_name = "air";
    out.air = air;
    out.ranges = ranges;
    out.views = 200;
    return out;
}

Answer answer(const Question& asked) {
    return answered(asked, [](double) {});
}

const Ranges day{{0, 1000}, {30, 60}, {100, inf}};

}  // namespace

TEST_SUITE_BEGIN("file");

TEST_CASE("a file with every member of the preset is the preset") {
    const Atmosphere read = parsed_atmosphere(earth_text(), "file");
    const Atmosphere earth = airlight::earth<double>();
    // == : both round the same decimals once.
    CHECK(read.ground_radius == earth.ground_radius);
    CHECK(read.top_altitude == earth.top_altitude);
    CHECK(read.rayleigh_scattering == earth.rayleigh_scattering);
    CHECK(read.mie_absorption == earth.mie_absorption);
    CHECK(read.mie_g == earth.mie_g);
    CHECK(read.ozone_absorption == earth.ozone_absorption);
    CHECK(read.ozone_half_width == earth.ozone_half_width);
    CHECK(read.ground_albedo == earth.ground_albedo);
}

TEST_CASE("what is wrong in a file is named by its line") {
    CHECK(begins(refusal(earth_text() + "mie_h = 3\n"), "file:14: 'mie_h' is no member of an atmosphere"));
    CHECK(begins(refusal(earth_text() + "mie_g = 0.7\n"), "file:14: mie_g stands on line 9 already"));
    CHECK(begins(refusal("mie_g 0.7\n"), "file:1: 'mie_g 0.7' has no '='"));
    CHECK(begins(refusal("mie_g = 0.7x\n"), "file:1: '0.7x' is no finite number"));
    CHECK(begins(refusal("mie_g = nan\n"), "file:1: 'nan' is no finite number"));
    CHECK(begins(refusal("mie_g = 0.7 0.8\n"), "file:1: mie_g has 2 numbers; give one"));
    CHECK(begins(refusal("ground_albedo = 0.7\n"), "file:1: ground_albedo has 1 numbers; give three"));
    CHECK(begins(refusal("ground_radius = 0\n"), "file:1: ground_radius is 0; it must be greater than 0"));
    CHECK(begins(refusal("mie_scattering = 0 -1 0\n"), "file:1: mie_scattering is -1; it must be 0 or more"));
    CHECK(begins(refusal("mie_g = 0.7\n"), "file:1: the file ends without ground_albedo, ground_radius"));
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("sampling");

TEST_CASE("views stay in their ranges, hold both ends, and look everywhere") {
    const Ranges ranges{{10, 5000}, {-3, 40}, {50, 4000}};
    const std::vector<View> views = sampled(airlight::earth<double>(), ranges, 400, 7);
    REQUIRE(views.size() == 400);
    double lowest = inf;
    double highest = 0;
    int up = 0;
    int down = 0;
    int sunwards = 0;
    for (const View& view : views) {
        const double sun = std::asin(view.to_sun.z) * 180.0 / airlight::pi<double>;
        CHECK(sun > -3 - 1e-9);  // an arc sine's rounding
        CHECK(sun < 40 + 1e-9);
        CHECK(view.distance >= 50);
        CHECK(view.distance <= 4000 * (1 + 1e-12));  // an exponential's rounding
        CHECK(glm::length(view.direction) == doctest::Approx(1));
        lowest = std::min(lowest, view.eye.altitude);
        highest = std::max(highest, view.eye.altitude);
        up += view.direction.z > 0.1 ? 1 : 0;
        down += view.direction.z < -0.1 ? 1 : 0;
        sunwards += glm::dot(view.direction, view.to_sun) > 0.86 ? 1 : 0;  // within 30 degrees
    }
    CHECK(lowest == doctest::Approx(10));
    CHECK(highest == doctest::Approx(5000));
    CHECK(up > 80);        // of the hundred upwards most, and half of those beside the sun
    CHECK(down > 80);      // of the hundred downwards most
    CHECK(sunwards > 99);  // the hundred beside the sun
}

TEST_CASE("the same seed draws the same views, another seed others") {
    const Atmosphere earth = airlight::earth<double>();
    const std::vector<View> a = sampled(earth, day, 50, 3);
    const std::vector<View> b = sampled(earth, day, 50, 3);
    const std::vector<View> c = sampled(earth, day, 50, 4);
    CHECK(a[10].direction == b[10].direction);
    CHECK(a[10].direction != c[10].direction);
}

TEST_CASE("from space every view meets the air") {
    const Atmosphere mars = airlight::mars<double>();
    CHECK(sampled(mars, {{200e3, 400e3}, {0, 60}, {1000, inf}}, 200, 1).size() == 200);
    CHECK(sampled(mars, {{200e3, 400e3}, {0, 60}, {10, 1000}}, 200, 1).empty());
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("measure");

TEST_CASE("a change is the larger of luminance's and transmittance's") {
    const Vector grey(1.0);
    const Light before{0.5 * grey, 0.4 * grey};
    CHECK(change_of({0.6 * grey, 0.4 * grey}, before, 1e-9) == doctest::Approx(0.2));
    CHECK(change_of({0.5 * grey, 0.1 * grey}, before, 1e-9) == doctest::Approx(0.3));
    CHECK(change_of({0.6 * grey, 0.4 * grey}, before, 2.0) == doctest::Approx(0.05));  // a dark view
    CHECK(change_of(before, before, 1e-9) == 0);  // exact: the same numbers
}

TEST_CASE("median, p95 and worst of a hundred") {
    std::vector<double> hundred;
    for (int i = 100; i > 0; --i) {
        hundred.push_back(i);
    }
    const Change change = summed_up(hundred);
    CHECK(change.median == 50);
    CHECK(change.p95 == 95);
    CHECK(change.worst == 100);
}

TEST_CASE("two digits of a percentage") {
    CHECK(percent(0) == "0");
    CHECK(percent(0.000314) == "0.031");
    CHECK(percent(0.0996) == "10");
    CHECK(percent(0.123) == "12");
    CHECK(percent(1e-9) == "< 0.0001");
    CHECK(percent(40) == "> 1000");
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("advice");

TEST_CASE("terms whose coefficients are zero are left out, and change nothing") {
    Air air = preset("earth");
    air.atmosphere.mie_scattering = Vector(0.0);
    air.atmosphere.mie_absorption = Vector(0.0);
    air.atmosphere.ozone_absorption = Vector(0.0);
    const Advice advice = answer(question(air, day)).advice;
    CHECK_FALSE(advice.setting.mie);
    CHECK(advice.setting.ozone == airlight::ozone_none);
    CHECK_FALSE(advice.setting.planet_shadow);  // by day
    for (const Contribution& term : advice.terms) {
        if (term.name == mie_name || term.name == ozone_name) {
            CHECK(term.change.worst <= 1e-12);  // a term off is a term of zero, to rounding
        }
    }
}

TEST_CASE("terms that matter stay on, and a smaller tolerance never saves more") {
    Question asked = question(preset("earth"), day);
    int before = 0;
    for (const double tolerance : {0.3, 0.03, 0.003, 0.0003}) {
        asked.tolerance = tolerance;
        const Advice advice = answer(asked).advice;
        CHECK(advice.change.worst <= tolerance);
        CHECK(work_of(advice.setting) >= before);
        before = work_of(advice.setting);
    }
    CHECK(before > 4 * 3);  // 4 nodes of three layers are no 0.03 %
}

TEST_CASE("what is good alone and too much together is backed off from") {
    // A thin haze and as thin an ozone: each is worth nearly the tolerance, both have the same sign.
    Question asked = question(preset("earth"), {{10000, 10000}, {20, 90}, {100, inf}});
    asked.air.atmosphere.mie_scattering = Vector(0.0);
    asked.air.atmosphere.mie_absorption = 1e-5 * Vector(1.0);
    asked.by = By::p95;
    const Advice first = answer(asked).advice;
    asked.tolerance = 1.05 * std::max(first.terms[0].change.p95, first.terms[1].change.p95);
    const Advice advice = answer(asked).advice;
    CHECK_FALSE(advice.each.mie);
    CHECK(advice.each.ozone == airlight::ozone_none);
    CHECK(advice.each_change.p95 > asked.tolerance);
    CHECK(advice.change.p95 <= asked.tolerance);
    const bool keeps_one = advice.setting.mie || advice.setting.ozone != airlight::ozone_none;
    CHECK(keeps_one);
    CHECK(report(asked, answer(asked)).find("is too much together") != std::string::npos);
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("warnings");

TEST_CASE("the presets by day give no warning but for what they are") {
    for (const std::string& name : preset_names()) {
        CAPTURE(name);
        const Air air = preset(name);
        Setting setting;
        setting.ozone = air.ozone;
        CHECK(warnings_of(air.atmosphere, setting).empty());
        CHECK(warnings_of(air.atmosphere, day).empty());
    }
}

TEST_CASE("mistaken units are suspected") {
    const Atmosphere earth = airlight::earth<double>();
    Atmosphere air = earth;
    air.rayleigh_scattering *= 1000.0;
    CHECK(any_has(warnings_of(air, Setting{}), "coefficients per kilometre"));
    CHECK(any_has(warnings_of(airlight::rescaled(earth, 1e-3), Setting{}), "ground's radius is 6.36e+03 m"));
    air = earth;
    air.ozone_absorption *= 1e-6;
    CHECK(any_has(warnings_of(air, Setting{}), "too little to be seen"));
    air = earth;
    air.rayleigh_scale_height = 1e7;
    CHECK(any_has(warnings_of(air, Setting{}), "larger than the ground's radius"));
    air = earth;
    air.top_altitude = 10e3;
    CHECK(any_has(warnings_of(air, Setting{}), "much of the layer is cut off"));
    CHECK(any_has(warnings_of(air, Setting{}), "ozone's centre"));
    air = earth;
    air.ground_albedo = Vector(1.5);
    CHECK(any_has(warnings_of(air, Setting{}), "ground_albedo"));
}

TEST_CASE("an aerosol that scatters only forwards is named") {
    Atmosphere air = airlight::earth<double>();
    air.mie_g = 0.99;
    CHECK(any_has(warnings_of(air, Setting{}), "mie_g = 0.99 is close to 1"));
    air.mie_g = 0.9;
    CHECK_FALSE(any_has(warnings_of(air, Setting{}), "mie_g"));
}

TEST_CASE("cameras under ground and suns that never rise") {
    const Atmosphere earth = airlight::earth<double>();
    CHECK(any_has(warnings_of(earth, Ranges{{-5, 10}, {0, 10}, {1, 10}}), "5 m under ground"));
    CHECK(any_has(warnings_of(earth, Ranges{{0, 10}, {-20, -5}, {1, 10}}), "below every camera's horizon"));
    CHECK_FALSE(any_has(warnings_of(earth, Ranges{{0, 400e3}, {-20, -5}, {1, 10}}), "horizon"));
}

TEST_CASE("light that a half float does not hold, and night") {
    Question asked = question(preset("earth"), {{0, 10}, {-20, -12}, {1e5, inf}});
    const std::vector<std::string> night = answer(asked).warnings;
    CHECK(any_has(night, "radiance per unit of sunlight lies below 6e-8"));
    CHECK(any_has(night, "darker than a ten thousandth"));
    asked = question(preset("earth"), day);
    asked.air.atmosphere.rayleigh_scattering *= 10.0;
    CHECK(any_has(answer(asked).warnings, "transmittance lies below 6e-8"));
    CHECK_FALSE(
        any_has(answer(question(preset("earth"), {{0, 10}, {30, 60}, {100, 1e4}})).warnings, "half float"));
}

TEST_CASE("a bank of fog that lies between the nodes is seen") {
    Question asked = question(preset("earth"), {{1000, 9000}, {30, 60}, {1e6, inf}});
    asked.air.atmosphere.mie_scale_height = 2.0;
    CHECK(any_has(answer(asked).warnings, "the aerosol's layer is thinner than the spacing"));
    CHECK_FALSE(any_has(answer(question(preset("earth"), day)).warnings, "thinner"));
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("emit");

TEST_CASE("every flag stands in both languages") {
    Setting setting;
    setting.mie = false;
    setting.ozone = airlight::ozone_lorentzian;
    setting.mie_phase = airlight::phase_fog;
    setting.planet_shadow = false;
    setting.nodes = 6;
    CHECK(cpp_text(setting, "Mine", "Why.\nMore.") ==
          "#include <airlight/scene.hpp>\n\n/// Why.\n/// More.\nstruct Mine : airlight::DefaultScene {\n"
          "    static constexpr bool mie = false;\n"
          "    static constexpr int ozone = airlight::ozone_lorentzian;\n"
          "    static constexpr int mie_phase = airlight::phase_fog;\n"
          "    static constexpr bool planet_shadow = false;\n"
          "    static constexpr int nodes = 6;\n};\n");
    CHECK(glsl_text(setting, "Why.") ==
          "// Why.\n#define AIRLIGHT_MIE 0\n#define AIRLIGHT_OZONE AIRLIGHT_OZONE_LORENTZIAN\n"
          "#define AIRLIGHT_MIE_PHASE AIRLIGHT_PHASE_FOG\n#define AIRLIGHT_PLANET_SHADOW 0\n"
          "#define AIRLIGHT_NODES 6\n");
}

TEST_SUITE_END();
