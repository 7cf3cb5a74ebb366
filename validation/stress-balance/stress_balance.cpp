/// What the walls feel above the fluid's own stress must be the particle's complete stresslet, with half the torque of
/// a sphere that is held: momentum that a wall puts in can leave only through the fluid and the particle. The wall's
/// part is read from the populations that cross a plane beside it, and knows nothing of the operator.
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/weight_choice.hpp"
#include "validation/harness/shear_cell.hpp"

namespace stresslet::validation {

void stress_balance(Trial& trial) {
  const double tau = 1.5;
  trial.parameter("relaxation time", tau);
  for (const std::string& weight : SolidWeights::names())
    for (const std::string& coupling_operator : CouplingOperators::names()) {
      if (!bears(coupling_operator, weight) || (trial.quick() && weight == "noble-torczynski")) continue;
      ShearCell cell{.scheme = default_scheme(tau), .cells_per_diameter = trial.choose(10, 6), .box = {3, 3, 3}};
      cell.scheme.coupling_operator = coupling_operator;
      cell.scheme.weight = weight;
      cell.fixed = coupling_operator == "guo-form" || coupling_operator == "half-holdych";
      // Seven times the slowest relaxation H^2/(pi^2 nu) between walls six radii apart.
      const ShearResult r =
          run_shear_cell(trial, cell, fmt::format("stress balance, {}, {}", coupling_operator, weight), 0, 13);
      trial.row(fmt::format("{}, {}: felt by the walls over S0", coupling_operator, weight), r.wall,
                {r.expected_wall(), "complete stresslet and half the torque"}, relative(0.003));
    }
}

}  // namespace stresslet::validation
