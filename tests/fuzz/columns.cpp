// Columns, optical depths and transmittances along any ray.
#include "column_promises.hpp"

#include "fuzz.hpp"

namespace {

struct Check {
    template <typename T>
    void run(airlight_test::Verdict& all, airlight_fuzz::FuzzDraws& draw) const {
        airlight_test::check_any_ray<T>(all, draw);
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return airlight_fuzz::check_bytes(data, size, Check{});
}
