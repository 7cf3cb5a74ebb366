#include "stresslet/simulation/fluid/lattice_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stresslet {

namespace {

/// Chosen relaxation times lie between these; below the lower one a few cells of shear make the flow unstable.
constexpr double lowest_chosen = 0.505, highest_chosen = 1;
constexpr double round_off = 1e-9;

double viscosity_lu(double relaxation_time) { return (relaxation_time - 0.5) / 3; }

double largest_velocity_lu(const LatticeChoice& c) {
  return c.largest_mach / (std::numbers::sqrt3 * c.fastest_velocity);
}

}  // namespace

LatticeUnits lattice_units(const LatticeChoice& c) {
  const double n = double(c.resolution);
  const double velocity = c.relaxation_time
                              ? viscosity_lu(*c.relaxation_time) * c.reynolds / n
                              : std::min(viscosity_lu(highest_chosen) * c.reynolds / n, largest_velocity_lu(c));
  const double viscosity = velocity * n / c.reynolds;
  return {1 / n,
          velocity / n,
          velocity,
          c.relaxation_time.value_or(3 * viscosity + 0.5),
          velocity * c.fastest_velocity * std::numbers::sqrt3,
          velocity * c.fastest_velocity / viscosity};
}

std::optional<ImpossibleUnits> impossible(const LatticeChoice& c) {
  const LatticeUnits units = lattice_units(c);
  const double n = double(c.resolution);
  if (units.mach > c.largest_mach * (1 + round_off)) {
    const double tau = 0.5 + 3 * largest_velocity_lu(c) * n / c.reynolds;
    const double cells = std::ceil(units.viscosity() * c.reynolds / largest_velocity_lu(c) - round_off);
    return ImpossibleUnits{
        fmt::format("the Mach number would be {:.3g}, above the largest allowed one, {:.3g}", units.mach,
                    c.largest_mach),
        fmt::format(
            "relaxation time {:.4g}, Reynolds number {:.6g} and {} cells fix it, for the fastest velocity {:.4g} "
            "U; the fluid would be compressed",
            units.relaxation_time, c.reynolds, c.resolution, c.fastest_velocity),
        fmt::format("nearest possible: lattice.relaxation_time = {:.4g}, or domain.resolution = {:.0f}; or leave out "
                    "the relaxation time",
                    std::floor(tau * 1e4) / 1e4, cells)};
  }
  if (!c.relaxation_time && units.relaxation_time < lowest_chosen - round_off) {
    const double reynolds = largest_velocity_lu(c) * n / viscosity_lu(lowest_chosen);
    const double cells = std::ceil(c.reynolds * viscosity_lu(lowest_chosen) / largest_velocity_lu(c) - round_off);
    return ImpossibleUnits{
        fmt::format("Reynolds number {:.6g} cannot be reached with {} cells", c.reynolds, c.resolution),
        fmt::format("at Mach number {:.3g} the relaxation time would be {:.5f}; below {} such flows are unstable",
                    c.largest_mach, units.relaxation_time, lowest_chosen),
        fmt::format("nearest possible: Reynolds number {:.4g} at this resolution, or domain.resolution = {:.0f}",
                    reynolds, cells)};
  }
  return std::nullopt;
}

}  // namespace stresslet
