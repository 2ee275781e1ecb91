#include <doctest/doctest.h>
#include <airlight/scene.hpp>

TEST_SUITE_BEGIN("scene");

namespace {
struct Dry : airlight::DefaultScene {
    static constexpr int ozone = airlight::ozone_none;
};
}  // namespace

TEST_CASE("the default scene has aerosol, a tent of ozone, the planet's shadow and eight nodes") {
    CHECK(airlight::DefaultScene::mie);
    CHECK(airlight::DefaultScene::ozone == airlight::ozone_tent);
    CHECK(airlight::DefaultScene::mie_phase == airlight::phase_cornette_shanks);
    CHECK(airlight::DefaultScene::planet_shadow);
    CHECK(airlight::DefaultScene::nodes == 8);
}

TEST_CASE("a derived scene changes one term and keeps the others") {
    CHECK(Dry::ozone == airlight::ozone_none);
    CHECK(Dry::mie == airlight::DefaultScene::mie);
}

TEST_CASE("choices of one kind have different numbers") {
    CHECK(airlight::ozone_none != airlight::ozone_tent);
    CHECK(airlight::ozone_tent != airlight::ozone_lorentzian);
    CHECK(airlight::ozone_none != airlight::ozone_lorentzian);
    CHECK(airlight::phase_cornette_shanks != airlight::phase_henyey_greenstein);
    CHECK(airlight::phase_henyey_greenstein != airlight::phase_fog);
    CHECK(airlight::phase_cornette_shanks != airlight::phase_fog);
}

TEST_CASE_TEMPLATE("without a hook every place is lit in full", T, float, double, long double) {
    CHECK(airlight::AlwaysLit{}(airlight::vec3<T>(T(1), T(-2), T(3e9))) == T(1));
}

TEST_SUITE_END();
