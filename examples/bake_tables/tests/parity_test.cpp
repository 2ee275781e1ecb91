// Whether the GPU fills the same tables as the CPU.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "kinds.hpp"
#include "support/gl_test.hpp"

namespace {

using namespace bake_tables;

/// Small, and odd where the table allows it.
support::TableSize small_size(const Kind& kind) {
    const auto side = [](int full, int small) { return full == 1 ? 1 : small; };
    return {side(kind.size.width, kind.small_size.width), side(kind.size.height, kind.small_size.height),
            side(kind.size.depth, kind.small_size.depth)};
}

/// The distance between halves of this size.
double half_step(float size) {
    int exponent = 0;
    std::frexp(std::fabs(size), &exponent);
    return std::ldexp(1.0, std::max(exponent, -13) - 11);  // 2^-14 is the smallest normal half
}

/// The largest that each channel has, and what float loses of it against double.
struct Channel {
    double largest = 0;
    double float_error = 0;
};

bool same_on_gpu(const Kind& kind, const support::Preset& preset, bool software) {
    const Request request{preset, small_size(kind), 3};
    const Numbers cpu = kind.on_cpu(request, support::Rows{});
    const std::vector<double> exact = kind.in_double(request, support::Rows{});
    GpuBaker baker(preset);
    const Numbers gpu = kind.on_gpu(request, baker);
    if (gpu.size() != cpu.size()) {
        std::printf("%s: %zu numbers on the CPU, %zu on the GPU\n", kind.name.c_str(), cpu.size(),
                    gpu.size());
        return false;
    }

    const std::size_t count = kind.channels.size();
    const std::size_t slice = std::size_t(request.size.width) * std::size_t(request.size.height) * count;
    // Layers are channels too.
    const auto channel_of = [&](std::size_t n) {
        return kind.layered ? n / slice * count + n % count : n % count;
    };
    std::vector<Channel> channels(kind.layered ? exact.size() / slice * count : count);
    for (std::size_t n = 0; n < exact.size(); ++n) {
        Channel& channel = channels[channel_of(n)];
        channel.largest = std::max(channel.largest, std::fabs(exact[n]));
        channel.float_error = std::max(channel.float_error, std::fabs(double(cpu[n]) - exact[n]));
    }
    // Software GL computes in the order of C++ but for its exp, which is off by up to 4e-6 of a term
    // (docs/accuracy.md); a texel multiplies at most three of them in an order. Hardware rounds on its own
    // too, so that a table may lose as much again as float loses against double, and does not lose alike. The
    // same goes for numbers of either sign, sums in which terms cancel.
    const int orders = kind.has_orders ? request.orders : 1;
    const auto bound = [&](const Channel& channel) {
        return 3 * 4e-6 * orders * channel.largest +
               (software && !kind.may_be_negative ? 0.0 : 4 * channel.float_error);
    };
    bool passed = true;
    double worst = 0;
    std::size_t at = 0;
    std::size_t other_half = 0;
    for (std::size_t n = 0; n < cpu.size(); ++n) {
        const double off = std::fabs(double(gpu[n]) - double(cpu[n]));
        const double share = off / std::max(bound(channels[channel_of(n)]), 1e-30);
        if (!(share <= worst)) {
            worst = share;
            at = n;
        }
        // One half or the next: where the floats differ, rounding may part them by a step.
        const float a = support::rounded_to_half(cpu[n]);
        const float b = support::rounded_to_half(gpu[n]);
        other_half += a == b ? 0 : 1;
        passed =
            passed && std::fabs(double(a) - double(b)) <=
                          half_step(std::max(std::fabs(a), std::fabs(b))) + bound(channels[channel_of(n)]);
    }
    passed = passed && worst <= 1;
    const Channel& channel = channels[channel_of(at)];
    std::printf("%-24s%-8s worst %.3g of %.3g (bound %.3g), %zu of %zu halves differ: %s\n",
                kind.name.c_str(), preset.name.c_str(), std::fabs(double(gpu[at]) - double(cpu[at])),
                channel.largest, bound(channel), other_half, cpu.size(), passed ? "passed" : "FAILED");
    if (!passed) {
        std::printf("    %s of texel %zu: CPU %.9g, GPU %.9g, double %.17g\n",
                    kind.channels[at % count].c_str(), at / count, double(cpu[at]), double(gpu[at]),
                    exact[at]);
    }
    return passed;
}

}  // namespace

int main() {
    try {
        const std::unique_ptr<support::GlContext> context = support::open_context();
        if (context == nullptr) {
            return support::skipped;
        }
        std::printf("%s\n", context->renderer().c_str());
        const bool software = support::is_software(context->renderer());
        bool passed = true;
        for (const Kind& kind : kinds()) {
            for (const support::Preset& preset : support::presets()) {
                if (preset.name != "cs562" &&
                    preset.name != "elek") {  // they differ from earth by numbers only
                    passed = same_on_gpu(kind, preset, software) && passed;
                }
            }
        }
        return passed ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "parity_test: " << error.what() << "\n";
        return 1;
    }
}
