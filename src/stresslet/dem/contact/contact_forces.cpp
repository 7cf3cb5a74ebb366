#include "stresslet/dem/contact/contact_forces.hpp"

#include "stresslet/dem/laws.hpp"

namespace stresslet {

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
