#pragma once
/// What a case comes to: the model in the program's units, the particles, the box, the time step and its reasons, and
/// what the run will cost. Everything that can be refused before the run is refused here.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stresslet/particles/sizes/size_classed.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/suspension.hpp"
#include "stresslet/simulation/time_step.hpp"

namespace stresslet {

struct Plan {
  Physics physics;
  TimeControl time;
  StepBounds bounds;
  InteractionRange range;
  double skin = 0;
  std::vector<double> radii;       ///< of all particles
  std::vector<SizeClassed> sizes;  ///< to be packed; empty when a file gives the start
  ParticleState loaded;            ///< start read from a file; empty when it is packed
  Box box;
  double density = 0;
  double solid_fraction = 0;
  int threads = 1;
  std::optional<ResolvedSetup> resolved;

  std::size_t count() const { return radii.size(); }
  double steps(double strain) const { return strain / time.step; }
  double memory_bytes() const;
  /// Rough: rates measured on one kind of machine, within a factor of two or three elsewhere.
  double expected_seconds(double strain) const;
};

/// Particles and box that exist already.
struct Existing {
  std::vector<double> radii;
  Vec3<double> box_length;
};

/// Throws InputError for anything that cannot be run: sizes, stiffness, a time step above the limit, a box too small.
/// With `existing` particles nothing is packed or read (restart).
Plan make_plan(const Case& settled, const Existing* existing = nullptr);

/// Volume of the spheres over volume of the box; the same bits in any order of the spheres.
double solid_fraction(const std::vector<double>& radii, const Box& box);

/// The plan's numbers for people: dimensionless groups, steps and what binds them, memory, expected time, warnings.
std::string plan_report(const Case& settled, const Plan& plan);

/// Particles in their box, ready for `start`. `report` receives the part of the packing done, 0 ... 1.
Suspension make_suspension(const Case& settled, const Plan& plan, const std::function<void(double)>& report);

/// An empty suspension with the plan's physics, box kind and neighbour list, to be filled from a checkpoint.
Suspension make_empty_suspension(const Plan& plan);

}  // namespace stresslet
