#pragma once
/// Input sections about the model and the run: [model], [contact], [lubrication], [time], [run], [output].
#include <cstdint>
#include <optional>
#include <string>

#include "stresslet/io/schema.hpp"
#include "stresslet/simulation/case_choices.hpp"
#include "stresslet/simulation/commit_key.hpp"

namespace stresslet {

struct ModelInput {
  std::optional<std::string> name;
  std::optional<std::string> lubrication;
  std::optional<bool> drag, stresslet;

  template <class V>
  void describe(V& v) {
    v.key("name", name, otherwise("`\"CLM-S\"` unless the three switches are given"), one_of(model_names()), "",
          "Model: normal (NLM) or all modes (CLM) of pair lubrication, or the full pair resistance with strain terms "
          "(GRM). -S adds Stokes drag and the stresslet of a single sphere, -SS the stresslet only; GRM has both");
    v.key("lubrication", lubrication, otherwise("follows from `name`"), one_of(lubrication_law_names()), "",
          "Switch in place of `name`: pair lubrication");
    v.key("drag", drag, otherwise("follows from `name`"), anything(), "",
          "Switch in place of `name`: Stokes drag and torque towards the imposed flow");
    v.key("stresslet", stresslet, otherwise("follows from `name`"), anything(), "",
          "Switch in place of `name`: stresslet of a single sphere in the stress");
  }

  friend bool operator==(const ModelInput&, const ModelInput&) = default;
};

struct ContactInput {
  std::string normal = "hooke";
  std::optional<double> stiffness, stiffness_si, largest_overlap;
  double friction = 0;
  double tangential_ratio = 2.0 / 7.0;
  double restitution = 1;
  CoulombLimit coulomb_limit = CoulombLimit::spring;

  template <class V>
  void describe(V& v) {
    v.key("normal", normal, defaulted, one_of(normal_contact_law_names()), "", "Law of the normal contact force");
    v.key("stiffness", stiffness, otherwise("`2.5e5` (hertz: `1e7`) if none of the three stiffness keys is given"),
          above(0), "1",
          "Dimensionless stiffness: kn / (viscosity shear rate d1) for hooke, kn / (viscosity shear rate) for hertz");
    v.key("stiffness_si", stiffness_si, otherwise("`stiffness` is used"), above(0), "N/m (hertz: Pa)",
          "Stiffness in SI units, in place of `stiffness`; needs [units]");
    v.key("largest_overlap", largest_overlap, otherwise("`stiffness` is used"), above_up_to(0, 0.1), "d1",
          "Overlap that contacts should not exceed, in place of `stiffness`, which is derived from it");
    v.key("friction", friction, defaulted, between(0, 100), "1", "Coulomb coefficient of friction");
    v.key("tangential_ratio", tangential_ratio, defaulted, above_up_to(0, 10), "1", "Tangential over normal stiffness");
    v.key("restitution", restitution, defaulted, above_up_to(0, 1), "1",
          "Coefficient of restitution of a dry normal impact; 1 means no dashpot");
    v.key("coulomb_limit", coulomb_limit, defaulted, anything(), "",
          "Normal force that limits friction: of the spring, or of spring and dashpot together");
  }

  friend bool operator==(const ContactInput&, const ContactInput&) = default;
};

struct LubricationInput {
  double inner_cutoff = 0.001;
  double outer_cutoff = 0.05;

  template <class V>
  void describe(V& v) {
    v.key("inner_cutoff", inner_cutoff, defaulted, strictly_between(0, 1), "d_eff",
          "Gap below which lubrication stays constant (roughness); d_eff = d1 d2 / (d1 + d2) of the pair");
    v.key("outer_cutoff", outer_cutoff, defaulted, strictly_between(0, 1), "d_eff",
          "Gap beyond which a pair feels no lubrication");
  }

  friend bool operator==(const LubricationInput&, const LubricationInput&) = default;
};

struct TimeInput {
  std::string scheme = "semi-implicit";
  std::optional<double> step;

  template <class V>
  void describe(V& v) {
    v.key("scheme", scheme, defaulted, one_of(time_scheme_names()), "",
          "Semi-implicit (step limited by contacts), explicit velocity Verlet (step limited by lubrication), or the "
          "limit without particle inertia");
    v.key("step", step, otherwise("derived from contacts and lubrication"), above_up_to(0, 1), "1/shear rate",
          "Time step; refused above the limit of the scheme");
  }

  friend bool operator==(const TimeInput&, const TimeInput&) = default;
};

struct RunInput {
  double strain = 0;
  std::optional<double> average_from, relative_error;
  std::int64_t threads = 0;
  double monitor_tolerance = 0.1;

  template <class V>
  void describe(V& v) {
    v.key("strain", strain, required, above_up_to(0, 1e6), "1", "Strain at which the run ends");
    v.key("average_from", average_from, otherwise("the steady state is detected"), at_least(0), "1",
          "Strain from which means are taken");
    v.key("relative_error", relative_error, otherwise("the run goes on to `strain`"), strictly_between(0, 1), "1",
          "Ends the run early once the error bar of the viscosity is this fraction of it");
    v.key("threads", threads, defaulted, between(0, 1024), "1",
          "Threads; 0 takes all cores. Results do not depend on it");
    v.key("monitor_tolerance", monitor_tolerance, defaulted, above(0), "1",
          "Relative mismatch that stops the run: stress power against dissipation; resolved, stress against flux too");
  }

  friend bool operator==(const RunInput&, const RunInput&) = default;
};

struct OutputInput {
  std::optional<double> sample_every;
  double snapshot_every = 0.5;
  std::int64_t profile_bins = 20;
  double commit_every = 10;
  bool csv = true, xyz = true, paraview = true;

  template <class V>
  void describe(V& v) {
    v.key("sample_every", sample_every, otherwise("`0.001`; `0.01` in a resolved fluid"), above(0), "1",
          "Strain between two samples of the series; in a resolved fluid each reads the whole lattice");
    v.key("snapshot_every", snapshot_every, defaulted, above(0), "1", "Strain between two snapshots of all particles");
    v.key("profile_bins", profile_bins, defaulted, between(1, 10'000), "1",
          "Layers across the gradient in which profiles are averaged");
    describe_commit_every(v, commit_every);
    v.key("csv", csv, defaulted, anything(), "", "Write the series as CSV too");
    v.key("xyz", xyz, defaulted, anything(), "", "Write the snapshots as extended XYZ (OVITO) too");
    v.key("paraview", paraview, defaulted, anything(), "", "Write what ParaView needs to open the snapshots");
  }

  friend bool operator==(const OutputInput&, const OutputInput&) = default;
};

}  // namespace stresslet
