#pragma once
/// A case of plain fluid: everything the input says, checked, with every choice made that the input left to a default.
///
/// Reading ends with a settled case: of each group of equivalent keys exactly one is given (flow.reynolds or [units];
/// force.density or force.pressure_gradient; force.womersley, force.angular_frequency or neither), and stencil,
/// sampling interval and waves are chosen.
#include <optional>
#include <string>
#include <string_view>

#include "stresslet/simulation/case_source.hpp"
#include "stresslet/simulation/fluid/case_boundaries.hpp"
#include "stresslet/simulation/fluid/case_sections.hpp"

namespace stresslet {

struct FluidCase {
  DomainInput domain;
  FluidFlowInput flow;
  LatticeInput lattice;
  std::optional<ForceInput> force;
  BoundariesInput boundaries;
  InitialInput initial;
  std::optional<SolidInput> solid;
  FluidRunInput run;
  FluidOutputInput output;
  std::optional<FluidUnitsInput> units;
  CaseSource source;

  std::string where(std::string_view key) const { return source.document.where(key); }

  double reynolds_number() const;
  /// Lengths of the box in L; one cell along z in two dimensions.
  Vec3<double> box() const;
  /// The largest velocity that the input names, at least the reference velocity; in U.
  double fastest_velocity() const;

  template <class V>
  void describe(V& v) {
    v.section("domain", domain, "The box of fluid and its division into cells.");
    v.section("flow", flow, "The dimensionless group of the flow.");
    v.section("lattice", lattice, "The numerical method. The defaults suit most flows.");
    v.section("force", force, "A force on all the fluid. Give density or pressure_gradient.");
    v.section("boundaries", boundaries,
              "Axes are periodic unless both of their faces are described below, or y is sheared.");
    v.section("initial", initial, "The flow at the start.");
    v.section("solid", solid, "Solid bodies at rest: cells whose centres lie inside.");
    v.section("run", run, "Length of the run and what ends it.");
    v.section("output", output, "What is written, and how often.");
    v.section("units", units,
              "SI values of the units of the program. flow.reynolds then follows from them and must not be given.");
  }

  friend bool operator==(const FluidCase&, const FluidCase&) = default;
};

/// Reads, checks and settles a case from a document with its overrides applied. Throws InputError with file and line.
FluidCase read_fluid_case(InputDocument document);

/// Throws InputError for the first rule that the case as read, not yet settled, breaks.
void check_fluid_case(const FluidCase& read);

/// Chooses what was left to defaults.
void settle(FluidCase& settled);

/// Every key with its final value as TOML; reads back to an equal case.
std::string resolved_toml(const FluidCase& resolved);

/// A commented input to start from: flow between two walls.
std::string new_fluid_case_template();

}  // namespace stresslet
