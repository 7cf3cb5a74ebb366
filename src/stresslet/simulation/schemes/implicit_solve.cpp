#include "stresslet/simulation/schemes/implicit_solve.hpp"

#include <cmath>

#include "stresslet/simulation/schemes/forces.hpp"

namespace stresslet {

namespace {

/// Residual that a solution may leave: `solver_tolerance` of each particle's hydrodynamic force scale.
double absolute_tolerance(const Suspension& s) {
  double mean_square_radius = 0;
  for (double a : s.state.radius) mean_square_radius += a * a;
  const double n = double(s.state.size());
  return s.time.solver_tolerance * 6 * pi * mean_square_radius / n * std::sqrt(n);
}

}  // namespace

void implicit_solve(Member& member, Suspension& s, double inverse_step) {
  const Range mine = member.share(s.state.size(), sum_chunk);
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    const double a = s.state.radius[i];
    const double drag = s.physics.drag ? translational_drag(a) : 0.0;
    const double spin_drag = s.physics.drag ? rotational_drag(a) : 0.0;
    s.solver.set_own_resistance(i, s.state.own_mass(i) * inverse_step + drag,
                                s.state.own_inertia(i) * inverse_step + spin_drag);
    double *v = s.velocity[i], *c = s.change[i];
    for (std::size_t k = 0; k < twist_stride; ++k) v[k] += c[k];
  }
  member.barrier();
  apply_pair_forces(member, s);
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    const Twist<double> f = total_wrench(s, i, s.velocity.get(i)), c = s.change.get(i);
    s.residual.set(i, f.linear - s.state.own_mass(i) * inverse_step * c.linear,
                   f.angular - s.state.own_inertia(i) * inverse_step * c.angular);
  }
  s.solver.factorise(member, s.pairs, s.lubrication, s.walls, s.fluid_coupling);
  const SolverReport report = s.solver.solve(member, s.pairs, s.lubrication, s.walls, s.fluid_coupling,
                                             absolute_tolerance(s), s.time.largest_iteration, s.velocity, s.residual);
  if (member.rank() == 0) s.solver_report = report;
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    const Twist<double> v = s.velocity.get(i);
    s.change.set(i, v.linear - s.state.velocity(i), v.angular - s.state.angular_velocity(i));
    s.state.set_velocity(i, v.linear);
    s.state.set_angular_velocity(i, v.angular);
  }
  member.barrier();
}

}  // namespace stresslet
