#pragma once
/// What the fluid cases have in common: set-ups, stepping with progress, fields.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "stresslet/lattice/fluid.hpp"
#include "validation/harness/trial.hpp"

namespace stresslet::validation {

/// The relaxation time of a viscosity, lattice units.
constexpr double relaxation_time_of(double viscosity_lu) { return 3 * viscosity_lu + 0.5; }

/// A periodic box with this collision law.
FluidSetup periodic_box(const std::string& stencil, const Cells& size, const std::string& collision,
                        double relaxation_time);
/// Opens both faces across `axis` to half-way walls; the cell `c` then lies at c + 1/2.
void add_walls(FluidSetup& setup, int axis, const Vec3<double>& low_velocity_lu = {},
               const Vec3<double>& high_velocity_lu = {});

/// A fluid with the threads and the progress line of its trial.
class Flow {
 public:
  Flow(Trial& trial, const FluidSetup& setup, std::string label);

  Fluid& fluid() { return *fluid_; }
  const Cells& size() const { return fluid_->grid().size; }
  void initialise(const std::function<CellState(const Cells&)>& state) { fluid_->initialise(trial_.team(), state); }
  void rest() {
    initialise([](const Cells&) { return CellState{}; });
  }
  void advance(int steps);
  /// Advances until the velocity changes by less than `tolerance`, relative to its largest value, per `interval` steps.
  /// Throws NumericalFailure if that takes more than `limit` steps.
  void advance_to_steady(double tolerance, int interval, int limit);
  /// All cells, x fastest.
  std::vector<CellState> states();

 private:
  Trial& trial_;
  std::string label_;
  std::unique_ptr<Fluid> fluid_;
};

/// One number from each state.
template <class Pick>
std::vector<double> picked(const std::vector<CellState>& states, Pick&& pick) {
  std::vector<double> values;
  values.reserve(states.size());
  for (const CellState& s : states) values.push_back(pick(s));
  return values;
}

}  // namespace stresslet::validation
