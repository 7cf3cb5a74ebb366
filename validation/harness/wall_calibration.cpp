#include "validation/harness/wall_calibration.hpp"

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/calibration/calibrate.hpp"
#include "stresslet/coupling/subgrid/subgrid_links.hpp"
#include "validation/harness/sphere_wall_exact.hpp"

namespace stresslet::validation {

std::vector<WallMeasurement> measure_at_wall(Trial& trial, const ResolvedScheme& scheme, double radius) {
  std::vector<WallMeasurement> found;
  for (const AlongWall& exact : exact_along_wall)
    for (const double shift : {0.0, 0.5}) {
      Unbounded setup{.scheme = scheme, .radius = radius, .wall = -1 - exact.gap_over_radius};
      setup.shift = {shift, 0, shift};
      const auto moved = [&](const UnboundedSphere& sphere) {
        setup.spheres = {sphere};
        return run_unbounded(trial, setup, fmt::format("wall, gap {:.3g} cells", radius * exact.gap_over_radius))[0];
      };
      found.push_back({radius,
                       radius * exact.gap_over_radius,
                       shift,
                       {moved({.velocity = {0, -1, 0}}).force.y, -moved({.velocity = {1, 0, 0}}).force.x,
                        -moved({.angular_velocity = {0, 0, 1}}).torque.z},
                       {exact_approach(exact.gap_over_radius), exact.sliding, exact.turning}});
    }
  return found;
}

std::array<double, 3> corrected_errors(const WallMeasurement& m, const std::string& law, const SubgridLengths& lengths,
                                       const SubgridRange& range) {
  // Per unit viscosity; the wall lies along -y, sliding along x and turning about z.
  const Matrix6 film = subgrid_wall_resistance_matrix(m.radius, {0, -1, 0}, m.gap, 1, {law, lengths, range, {}})
                           .value_or(Matrix6::Zero());
  const double force = 6 * pi * m.radius, torque = 8 * pi * m.radius * m.radius * m.radius;
  const std::array<double, 3> correction{film(1, 1) / force, film(0, 0) / force, film(5, 5) / torque};
  std::array<double, 3> errors;
  for (std::size_t k = 0; k < 3; ++k) errors[k] = (m.measured[k] + correction[k]) / m.exact[k] - 1;
  return errors;
}

SubgridLengths fit_wall_lengths(const std::vector<WallMeasurement>& measurements, const std::string& law,
                                const SubgridRange& range) {
  SubgridLengths best;
  const auto fit = [&](double SubgridLengths::*length, std::size_t motion) {
    fit_length(best, length, [&](const SubgridLengths& trial, const ErrorVisitor& visit) {
      for (const WallMeasurement& m : measurements) visit(corrected_errors(m, law, trial, range)[motion]);
    });
  };
  fit(&SubgridLengths::normal, 0);
  fit(&SubgridLengths::sliding, 1);
  fit(&SubgridLengths::spin, 2);
  return best;
}

}  // namespace stresslet::validation
