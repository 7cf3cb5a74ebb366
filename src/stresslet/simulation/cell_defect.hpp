#pragma once
/// When the fluid of a lattice is no longer sound.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "stresslet/base/error.hpp"
#include "stresslet/lattice/layout.hpp"

namespace stresslet {

inline constexpr double largest_density_deviation = 0.3;  // at Mach 0.1 a flow stays below 0.02

/// What is wrong with a cell, or nothing. `finite`: whether its density and velocity are; `when` and `fix` complete the
/// message.
inline std::optional<Complaint> cell_defect(const Cells& cell, double density, bool finite, std::string when,
                                            std::string fix) {
  if (finite && std::abs(density - 1) <= largest_density_deviation) return std::nullopt;
  const std::string place = fmt::format("cell ({}, {}, {})", cell[0], cell[1], cell[2]);
  return Complaint{
      std::move(when),
      finite ? fmt::format("the density of {} is {:.4g}", place, density)
             : fmt::format("{} holds numbers that are not finite", place),
      fmt::format("density must stay within {} of 1 for the fluid to be nearly incompressible; the run has become "
                  "unstable, or the pressure differences are too large for its Mach number",
                  largest_density_deviation),
      std::move(fix)};
}

}  // namespace stresslet
