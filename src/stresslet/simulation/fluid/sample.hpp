#pragma once
/// Sums over the whole fluid at one time, and the row of the series that they make.
#include <optional>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/io/results_data.hpp"
#include "stresslet/simulation/fluid/flow_field.hpp"
#include "stresslet/simulation/fluid/plan.hpp"

namespace stresslet {

/// Sums over all cells that are not solid, lattice units. The same bits for any number of threads and blocks.
struct FlowSums {
  double cells = 0;
  double mass_deviation = 0;
  Vec3<double> momentum{}, velocity{};
  double kinetic_energy = 0;
  double square_strain_populations = 0, square_strain_gradients = 0;  ///< density S:S
  double strain_xy = 0;                                               ///< density S_xy
  double reynolds_xy = 0;  ///< density u_x u_y relative to the mean flow of the sheared box
  double largest_speed = 0;
  double lowest_density = 1, highest_density = 1;
};
FlowSums flow_sums(const FlowField& field, double shear_velocity_lu, ThreadTeam& team);

/// What is wrong, with the cell named, where density or velocity is not finite or the density has left the range in
/// which the fluid is nearly incompressible.
std::optional<Complaint> defect(const FlowField& field, double time);

/// Columns in the order of `sample_row`.
std::vector<Column> fluid_columns(const FluidCase& settled, const FluidPlan& plan);
std::vector<double> sample_row(const FluidCase& settled, const FluidPlan& plan, const FlowField& field,
                               std::int64_t step, ThreadTeam& team);

}  // namespace stresslet
