#pragma once
/// Input section [resolution]: the lattice under a suspension. Read with fidelity = "resolved" only.
#include <optional>
#include <string>
#include <vector>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/io/schema.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/simulation/precision.hpp"

namespace stresslet {

enum class ResolutionPreset { standard, fast, thesis };

template <>
struct Keywords<ResolutionPreset> {
  static constexpr std::array<std::pair<std::string_view, ResolutionPreset>, 3> names{
      {{"standard", ResolutionPreset::standard},
       {"fast", ResolutionPreset::fast},
       {"thesis", ResolutionPreset::thesis}}};
};

inline constexpr std::string_view no_correction = "none";

inline std::vector<std::string> correction_names() {
  std::vector<std::string> names = SubgridLaws::names();
  names.emplace_back(no_correction);
  return names;
}

struct ResolutionInput {
  std::optional<double> cells_per_diameter;
  ResolutionPreset preset = ResolutionPreset::standard;
  std::optional<double> relaxation_time, magic_parameter;
  std::optional<Precision> precision;
  std::optional<std::string> collision, coupling, solid_fraction, solid_weight, correction;
  std::optional<std::vector<double>> correction_lengths;
  double largest_mach = 0.1;

  template <class V>
  void describe(V& v) {
    v.key("cells_per_diameter", cells_per_diameter, otherwise("follows from `preset`"), between(2, 200), "1",
          "Cells across the diameter d1; rounded so that the box is a whole number of cells");
    v.key("preset", preset, defaulted, anything(), "",
          "Defaults of the other keys: standard (10 cells, relaxation time 1), fast (8 cells; 2: steps three times as "
          "long, for Re up to 0.02; float32), thesis (10 cells, BGK, superposition with linear weight, relaxation time "
          "0.65, hard cut-off)");
    v.key("relaxation_time", relaxation_time, otherwise("follows from `preset`"), above_up_to(0.5, 10), "1",
          "Relaxation time of the shear stress; a step grows with (tau - 1/2), compressibility with its square");
    v.key("magic_parameter", magic_parameter, otherwise("`1/12`"), above_up_to(0, 10), "1",
          "TRT and MRT: (tau_even - 1/2)(tau_odd - 1/2)");
    v.key("collision", collision, otherwise("follows from `preset`"), one_of(CollisionLaws::names()), "",
          "Collision law");
    v.key(
        "precision", precision, otherwise("follows from `preset`"), anything(), "",
        "Of the fluid and of what it does to a particle in one cell: float64, or float32, which takes half the memory "
        "and two thirds of the time");
    v.key("coupling", coupling, otherwise("`\"superposition\"`"), one_of(CouplingOperators::names()), "",
          "How the solid acts on the fluid in a cell");
    v.key("solid_fraction", solid_fraction, otherwise("`\"plane-cut\"`"), one_of(SolidFractionLaws::names()), "",
          "Law of the solid fraction of a cell");
    v.key("solid_weight", solid_weight, otherwise("follows from `preset` and `coupling`"),
          one_of(SolidWeights::names()), "",
          "Weight of the solid in a cell: viscosity-scaled where the coupling bears weights up to 2 (superposition, "
          "guo-form), else noble-torczynski");
    v.key("correction", correction, otherwise("follows from `preset`"), one_of(correction_names()), "",
          "What the lattice does not resolve of the films between particles");
    v.key("correction_lengths", correction_lengths, otherwise("those calibrated for the scheme"), between(0, 3),
          "cells", "Lengths of the correction: normal, sliding, opposite rotation");
    v.key("largest_mach", largest_mach, defaulted, above_up_to(0, 0.3), "1",
          "Largest Mach number of the mean flow that is accepted");
  }

  friend bool operator==(const ResolutionInput&, const ResolutionInput&) = default;
};

/// Chooses what was left to the preset.
void settle(ResolutionInput& resolution);

}  // namespace stresslet
