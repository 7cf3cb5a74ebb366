#pragma once
/// Small fluids for tests: set-up in a line, velocities and densities of single cells.
#include <cmath>
#include <random>

#include "stresslet/lattice/fluid.hpp"

namespace stresslet::testing {

class SmallFluid {
 public:
  explicit SmallFluid(const FluidSetup& setup, int threads = 1) : team_(threads), fluid_(Fluid::make(setup)) {}

  Fluid* operator->() { return fluid_.get(); }
  ThreadTeam& team() { return team_; }

  void start(const std::function<CellState(const Cells&)>& state) { fluid_->initialise(team_, state); }
  void start_at_rest() {
    start([](const Cells&) { return CellState{}; });
  }
  void advance(int steps) { fluid_->advance(team_, steps); }

  CellState at(const Cells& cell) {
    CellState found;
    fluid_->measure(team_, cell, cell, {1, 1, 1}, [&](const Cells&, const CellState& state) { found = state; });
    return found;
  }
  /// All cells, in no order that matters; use one thread where `visit` sums.
  void for_each(const std::function<void(const Cells&, const CellState&)>& visit) {
    const Cells& n = fluid_->grid().size;
    fluid_->measure(team_, {0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}, {1, 1, 1}, visit);
  }
  Fluid::Totals totals() { return fluid_->totals(team_); }
  std::vector<double> populations() { return fluid_->populations(team_); }
  void restore(const std::vector<double>& populations, std::int64_t steps) {
    fluid_->restore(team_, populations, steps);
  }

 private:
  ThreadTeam team_;
  std::unique_ptr<Fluid> fluid_;
};

inline FluidSetup fluid_setup(std::string stencil, const Cells& size, std::array<Closure, 3> closure = {}) {
  FluidSetup setup;
  setup.stencil = std::move(stencil);
  setup.grid.size = size;
  setup.grid.closure = closure;
  return setup;
}

inline double component(const Vec3<double>& a, int axis) { return axis == 0 ? a.x : axis == 1 ? a.y : a.z; }

/// `value` along `axis`, zero otherwise.
inline Vec3<double> along_axis(int axis, double value) {
  return {axis == 0 ? value : 0, axis == 1 ? value : 0, axis == 2 ? value : 0};
}

inline constexpr double pi = 3.14159265358979323846;

}  // namespace stresslet::testing
