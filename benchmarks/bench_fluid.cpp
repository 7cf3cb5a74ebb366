/// Rates of the fluid's time step beside what the memory of this machine can do, in one run. Where other work shares
/// the memory its rate wanders within seconds, so every measurement is short (some 0.2 s) and stands between its own
/// two probes; a ratio is the median over rounds of the ratio of neighbours, printed with its quartiles.
///
/// usage: bench_fluid [cells along an edge, default 200] [rounds, default 25]
/// Probes, arrays of 4 GiB: (a) one array read and written in place, (b) 19 streams read and written in place, as rates
/// of cells at 304 bytes each.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "stresslet/exec/huge_array.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/exec/timer.hpp"
#include "stresslet/lattice/fluid.hpp"

namespace stresslet {
namespace {

constexpr double bytes_per_cell = 304;
constexpr std::size_t streams = 19;

struct Line {
  std::string name;
  ThreadTeam& team;
  std::function<double()> rate;  ///< cells a second
  std::vector<double> found{}, to_probe_a{}, to_probe_b{};
};

/// Lower quartile, median, upper quartile.
std::array<double, 3> quartiles(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) { return values[std::size_t(share * double(values.size() - 1) + 0.5)]; };
  return {at(0.25), at(0.5), at(0.75)};
}

/// Rate of reading and writing `count` streams of `length` doubles each in place, a cache line of each in turn.
double probe(ThreadTeam& team, double* memory, std::size_t count, std::size_t length) {
  const Timer timer;
  team.run([&](Member& member) {
    constexpr std::size_t line = cache_line / sizeof(double);
    const Range mine = member.share(length, line);
    for (std::size_t k = mine.begin; k < mine.end; k += line)
      for (std::size_t s = 0; s < count; ++s)
        for (std::size_t n = 0; n < line; n += pack_width) {
          double* at = memory + s * length + k + n;
          store(at, load(at) * 0.5 + 0.5);
        }
  });
  return 2.0 * double(count * length * sizeof(double)) / timer.seconds() / bytes_per_cell;
}

class PeriodicBox {
 public:
  PeriodicBox(int edge, const std::string& collision, bool single_precision, int blocks_per_edge, int threads)
      : team_(threads), cells_(double(edge) * edge * edge) {
    FluidSetup setup;
    setup.grid.size = {edge, edge, edge};
    setup.grid.blocks = {blocks_per_edge, blocks_per_edge, blocks_per_edge};
    setup.collision = collision;
    setup.single_precision = single_precision;
    setup.rates.relaxation_time = 0.8;
    fluid_ = Fluid::make(setup);
    fluid_->initialise(team_, [](const Cells&) { return CellState{}; });
    fluid_->advance(team_, 2);
  }
  double rate() {
    constexpr int steps = 2;
    const Timer timer;
    fluid_->advance(team_, steps);
    return cells_ * steps / timer.seconds();
  }
  double bytes_per_cell() const { return double(fluid_->bytes()) / cells_; }

 private:
  ThreadTeam team_;
  double cells_;
  std::unique_ptr<Fluid> fluid_;
};

void run(int edge, int rounds) {
  ThreadTeam two(2), one(1);
  const HugeArray<double> memory((std::size_t(4) << 30) / sizeof(double));
  const std::size_t stream = memory.size() / streams / 8 * 8;
  PeriodicBox bgk(edge, "BGK", false, 1, 2), trt(edge, "TRT", false, 1, 2), mrt(edge, "MRT", false, 1, 2);
  PeriodicBox bgk_one(edge, "BGK", false, 1, 1), trt_one(edge, "TRT", false, 1, 1);
  PeriodicBox single(edge, "BGK", true, 1, 2), blocks(edge, "BGK", false, 2, 2);
  std::vector<Line> lines{
      {"BGK FP64, 2 threads", two, [&] { return bgk.rate(); }},
      {"TRT FP64, 2 threads", two, [&] { return trt.rate(); }},
      {"MRT FP64, 2 threads", two, [&] { return mrt.rate(); }},
      {"BGK FP64, 8 blocks", two, [&] { return blocks.rate(); }},
      {"BGK FP32, 2 threads", two, [&] { return single.rate(); }},
      {"BGK FP64, 1 thread", one, [&] { return bgk_one.rate(); }},
      {"TRT FP64, 1 thread", one, [&] { return trt_one.rate(); }},
  };
  for (int round = 0; round <= rounds; ++round)
    for (Line& line : lines) {
      const double a = probe(line.team, memory.data(), 1, memory.size());
      const double rate = line.rate();
      const double b = probe(line.team, memory.data(), streams, stream);
      if (round == 0) continue;  // touches the memory
      line.found.push_back(rate);
      line.to_probe_a.push_back(rate / a);
      line.to_probe_b.push_back(rate / b);
    }
  const double reference = quartiles(lines[0].to_probe_a)[1];
  fmt::print("{} cells cubed, {} rounds; D3Q19; {:.1f} bytes per cell FP64, {:.1f} FP32\n", edge, rounds,
             bgk.bytes_per_cell(), single.bytes_per_cell());
  fmt::print("{:<22}{:>12}{:>10}{:>22}{:>22}{:>12}\n", "", "best MLUPS", "median", "/ probe a", "/ probe b",
             "/ first line");
  const auto text = [](const std::vector<double>& ratios) {
    const auto [lower, middle, upper] = quartiles(ratios);
    return fmt::format("{:.2f} ({:.2f}-{:.2f})", middle, lower, upper);
  };
  for (const Line& line : lines)
    fmt::print("{:<22}{:>12.1f}{:>10.1f}{:>22}{:>22}{:>12.2f}\n", line.name,
               1e-6 * *std::max_element(line.found.begin(), line.found.end()), 1e-6 * quartiles(line.found)[1],
               text(line.to_probe_a), text(line.to_probe_b), quartiles(line.to_probe_a)[1] / reference);
}

}  // namespace
}  // namespace stresslet

int main(int argc, char** argv) {
  const auto argument = [&](int k, int otherwise) {
    return argc > k && argv[k][0] != '-' ? std::atoi(argv[k]) : otherwise;
  };
  stresslet::run(argument(1, 200), argument(2, 25));
}
