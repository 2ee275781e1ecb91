// Single scattering for any view of any planet.
#include "scattering_promises.hpp"

#include "fuzz.hpp"

namespace {

struct Check {
    template <typename T>
    void run(airlight_test::Verdict& all, airlight_fuzz::FuzzDraws& draw) const {
        switch (draw.below(5)) {
            case 0:
                return airlight_test::check_any_view<T>(all, draw, airlight_test::Marched{1 + draw.below(8)});
            case 1:
                return airlight_test::check_any_view<T>(all, draw, airlight_test::ByNodes<4>{});
            case 2:
                return airlight_test::check_any_view<T>(all, draw, airlight_test::ByNodes<24>{});
            case 3: {
                const int pieces = 1 + draw.below(8);
                return airlight_test::check_any_view<T>(all, draw,
                                                        airlight_test::ByShafts{pieces, 1 + draw.below(4)});
            }
            default:
                return airlight_test::check_any_view<T>(all, draw, airlight_test::ByNodes<8>{});
        }
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return airlight_fuzz::check_bytes(data, size, Check{});
}
