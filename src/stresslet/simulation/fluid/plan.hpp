#pragma once
/// What a fluid case comes to: lattice units, the set-up of the fluid, events in whole steps, and what the run will
/// cost. Everything that can be refused before the run is refused here.
#include <cstdint>
#include <string>
#include <vector>

#include "stresslet/lattice/fluid.hpp"
#include "stresslet/simulation/fluid/case.hpp"
#include "stresslet/simulation/fluid/lattice_units.hpp"

namespace stresslet {

/// A box of cells, both ends included, every `stride`-th along each axis.
struct CellBox {
  Cells first, last, stride{1, 1, 1};

  int count(std::size_t axis) const { return (last[axis] - first[axis]) / stride[axis] + 1; }
  std::size_t count() const { return std::size_t(count(0)) * std::size_t(count(1)) * std::size_t(count(2)); }
};

struct FluidPlan {
  double reynolds = 0;
  LatticeUnits units{};
  FluidSetup setup;                                                    ///< without solid cells, which `make_fluid` adds
  Vec3<double> force{};                                                ///< amplitude, rho U^2/L
  double angular_frequency = 0;                                        ///< of the force; 0 where it is steady
  std::int64_t steps = 0;                                              ///< of the whole run, whole samples
  std::int64_t sample_every = 1, fields_every = 0, profile_every = 0;  ///< steps; 0 is at the end only
  CellBox fields_box;
  std::vector<Cells> probes;
  int threads = 1;

  double cells() const;
  double time(std::int64_t step) const { return double(step) * units.step; }
  double memory_bytes() const;
  /// Rough: rates measured on one kind of machine, within a factor of two or three elsewhere.
  double expected_seconds() const;
  /// The force at a time, in lattice units.
  Vec3<double> force_lu(std::int64_t step) const;
};

/// Throws InputError for anything that cannot be run: sizes, units, probes outside, more memory than there is.
FluidPlan make_plan(const FluidCase& settled);

/// The plan's numbers for people, with verdicts.
std::string plan_report(const FluidCase& settled, const FluidPlan& plan);

}  // namespace stresslet
