/// Rates of the fluid's time step beside what the memory of this machine can do, in one run: every round measures each
/// line once, and a line's ratio to a probe is the median over rounds of the ratio within a round, so that a machine
/// that slows down meanwhile slows both.
///
/// usage: bench_fluid [cells along an edge, default 200] [rounds, default 9]
/// Probes, arrays of 4 GiB: (a) one array read and written in place, (b) 19 streams read and written in place, as rates
/// of cells at 304 bytes each.
#include <fmt/format.h>

#include <algorithm>
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
  std::function<double()> rate;  ///< cells a second
  std::vector<double> found{};
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
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
    constexpr int steps = 6;
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
  constexpr std::size_t single_thread = 7;  // from this line on; the first lines of each part are what others refer to
  std::vector<Line> lines{
      {"probe a, 2 threads", [&] { return probe(two, memory.data(), 1, memory.size()); }},
      {"probe b, 2 threads", [&] { return probe(two, memory.data(), streams, stream); }},
      {"BGK FP64, 2 threads", [&] { return bgk.rate(); }},
      {"TRT FP64, 2 threads", [&] { return trt.rate(); }},
      {"MRT FP64, 2 threads", [&] { return mrt.rate(); }},
      {"BGK FP64, 8 blocks", [&] { return blocks.rate(); }},
      {"BGK FP32, 2 threads", [&] { return single.rate(); }},
      {"probe a, 1 thread", [&] { return probe(one, memory.data(), 1, memory.size()); }},
      {"probe b, 1 thread", [&] { return probe(one, memory.data(), streams, stream); }},
      {"BGK FP64, 1 thread", [&] { return bgk_one.rate(); }},
      {"TRT FP64, 1 thread", [&] { return trt_one.rate(); }},
  };
  for (int round = 0; round <= rounds; ++round)
    for (Line& line : lines) {
      const double rate = line.rate();
      if (round > 0) line.found.push_back(rate);  // the first round touches memory
    }
  const auto ratio = [&](const Line& line, std::size_t reference) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < line.found.size(); ++k) ratios.push_back(line.found[k] / lines[reference].found[k]);
    return median(ratios);
  };
  fmt::print("{} cells cubed, {} rounds; D3Q19; {:.1f} bytes per cell FP64, {:.1f} FP32\n", edge, rounds,
             bgk.bytes_per_cell(), single.bytes_per_cell());
  fmt::print("{:<22}{:>12}{:>12}{:>14}{:>14}{:>16}\n", "", "best MLUPS", "median", "/ probe a", "/ probe b",
             "/ BGK FP64");
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Line& line = lines[k];
    const std::size_t first = k < single_thread ? 0 : single_thread;
    fmt::print("{:<22}{:>12.1f}{:>12.1f}{:>14.2f}{:>14.2f}{:>16.2f}\n", line.name,
               1e-6 * *std::max_element(line.found.begin(), line.found.end()), 1e-6 * median(line.found),
               ratio(line, first), ratio(line, first + 1), ratio(line, first + 2));
  }
}

}  // namespace
}  // namespace stresslet

int main(int argc, char** argv) {
  const auto argument = [&](int k, int otherwise) {
    return argc > k && argv[k][0] != '-' ? std::atoi(argv[k]) : otherwise;
  };
  stresslet::run(argument(1, 200), argument(2, 9));
}
