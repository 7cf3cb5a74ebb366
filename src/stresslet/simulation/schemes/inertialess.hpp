#pragma once
/// The limit St -> 0: forces balance at every instant, (R + D) V = F_contact + D u_mean + R (image velocities). Needs
/// Stokes drag, without which clusters of spheres can move freely and the system is singular.
#include <string_view>

#include "stresslet/simulation/schemes/implicit_solve.hpp"

namespace stresslet {

struct Inertialess {
  static constexpr std::string_view name = "inertialess";
  static constexpr std::string_view summary = "no particle inertia: forces balance at every instant; needs drag";

  static void advance_velocities(Member& member, Suspension& s, double) { implicit_solve(member, s, 0.0); }

  static Twist<double> synchronous_velocity(const Suspension& s, std::size_t i) { return s.velocity.get(i); }

  static double first_step(double step) { return step; }
};

}  // namespace stresslet
