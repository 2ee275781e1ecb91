// Single scattering for any view of any planet.
#include "scattering_promises.hpp"

#include "fuzz.hpp"

namespace {

struct Check {
    template <typename T>
    void run(airlight_test::Verdict& all, airlight_fuzz::FuzzDraws& draw) const {
        const airlight_test::Marched marched{1 + draw.below(8)};
        airlight_test::check_any_view<T>(all, draw, marched);
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return airlight_fuzz::check_bytes(data, size, Check{});
}
