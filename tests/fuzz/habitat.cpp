// The air and the lights of a habitat, lamps in fog.
#include "habitat_promises.hpp"

#include "fuzz.hpp"

namespace {

struct Check {
    template <typename T>
    void run(airlight_test::Verdict& all, airlight_fuzz::FuzzDraws& draw) const {
        airlight_test::check_any_habitat<T>(all, draw);
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return airlight_fuzz::check_bytes(data, size, Check{});
}
