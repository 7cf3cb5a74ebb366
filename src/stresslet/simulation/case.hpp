#pragma once
/// A case of a suspension: everything the input says, checked, with every choice made that the input left to a default.
/// With fidelity "resolved" the fluid between the particles is solved for, and [resolution] has a part in it; model and
/// lubrication then say which modes of the films are corrected, and drag and stresslet come from the fluid.
///
/// Reading ends with a settled case: of each group of equivalent keys exactly one is given (one of model.name and the
/// switches; one of the three stiffness keys; flow.stokes or [units]; suspension.file or solid_fraction, count,
/// box_aspect and sizes).
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stresslet/simulation/case_sections.hpp"
#include "stresslet/simulation/case_source.hpp"
#include "stresslet/simulation/case_suspension.hpp"
#include "stresslet/simulation/fidelity.hpp"
#include "stresslet/simulation/resolved/resolution_section.hpp"

namespace stresslet {

struct Case {
  Fidelity fidelity = Fidelity::lubricated;
  SuspensionInput suspension;
  FlowInput flow;
  ModelInput model;
  ContactInput contact;
  LubricationInput lubrication;
  TimeInput time;
  RunInput run;
  OutputInput output;
  std::optional<UnitsInput> units;
  std::optional<ResolutionInput> resolution;
  CaseSource source;

  /// "case.toml:12" of a key; if it was not given, the place of its section, or the name of the input.
  std::string where(std::string_view key) const { return source.document.where(key); }

  bool resolved() const { return fidelity == Fidelity::resolved; }
  ModelSwitches switches() const;
  /// St = density d1^2 shear rate / viscosity, the density of the particles in the units of the program.
  double stokes_number() const;
  /// Re = density of the fluid d1^2 shear rate / viscosity.
  double reynolds_number() const { return flow.reynolds.value_or(stokes_number()); }
  /// kn in units of viscosity shear_rate d1 (hooke) or viscosity shear_rate (hertz); none where it is to be derived
  /// from contact.largest_overlap.
  std::optional<double> contact_stiffness() const;

  template <class V>
  void describe(V& v) {
    v.section("suspension", suspension, "The particles and the box.");
    v.section("flow", flow, "The imposed flow: velocity along x, gradient along y, vorticity along z.");
    v.section("model", model,
              "Hydrodynamics. Use CLM-S if unsure. Give `name`, or the three switches lubrication, drag and stresslet "
              "in any combination.");
    v.section("contact", contact, "Forces between touching particles. Give at most one of the three stiffness keys.");
    v.section("lubrication", lubrication, "Cut-offs of pair lubrication.");
    v.section("time", time, "Integration in time.");
    v.section("run", run, "Length of the run and what ends it.");
    v.section("output", output, "What is written, and how often.");
    v.section("units", units,
              "SI values of the units of the program. flow.stokes then follows from them and must not be given.");
    v.section("resolution", resolution, "The lattice of the fluid; with fidelity = \"resolved\" only.");
  }

  friend bool operator==(const Case&, const Case&) = default;
};

/// Reads, checks and settles a case. `overrides` are "key=value", applied in order.
/// Throws InputError with file and line.
Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same for a document with its overrides applied.
Case read_case(InputDocument document);

/// The same for a text at hand, such as the resolved input kept in a result; `name` stands for it in messages.
Case read_case_text(std::string_view text, const std::string& name, const std::vector<std::string>& overrides = {},
                    const std::filesystem::path& folder = {});

/// Chooses what was left to defaults. Reading a case calls it after the checks; a case made in code needs it too.
void settle(Case& settled);

/// Every key with its final value as TOML; reads back to an equal case.
std::string resolved_toml(const Case& resolved);

/// A commented input to start from: the standard suspension, lubricated or resolved.
std::string new_case_template(Fidelity fidelity = Fidelity::lubricated);

}  // namespace stresslet
