/// Times of the lubricated simulation, kernel by kernel and whole. What the lines mean: benchmarks/README.md.
///
/// Arguments of every line: particles, threads. A kernel runs many times inside one start of the thread team, as in a
/// run; the counters take bytes and flops from the kernel's header.
#include <benchmark/benchmark.h>

#include <functional>
#include <string>

#include "machine_probes.hpp"
#include "prepared_suspension.hpp"
#include "stresslet/simulation/neighbours.hpp"
#include "stresslet/simulation/step.hpp"

namespace stresslet::benchmarks {

namespace {

using benchmark::Counter;

/// Memory traffic and arithmetic of one call.
struct Work {
  double bytes = 0, flops = 0;
};

void count(benchmark::State& state, const Suspension& s, double calls, const Work& work) {
  const double pairs = double(s.pairs.size());
  const auto rate = [&](double items) { return Counter(calls * items, Counter::kIsIterationInvariantRate); };
  const auto time = [&](double items) {
    return Counter(calls * items, Counter::kIsIterationInvariantRate | Counter::kInvert);
  };
  state.counters["s/pair"] = time(pairs);
  state.counters["s/particle"] = time(double(s.state.size()));
  state.counters["pairs/s"] = rate(pairs);
  if (work.bytes > 0) state.counters["bytes/s"] = rate(work.bytes);
  if (work.flops > 0) state.counters["flop/s"] = rate(work.flops);
}

using Kernel = std::function<void(Member&, Suspension&)>;

void time_kernel(benchmark::State& state, const Kernel& kernel, const std::function<Work(const Suspension&)>& work) {
  ThreadTeam team(int(state.range(1)));
  Suspension s = prepared(std::size_t(state.range(0)));
  const int calls = int(std::max<std::int64_t>(1, 64000 / state.range(0)));
  for (auto _ : state)
    team.run([&](Member& member) {
      for (int k = 0; k < calls; ++k) kernel(member, s);
    });
  count(state, s, calls, work(s));
}

void find_pairs(Member& member, Suspension& s) { s.pairs.update(member, s.list, s.state, s.box); }

Work work_of_finding(const Suspension& s) {
  const double candidates = double(s.list.size()), pairs = double(s.pairs.size());
  return {20 * candidates + 156 * pairs, 29 * candidates + 11 * pairs};
}

void find_coefficients(Member& member, Suspension& s) {
  s.lubrication.update(member, s.physics.lubrication_law, s.physics.cutoffs, s.pairs, s.box);
}

Work work_of_coefficients(const Suspension& s) { return {88 * double(s.pairs.size()), 90 * double(s.pairs.size())}; }

void apply(Member& member, Suspension& s) { s.lubrication.apply<false>(member, s.pairs, s.velocity); }

Work work_of_apply(const Suspension& s) {
  return {PairLubrication::bytes_per_pair * double(s.pairs.size()),
          PairLubrication::flops_per_pair * double(s.pairs.size())};
}

/// The operator as conjugate gradients use it: every particle adds up the wrenches of its pairs.
void apply_and_add(Member& member, Suspension& s) {
  apply(member, s);
  const Range mine = member.share(s.state.size(), sum_chunk);
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    Twist<double> wrench{};
    s.lubrication.add_to(i, s.pairs, wrench);
    s.residual.set(i, wrench);
  }
  member.barrier();
}

Work work_of_apply_and_add(const Suspension& s) {
  Work work = work_of_apply(s);
  const double pairs = double(s.pairs.size());
  work.bytes += (PairLubrication::wrench_bytes + 4) * pairs + 64 * double(s.state.size());
  work.flops += 12 * pairs;
  return work;
}

void touch(Member& member, Suspension& s) {
  s.contacts.update(member, s.physics.contact, s.pairs, {s.velocity, s.velocity}, s.state, s.box.velocity_jump(), 0.0,
                    s.history);
}

double contact_count(const Suspension& s) {
  double contacts = 0;
  for (std::size_t p = 0; p < s.pairs.size(); ++p) contacts += s.pairs.gap[p] < 0;
  return contacts;
}

Work work_of_contacts(const Suspension& s) {
  return {12 * double(s.pairs.size()) + 450 * contact_count(s), 60 * contact_count(s)};
}

void list_build(benchmark::State& state) {
  ThreadTeam team(int(state.range(1)));
  Suspension s = prepared(std::size_t(state.range(0)));
  for (auto _ : state) s.list.build(team, s.state, s.box);
  count(state, s, 1, {});
  state.counters["candidates"] = double(s.list.size());
}

void rebuild(benchmark::State& state) {
  ThreadTeam team(int(state.range(1)));
  Suspension s = prepared(std::size_t(state.range(0)));
  for (auto _ : state) {
    s.builds = 1;  // no sorting
    rebuild_neighbours(s, team);
  }
  count(state, s, 1, {});
}

void full_step(benchmark::State& state, const std::string& scheme) {
  ThreadTeam team(int(state.range(1)));
  Suspension s = prepared_for(std::size_t(state.range(0)), scheme, team);
  const std::int64_t builds = s.builds;
  double iterations = 0;
  for (auto _ : state) {
    step(s, team);
    iterations += s.solver_report.iterations;
  }
  count(state, s, 1, {});
  if (scheme != "explicit") state.counters["iterations"] = Counter(iterations, Counter::kAvgIterations);
  state.counters["steps/build"] = double(state.iterations()) / std::max(1.0, double(s.builds - builds));
  state.counters["s/strain"] = Counter(s.time.step, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void full_sample(benchmark::State& state) {
  ThreadTeam team(int(state.range(1)));
  const Suspension s = prepared(std::size_t(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(sample(s, team));
  count(state, s, 1, {});
}

void register_all() {
  const auto add = [](const char* name, auto&& body) {
    for (const int particles : {1000, 2000, 16000, 128000})
      for (const int threads : {1, 2})
        benchmark::RegisterBenchmark(name, body)
            ->Args({particles, threads})
            ->ArgNames({"N", "threads"})
            ->UseRealTime()
            ->Unit(benchmark::kMicrosecond);
  };
  const auto add_kernel = [&](const char* name, const Kernel& kernel, Work (*work)(const Suspension&)) {
    add(name, [=](benchmark::State& state) { time_kernel(state, kernel, work); });
  };
  for (const int threads : {1, 2}) {
    benchmark::RegisterBenchmark("probe/memory", memory_bandwidth)->Args({1 << 30, threads})->UseRealTime();
    benchmark::RegisterBenchmark("probe/flops", flop_rate)->Args({threads})->UseRealTime();
  }
  add("VerletList::build", list_build);
  add("rebuild_neighbours", rebuild);
  add_kernel("ActivePairs::update", find_pairs, work_of_finding);
  add_kernel("PairLubrication::update", find_coefficients, work_of_coefficients);
  add_kernel("PairLubrication::apply", apply, work_of_apply);
  add_kernel("PairLubrication::apply+add_to", apply_and_add, work_of_apply_and_add);
  add_kernel("ContactForces::update", touch, work_of_contacts);
  add("step/explicit", [](benchmark::State& state) { full_step(state, "explicit"); });
  add("step/semi-implicit", [](benchmark::State& state) { full_step(state, "semi-implicit"); });
  add("sample", full_sample);
}

}  // namespace

}  // namespace stresslet::benchmarks

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  stresslet::benchmarks::register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
