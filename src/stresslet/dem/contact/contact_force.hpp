#pragma once
/// The force of one contact: normal law, dashpot, and the tangential spring with its Coulomb limit.
#include <algorithm>
#include <cmath>
#include <string>

#include "stresslet/base/constants.hpp"
#include "stresslet/dem/contact/coulomb_limit.hpp"
#include "stresslet/dem/contact/tangential/spring_history.hpp"

namespace stresslet {

struct ContactParameters {
  std::string normal_law = "hooke";
  double stiffness = 0;                 ///< Hooke: force/length; Hertz: pressure
  double tangential_ratio = 2.0 / 7.0;  ///< kt/kn
  double friction = 0;                  ///< Coulomb coefficient; 0 switches the tangential spring off
  double damping_ratio = 0;             ///< beta of the restitution coefficient; 0 = no dashpot
  CoulombLimit coulomb_limit = CoulombLimit::spring;
};

/// -ln e / sqrt(pi^2 + ln^2 e).
inline double damping_ratio(double restitution) {
  const double log = std::log(restitution);
  return -log / std::sqrt(pi * pi + log * log);
}

/// One sphere against another or against a wall, at one instant.
struct ContactGeometry {
  Vec3<double> normal;  ///< from 1 to 2
  double overlap, reduced_radius, reduced_mass, arm1, arm2;
};

struct ContactResult {
  Vec3<double> force;             ///< on 1
  Vec3<double> tangential_force;  ///< part of `force`
  Vec3<double> elongation;
  double sliding_power = 0, dashpot_power = 0, elastic_energy = 0;
};

/// Velocities of a touching pair. A scheme whose velocities are half a step old moves the springs with these, which is
/// exact, but the dashpot with velocities predicted for the present, or its force would lag behind.
struct ContactMotion {
  Vec3<double> u;           ///< velocity of 2 relative to 1, over the last step
  Vec3<double> w1, w2;      ///< angular velocities, over the last step
  double separation_speed;  ///< now
};

/// `step`: time over which the tangential spring is advanced. `Normal`: a law of dem/laws.hpp.
template <class Normal>
ContactResult contact_force(const ContactGeometry& g, const ContactParameters& p, const Vec3<double>& elongation,
                            const ContactMotion& motion, double step) {
  ContactResult result;
  const Vec3<double>& e = g.normal;
  const double spring = Normal::force(g.overlap, g.reduced_radius, p.stiffness);
  result.elastic_energy = Normal::energy(g.overlap, g.reduced_radius, p.stiffness);
  double normal_force = spring;
  if (p.damping_ratio > 0) {
    const double dashpot = Normal::dashpot(g.overlap, g.reduced_radius, p.stiffness, g.reduced_mass, p.damping_ratio);
    normal_force -= dashpot * motion.separation_speed;
    result.dashpot_power = dashpot * motion.separation_speed * motion.separation_speed;
  }
  result.force = -normal_force * e;
  if (p.friction > 0) {
    const Vec3<double> sliding = tangential_part(motion.u, e) - cross(g.arm1 * motion.w1 + g.arm2 * motion.w2, e);
    const double limit = p.friction * (p.coulomb_limit == CoulombLimit::spring ? spring : std::max(normal_force, 0.0));
    const double stiffness = p.tangential_ratio * Normal::tangential_scale(g.overlap, g.reduced_radius, p.stiffness);
    const TangentialSpring t = advance_tangential_spring(elongation, e, step * sliding, stiffness, limit);
    result.elongation = t.elongation;
    result.tangential_force = t.force;
    result.force += t.force;
    result.elastic_energy += 0.5 * stiffness * dot(t.elongation, t.elongation);
    if (step > 0) result.sliding_power = dot(t.force, t.slip) / step;
  }
  return result;
}

}  // namespace stresslet
