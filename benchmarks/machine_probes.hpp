#pragma once
/// What the machine can do at most, measured beside the kernels: the bounds that their rates are compared with.
#include <benchmark/benchmark.h>

namespace stresslet::benchmarks {

/// Reads and writes in place one array of `bytes` (argument 0) with the threads of argument 1; rate in bytes moved.
void memory_bandwidth(benchmark::State& state);

/// Independent chains of multiply-adds in registers, argument 0 threads; rate in flops, a multiply-add being two.
void flop_rate(benchmark::State& state);

}  // namespace stresslet::benchmarks
