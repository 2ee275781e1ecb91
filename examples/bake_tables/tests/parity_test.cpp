// Whether the GPU fills the same tables as the CPU.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "kinds.hpp"
#include "support/command_line.hpp"
#include "support/error.hpp"
#include "support/gl_context.hpp"

namespace {

using namespace bake_tables;

std::unique_ptr<support::GlContext> open_context() {
    try {
        return std::make_unique<support::GlContext>(4, 3);
    } catch (const support::Error& error) {
        if (support::environment_asks({"CI", "AIRLIGHT_REQUIRE_GL"})) {
            throw;
        }
        std::cout << "skipped: " << error.what() << "\n(set AIRLIGHT_REQUIRE_GL=1 to make this a failure)\n";
        return nullptr;
    }
}

/// Small, and odd where the table allows it.
support::TableSize small_size(const Kind& kind) {
    const auto side = [](int full, int small) { return full == 1 ? 1 : small; };
    return {side(kind.size.width, kind.small_size.width), side(kind.size.height, kind.small_size.height),
            side(kind.size.depth, kind.small_size.depth)};
}

/// How many numbers lie between two halves; 0 and the smallest are neighbours.
long half_steps(float a, float b) {
    const auto place = [](float x) {
        int exponent = 0;
        const float size = std::fabs(x);
        std::frexp(size, &exponent);
        const int lowest = std::max(exponent, -13);  // of the smallest normal half, 2^-14
        const long within = std::lround(std::ldexp(double(size), 11 - lowest));
        const long at = long(lowest + 13) * 1024 + within;
        return x < 0 ? -at : at;
    };
    return std::labs(place(a) - place(b));
}

bool same_on_gpu(const Kind& kind, const support::Preset& preset) {
    const Request request{preset, small_size(kind), 3};
    const Numbers cpu = kind.on_cpu(request, Rows{});
    const std::vector<double> exact = kind.in_double(request, Rows{});
    GpuBaker baker(preset);
    const Numbers gpu = kind.on_gpu(request, baker);

    // What roundoff does to this table is what float loses against double. The GPU rounds as often, and its
    // exp is off by up to 4e-6 of a term (docs/accuracy.md); a texel multiplies at most three of them in an
    // order.
    double largest = 0;
    double float_error = 0;
    double worst = 0;
    std::size_t at = 0;
    for (std::size_t n = 0; n < exact.size(); ++n) {
        largest = std::max(largest, std::fabs(exact[n]));
        float_error = std::max(float_error, std::fabs(double(cpu[n]) - exact[n]));
    }
    bool halves = true;
    std::size_t other_half = 0;
    for (std::size_t n = 0; n < cpu.size(); ++n) {
        const double off = std::fabs(double(gpu[n]) - double(cpu[n]));
        if (!(off <= worst)) {
            worst = off;
            at = n;
        }
        // One half or the next: where the floats differ, rounding may part them.
        const float a = support::rounded_to_half(cpu[n]);
        const float b = support::rounded_to_half(gpu[n]);
        other_half += a == b ? 0 : 1;
        halves = halves && half_steps(a, b) <= 1;
    }
    const int orders = kind.has_orders ? request.orders : 1;
    const double bound = 4 * float_error + 3 * 4e-6 * orders * largest;
    const bool passed = gpu.size() == cpu.size() && worst <= bound && halves;
    std::printf("%-24s%-8s worst %.3g of %.3g (bound %.3g), %zu of %zu halves differ: %s\n",
                kind.name.c_str(), preset.name.c_str(), worst, largest, bound, other_half, cpu.size(),
                passed ? "passed" : "FAILED");
    if (!passed) {
        std::printf("    number %zu: CPU %.9g, GPU %.9g, double %.17g\n", at, double(cpu[at]),
                    double(gpu[at]), exact[at]);
    }
    return passed;
}

}  // namespace

int main() {
    try {
        const std::unique_ptr<support::GlContext> context = open_context();
        if (context == nullptr) {
            return support::skipped;
        }
        std::printf("%s\n", context->renderer().c_str());
        bool passed = true;
        for (const Kind& kind : kinds()) {
            for (const support::Preset& preset : support::presets()) {
                if (preset.name != "cs562" &&
                    preset.name != "elek") {  // they differ from earth by numbers only
                    passed = same_on_gpu(kind, preset) && passed;
                }
            }
        }
        return passed ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "parity_test: " << error.what() << "\n";
        return 1;
    }
}
