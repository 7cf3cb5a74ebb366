#pragma once
/// Velocity Verlet with velocities at half steps (leap-frog): U(t + dt/2) = U(t - dt/2) + dt F(x(t), U(t - dt/2))/m.
/// Second order for the positions; lubrication is taken at the old half step, so the step must resolve its relaxation:
/// dt <= 0.45 m_eff/X_max (docs/theory.md). Above that nothing blows up: contacts are lost silently.
#include <string_view>

#include "stresslet/simulation/schemes/forces.hpp"

namespace stresslet {

struct Explicit {
  static constexpr std::string_view name = "explicit";
  static constexpr std::string_view summary = "velocity Verlet at half steps; step bound by the thinnest film";

  static void advance_velocities(Member& member, Suspension& s, double step) {
    apply_pair_forces(member, s);
    const Range mine = member.share(s.state.size(), sum_chunk);
    for (std::size_t i = mine.begin; i < mine.end; ++i) {
      const Twist<double> v = s.velocity.get(i), f = total_wrench(s, i, v);
      const Twist<double> change{step / s.state.mass(i) * f.linear, step / s.state.inertia(i) * f.angular};
      s.change.set(i, change);
      s.state.set_velocity(i, v.linear + change.linear);
      s.state.set_angular_velocity(i, v.angular + change.angular);
    }
    member.barrier();
  }

  /// Velocities known at the half step before the positions are brought to them by half of the last change.
  static Twist<double> synchronous_velocity(const Suspension& s, std::size_t i) {
    const Twist<double> v = s.velocity.get(i), c = s.change.get(i);
    return {v.linear + 0.5 * c.linear, v.angular + 0.5 * c.angular};
  }

  static double first_step(double step) { return 0.5 * step; }
};

}  // namespace stresslet
