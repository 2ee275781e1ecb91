#pragma once

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "inputs.hpp"

namespace cpu_bench {

/// Calls in one iteration. Their inputs and results fit into a core's second-level cache.
constexpr int batch_size = 1024;

/// Times `call` on a batch of inputs that `draw_inputs` makes of a Draw, storing every result.
template <typename T, typename DrawInputs, typename Call>
void run_batch(benchmark::State& state, const DrawInputs& draw_inputs, const Call& call) {
    using Inputs = decltype(draw_inputs(std::declval<Draw<T>&>()));
    using Result = decltype(call(std::declval<const Inputs&>()));
    Draw<T> draw;
    std::vector<Inputs> inputs;
    for (int i = 0; i < batch_size; ++i) {
        draw.next();
        inputs.push_back(draw_inputs(draw));
    }
    const auto results = std::make_unique<Result[]>(batch_size);
    for (auto _ : state) {
        benchmark::DoNotOptimize(inputs.data());  // else what does not change could be hoisted
        for (std::size_t i = 0; i < batch_size; ++i) {
            results[i] = call(inputs[i]);
        }
        benchmark::DoNotOptimize(results.get());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * batch_size);
    state.counters["per_call"] = benchmark::Counter(
        batch_size, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Something that the compiler must take as it is at run time.
template <typename Value>
Value opaque(Value value) {
    benchmark::DoNotOptimize(value);
    return value;
}

/// Enter the benchmarks of one scalar type, and add their names; written by write_benchmarks.
void add_float(std::vector<std::string>& names);
void add_double(std::vector<std::string>& names);

}  // namespace cpu_bench
