#pragma once
/// Lubrication and drag implicit, contacts explicit:
///   (M/dt + R + D) V(n+1) = M V(n)/dt + F_contact(x(n)) + D u_mean + R (image velocities),  x(n+1) = x(n) + dt V(n+1).
/// First order. The system is symmetric positive; `residual` is formed from the physical forces at a guess of V(n+1),
/// so that image velocities, drag and walls enter once, as forces. The step is bound by the contacts, not by the films.
#include <string_view>

#include "stresslet/simulation/schemes/implicit_solve.hpp"

namespace stresslet {

struct SemiImplicit {
  static constexpr std::string_view name = "semi-implicit";
  static constexpr std::string_view summary = "lubrication implicit, contacts explicit; step bound by the contacts";

  static void advance_velocities(Member& member, Suspension& s, double step) { implicit_solve(member, s, 1 / step); }

  static Twist<double> synchronous_velocity(const Suspension& s, std::size_t i) { return s.velocity.get(i); }

  static double first_step(double step) { return step; }
};

}  // namespace stresslet
