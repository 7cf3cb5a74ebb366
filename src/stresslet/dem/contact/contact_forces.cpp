#include "stresslet/dem/contact/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/dem/contact/tangential/spring_history.hpp"

namespace stresslet {

double damping_ratio(double restitution) {
  const double log = std::log(restitution);
  return -log / std::sqrt(pi * pi + log * log);
}

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

template ContactResult contact_force<Hooke>(const ContactGeometry&, const ContactParameters&, const Vec3<double>&,
                                            const ContactMotion&, double);
template ContactResult contact_force<Hertz>(const ContactGeometry&, const ContactParameters&, const Vec3<double>&,
                                            const ContactMotion&, double);

void ContactForces::prepare(std::size_t capacity) { results_.assign(capacity, {}); }

template <class Normal>
void ContactForces::update_range(Range range, const ContactParameters& parameters, const ActivePairs& pairs,
                                 const ContactVelocities& velocities, const ParticleState& state, double velocity_jump,
                                 double step, ContactHistory& history) {
  for (std::size_t p = range.begin; p < range.end; ++p) {
    const std::size_t k = std::size_t(pairs.candidate[p]);
    if (pairs.gap[p] >= 0) continue;
    const std::size_t i = std::size_t(pairs.i[p]), j = std::size_t(pairs.j[p]);
    const Vec3<double> jump{pairs.images_up[p] * velocity_jump, 0, 0};
    const auto relative = [&](const TwistVector& t) { return t.get(j).linear - t.get(i).linear - jump; };
    const ContactMotion motion{relative(velocities.over_step), velocities.over_step.get(i).angular,
                               velocities.over_step.get(j).angular, dot(relative(velocities.now), pairs.normal(p))};
    const double a1 = pairs.radius_i[p], a2 = pairs.radius_j[p], sum = a1 + a2;
    const double m1 = state.mass(i), m2 = state.mass(j);
    const ContactGeometry geometry{pairs.normal(p),
                                   -pairs.gap[p],
                                   a1 * a2 / sum,
                                   m1 * m2 / (m1 + m2),
                                   a1 * pairs.distance[p] / sum,
                                   a2 * pairs.distance[p] / sum};
    results_[p] = contact_force<Normal>(geometry, parameters, history.get(k), motion, step);
    if (parameters.friction > 0) history.set(k, results_[p].elongation);
  }
}

void ContactForces::update(Member& member, const ContactParameters& parameters, const ActivePairs& pairs,
                           const ContactVelocities& velocities, const ParticleState& state, double velocity_jump,
                           double step, ContactHistory& history) {
  NormalContactLaws::dispatch(parameters.normal_law, [&](auto law) {
    using Normal = typename decltype(law)::type;
    update_range<Normal>(member.share(pairs.size()), parameters, pairs, velocities, state, velocity_jump, step,
                         history);
  });
  if (parameters.friction > 0) {
    const Range candidates = member.share(history.x.size());
    for (std::size_t k = candidates.begin; k < candidates.end; ++k)
      if (!pairs.in_contact(k)) history.set(k, {});
  }
  member.barrier();
}

}  // namespace stresslet
