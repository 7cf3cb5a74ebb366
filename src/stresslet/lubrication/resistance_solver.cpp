#include "stresslet/lubrication/resistance_solver.hpp"

#include <cmath>

namespace stresslet {

void ResistanceSolver::prepare(const ParticleState& state) {
  const std::size_t n = state.size();
  own_linear_.assign(n, 0.0), own_angular_.assign(n, 0.0);
  inverse_linear_.assign(n, {}), inverse_angular_.assign(n, {});
  inverse_radius_squared_.resize(n);
  for (std::size_t i = 0; i < n; ++i) inverse_radius_squared_[i] = 1 / (state.radius[i] * state.radius[i]);
  direction_.resize(n), image_.resize(n), preconditioned_.resize(n);
  direction_sum_.resize(n), residual_sum_.resize(n), force_sum_.resize(n), resistance_sum_.resize(n);
}

void ResistanceSolver::factorise(Member& member, const ActivePairs& pairs, PairLubrication& lubrication,
                                 const WallFilms& walls, const FluidCoupling& fluid) {
  const Range range = member.share(own_linear_.size(), sum_chunk);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    SymTensor3<double> linear = own_linear_[i] * identity3<double>();
    SymTensor3<double> angular = own_angular_[i] * identity3<double>();
    fluid.add_diagonal(i, linear, angular);
    pairs.for_each_pair_of(i, [&](std::size_t p, double sign) {
      const auto k = lubrication.resistance(p);
      const double arm = lubrication.arm(p);
      const auto along = square(pairs.normal(p));
      const auto across = identity3<double>() - along;
      linear += k.X * along + k.Y * across;
      angular += (0.25 * (k.Y * arm * arm + k.C) - 0.5 * sign * k.B * arm) * across;
    });
    if (walls[i].normal_y != 0) {
      const auto along = square(walls[i].normal());
      const auto across = identity3<double>() - along;
      linear += walls[i].k.X * along + walls[i].k.Y * across;
      angular += walls[i].k.C * across;
    }
    inverse_linear_[i] = inverse(linear);
    inverse_angular_[i] = inverse(angular);
  }
}

ResistanceSolver::Products ResistanceSolver::advance(std::size_t begin, std::size_t end, double length,
                                                     TwistVector& velocity, TwistVector& residual) {
  Products sum;
  for (std::size_t i = begin; i < end; ++i) {
    const Twist<double> v = velocity.get(i), r = residual.get(i), p = direction_.get(i), q = image_.get(i);
    const Vec3<double> force = r.linear - length * q.linear, torque = r.angular - length * q.angular;
    velocity.set(i, v.linear + length * p.linear, v.angular + length * p.angular);
    residual.set(i, force, torque);
    const Vec3<double> linear = inverse_linear_[i] * force, angular = inverse_angular_[i] * torque;
    preconditioned_.set(i, linear, angular);
    sum.preconditioned += dot(force, linear) + dot(torque, angular);
    sum.plain += dot(force, force) + inverse_radius_squared_[i] * dot(torque, torque);
  }
  return sum;
}

double ResistanceSolver::apply_and_project(std::size_t begin, std::size_t end, const ActivePairs& pairs,
                                           const PairLubrication& lubrication, const WallFilms& walls,
                                           const FluidCoupling& fluid) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Twist<double> v = direction_.get(i);
    Twist<double> wrench{};
    lubrication.add_to(i, pairs, wrench);
    walls.add_to<false>(i, v, wrench);
    fluid.add_to<false>(i, v, wrench);
    const Twist<double> image{own_linear_[i] * v.linear - wrench.linear, own_angular_[i] * v.angular - wrench.angular};
    image_.set(i, image);
    sum += dot(v.linear, image.linear) + dot(v.angular, image.angular);
  }
  return sum;
}

SolverReport ResistanceSolver::solve(Member& member, const ActivePairs& pairs, PairLubrication& lubrication,
                                     const WallFilms& walls, FluidCoupling& fluid, double tolerance,
                                     int largest_iteration, TwistVector& velocity, TwistVector& residual) {
  const std::size_t n = own_linear_.size();
  const Range mine = member.share(n, sum_chunk);
  const auto advance_all = [&](double length) {
    return residual_sum_(
        member, n, [&](std::size_t begin, std::size_t end) { return advance(begin, end, length, velocity, residual); });
  };

  SolverReport report;
  Products now = advance_all(0.0);
  double weight = 0;
  while (std::sqrt(now.plain) > tolerance && report.iterations < largest_iteration) {
    double* __restrict p = direction_.data();
    const double* __restrict z = preconditioned_.data();
    for (std::size_t k = twist_stride * mine.begin; k < twist_stride * mine.end; ++k) p[k] = z[k] + weight * p[k];
    member.barrier();
    lubrication.apply<false>(member, pairs, direction_);
    fluid.apply<false>(member, direction_);
    const double curvature = direction_sum_(member, n, [&](std::size_t begin, std::size_t end) {
      return apply_and_project(begin, end, pairs, lubrication, walls, fluid);
    });
    const Products next = advance_all(now.preconditioned / curvature);
    weight = next.preconditioned / now.preconditioned;
    now = next;
    ++report.iterations;
  }
  report.residual = std::sqrt(now.plain);
  report.converged = report.residual <= tolerance;
  if (!walls.present()) remove_mean_residual(member, fluid, velocity, residual);
  member.barrier();
  return report;
}

/// The best uniform shift of all velocities: it makes the total of the remaining forces zero, so that total momentum
/// is conserved to round-off however early the iteration stops.
void ResistanceSolver::remove_mean_residual(Member& member, const FluidCoupling& fluid, TwistVector& velocity,
                                            const TwistVector& residual) {
  const std::size_t n = own_linear_.size();
  const Vec3<double> force = force_sum_(member, n, [&](std::size_t begin, std::size_t end) {
    Vec3<double> sum{};
    for (std::size_t i = begin; i < end; ++i) sum += residual.get(i).linear;
    return sum;
  });
  const double resistance = resistance_sum_(member, n, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i)
      sum += own_linear_[i] + (fluid.present() ? fluid.resistance[i].linear : 0.0);
    return sum;
  });
  const Vec3<double> shift = force / resistance;
  const Range mine = member.share(n, sum_chunk);
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    double* v = velocity[i];
    v[0] += shift.x, v[1] += shift.y, v[2] += shift.z;
  }
}

}  // namespace stresslet
