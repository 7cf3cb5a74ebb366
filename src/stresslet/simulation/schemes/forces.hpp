#pragma once
/// Force and torque on one particle from everything but inertia, for the twists of the last
/// `apply_pair_forces`.
#include "stresslet/lubrication/single_sphere.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

inline void apply_pair_forces(Member& member, Suspension& s) {
  s.lubrication.apply<true>(member, s.pairs, s.velocity);
  s.fluid_coupling.apply<true>(member, s.velocity);
}

inline Twist<double> total_wrench(const Suspension& s, std::size_t i, const Twist<double>& v) {
  Twist<double> f{};
  s.contacts.add_to(i, s.pairs, f);
  s.lubrication.add_to(i, s.pairs, f);
  if (s.walls.present()) {
    s.wall_contacts.add_to(i, f);
    s.walls.add_to<true>(i, v, f);
  }
  s.fluid_coupling.add_to<true>(i, v, f);
  if (s.physics.drag) {
    const double a = s.state.radius[i];
    const Vec3<double> flow{s.box.mean_flow(s.state.y[i]), 0, 0}, rotation{0, 0, -0.5 * s.box.mean_gradient()};
    f.linear += translational_drag(a) * (flow - v.linear);
    f.angular += rotational_drag(a) * (rotation - v.angular);
  }
  return f;
}

}  // namespace stresslet
