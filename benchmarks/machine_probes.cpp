#include "machine_probes.hpp"

#include <array>

#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/exec/thread_team.hpp"

namespace stresslet::benchmarks {

void memory_bandwidth(benchmark::State& state) {
  ThreadTeam team(int(state.range(1)));
  const std::size_t count = std::size_t(state.range(0)) / sizeof(double);
  AlignedVector<double> array(count, 1.0);
  for (auto _ : state) {
    team.run([&](Member& member) {
      const Range mine = member.share(count, pack_width);
      for (std::size_t k = mine.begin; k < mine.end; k += pack_width) store(&array[k], load(&array[k]) * 0.5 + 0.5);
    });
    benchmark::ClobberMemory();
  }
  state.counters["bytes/s"] =
      benchmark::Counter(2.0 * double(state.range(0)), benchmark::Counter::kIsIterationInvariantRate);
}

void flop_rate(benchmark::State& state) {
  constexpr std::size_t chains = 12, length = 1 << 20;
  ThreadTeam team(int(state.range(0)));
  std::vector<double> results(std::size_t(team.size()));
  const volatile double start = 0.5;
  for (auto _ : state) {
    team.run([&](Member& member) {
      const Pack factor = start, shift = start;
      std::array<Pack, chains> x;
      x.fill(Pack(double(start)));
      for (std::size_t n = 0; n < length; ++n)
        for (Pack& chain : x) chain = chain * factor + shift;
      Pack sum = 0.0;
      for (const Pack& chain : x) sum += chain;
      results[std::size_t(member.rank())] = stdx::reduce(sum);
    });
    benchmark::DoNotOptimize(results.data());
    benchmark::ClobberMemory();
  }
  state.counters["flop/s"] = benchmark::Counter(double(2 * chains * length * pack_width) * double(team.size()),
                                                benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace stresslet::benchmarks
