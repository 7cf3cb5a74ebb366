#include "stresslet/simulation/fluid/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stresslet/simulation/cell_defect.hpp"

namespace stresslet {

namespace {

FlowSums operator+(const FlowSums& a, const FlowSums& b) {
  return {a.cells + b.cells,
          a.mass_deviation + b.mass_deviation,
          a.momentum + b.momentum,
          a.velocity + b.velocity,
          a.kinetic_energy + b.kinetic_energy,
          a.square_strain_populations + b.square_strain_populations,
          a.square_strain_gradients + b.square_strain_gradients,
          a.strain_xy + b.strain_xy,
          a.reynolds_xy + b.reynolds_xy,
          std::max(a.largest_speed, b.largest_speed),
          std::min(a.lowest_density, b.lowest_density),
          std::max(a.highest_density, b.highest_density)};
}

FlowSums sums_of_row(const FlowField& field, double shear_velocity_lu, int y, int z) {
  const double mean_flow = shear_velocity_lu * ((y + 0.5) / field.size()[1] - 0.5);
  FlowSums row;
  for (int x = 0; x < field.size()[0]; ++x) {
    const Cells c{x, y, z};
    if (field.is_solid(c)) continue;
    const CellState& s = field[c];
    const double square_speed = dot(s.velocity, s.velocity);
    row = row + FlowSums{1,
                         s.density - 1,
                         s.density * s.velocity,
                         s.velocity,
                         0.5 * s.density * square_speed,
                         s.density * square_sum(s.strain_rate),
                         s.density * square_sum(field.strain_rate_from_velocities(c)),
                         s.density * s.strain_rate.xy,
                         s.density * (s.velocity.x - mean_flow) * s.velocity.y,
                         std::sqrt(square_speed),
                         s.density,
                         s.density};
  }
  return row;
}

/// Visits (name, unit, description, value) of every column: the one list behind names and rows.
template <class Visit>
void for_each_quantity(const FluidCase& c, const FluidPlan& plan, const FlowSums& sums, double time, Visit&& visit) {
  const LatticeUnits& u = plan.units;
  const double volume = plan.cells(), shear_rate = c.boundaries.shear_rate.value_or(0);
  const double dissipation = 2 / (plan.reynolds * u.rate() * u.rate() * volume);
  const double viscous_xy = 2 * sums.strain_xy / (plan.reynolds * u.rate() * volume);
  const auto pressure = [&](double density) { return (density - 1) / (3 * u.pressure()); };
  visit("time", "L/U", "time", time);
  visit("mass_deviation", "1", "mean density of the fluid less the reference density",
        sums.mass_deviation / std::max(sums.cells, 1.0));
  const auto vector = [&](const std::string& name, const char* unit, const char* description, const Vec3<double>& v) {
    visit(name + "_x", unit, description, v.x);
    visit(name + "_y", unit, description, v.y);
    visit(name + "_z", unit, description, v.z);
  };
  vector("momentum", "rho*U", "momentum of the fluid per volume of the domain", sums.momentum / (u.velocity * volume));
  vector("mean_velocity", "U", "velocity averaged over the domain, solid cells counted as at rest",
         sums.velocity / (u.velocity * volume));
  visit("kinetic_energy", "rho*U^2", "kinetic energy per volume of the domain",
        sums.kinetic_energy / (u.velocity * u.velocity * volume));
  visit("largest_speed", "U", "largest speed of a cell", sums.largest_speed / u.velocity);
  visit("lowest_pressure", "rho*U^2", "lowest pressure of a cell", pressure(sums.lowest_density));
  visit("highest_pressure", "rho*U^2", "highest pressure of a cell", pressure(sums.highest_density));
  visit("dissipation_from_gradients", "rho*U^3/L", "2 mu S:S per volume, S from differences of velocities",
        dissipation * sums.square_strain_gradients);
  visit("dissipation_from_populations", "rho*U^3/L", "2 mu S:S per volume, S from the populations",
        dissipation * sums.square_strain_populations);
  visit("viscous_stress_xy", "rho*U^2", "mean viscous shear stress, from the populations", viscous_xy);
  if (shear_rate == 0) return;
  const double reynolds_xy = -sums.reynolds_xy / (u.velocity * u.velocity * volume);
  visit("reynolds_stress_xy", "rho*U^2", "-rho u_x u_y, u relative to the mean flow", reynolds_xy);
  visit("relative_viscosity", "1", "mean shear stress over viscosity and shear rate",
        (viscous_xy + reynolds_xy) * plan.reynolds / shear_rate);
  visit("relative_viscosity_from_dissipation", "1", "dissipation from gradients over viscosity and squared shear rate",
        dissipation * sums.square_strain_gradients * plan.reynolds / (shear_rate * shear_rate));
}

}  // namespace

FlowSums flow_sums(const FlowField& field, double shear_velocity_lu, ThreadTeam& team) {
  const std::size_t ny = std::size_t(field.size()[1]), rows = ny * std::size_t(field.size()[2]);
  std::vector<FlowSums> of_row(rows);
  team.run([&](Member& member) {
    const Range mine = member.share(rows);
    for (std::size_t row = mine.begin; row < mine.end; ++row)
      of_row[row] = sums_of_row(field, shear_velocity_lu, int(row % ny), int(row / ny));
  });
  FlowSums sum;
  for (const FlowSums& row : of_row) sum = sum + row;
  return sum;
}

std::optional<Complaint> defect(const FlowField& field, double time) {
  const Cells& n = field.size();
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x) {
        const CellState& s = field[{x, y, z}];
        const bool finite = std::isfinite(s.density) && std::isfinite(dot(s.velocity, s.velocity));
        auto found = cell_defect({x, y, z}, s.density, finite, fmt::format("time {:.6g} L/U", time),
                                 "raise domain.resolution, lower lattice.largest_mach, or look at the fields around "
                                 "this cell");
        if (found) return found;
      }
  return std::nullopt;
}

std::vector<Column> fluid_columns(const FluidCase& settled, const FluidPlan& plan) {
  std::vector<Column> columns;
  for_each_quantity(settled, plan, {}, 0, [&](std::string name, std::string unit, std::string description, double) {
    columns.push_back({std::move(name), std::move(unit), std::move(description)});
  });
  for (std::size_t k = 0; k < plan.probes.size(); ++k) {
    const Cells& c = plan.probes[k];
    const double cell = plan.units.cell;
    const std::string at = fmt::format("in the cell around ({:.6g}, {:.6g}, {:.6g}) L", (c[0] + 0.5) * cell,
                                       (c[1] + 0.5) * cell, (c[2] + 0.5) * cell);
    for (const char* axis : {"x", "y", "z"})
      columns.push_back({fmt::format("probe_{}_velocity_{}", k + 1, axis), "U", "velocity " + at});
    columns.push_back({fmt::format("probe_{}_pressure", k + 1), "rho*U^2", "pressure " + at});
  }
  return columns;
}

std::vector<double> sample_row(const FluidCase& settled, const FluidPlan& plan, const FlowField& field,
                               std::int64_t step, ThreadTeam& team) {
  std::vector<double> row;
  for_each_quantity(settled, plan, flow_sums(field, plan.setup.shear_velocity_lu, team), plan.time(step),
                    [&](const std::string&, const char*, const char*, double value) { row.push_back(value); });
  for (const Cells& probe : plan.probes) {
    const CellState& s = field[probe];
    for (const double u : {s.velocity.x, s.velocity.y, s.velocity.z}) row.push_back(u / plan.units.velocity);
    row.push_back((s.density - 1) / (3 * plan.units.pressure()));
  }
  return row;
}

}  // namespace stresslet
