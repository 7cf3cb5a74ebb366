#include "stresslet/dem/contact/wall_contacts.hpp"

#include "stresslet/dem/laws.hpp"

namespace stresslet {

void WallContacts::prepare(std::size_t particles) {
  contacts_.assign(particles, {});
  if (history.x.size() != particles) history.resize(particles);
}

void WallContacts::update(Member& member, const ContactParameters& parameters, const ParticleState& state,
                          const ContactVelocities& velocities, const Box& box, double step) {
  if (box.kind == BoxKind::walls) {
    NormalContactLaws::dispatch(parameters.normal_law, [&](auto law) {
      using Normal = typename decltype(law)::type;
      const Range range = member.share(state.size());
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const double a = state.radius[i];
        const bool upper = state.y[i] > 0.5 * box.length.y;
        const double distance = upper ? box.length.y - state.y[i] : state.y[i];
        Contact& c = contacts_[i];
        if (distance >= a) {
          c = {};
          history.set(i, {});
          continue;
        }
        c.normal_y = upper ? 1 : -1, c.arm = distance, c.overlap = a - distance;
        const ContactGeometry geometry{{0, c.normal_y, 0}, c.overlap, a, state.mass(i), distance, 0};
        const Vec3<double> wall{box.mean_flow(upper ? box.length.y : 0.0), 0, 0};
        const Twist<double> t = velocities.over_step.get(i);
        const ContactMotion motion{
            wall - t.linear, t.angular, {}, dot(wall - velocities.now.get(i).linear, geometry.normal)};
        c.result = contact_force<Normal>(geometry, parameters, history.get(i), motion, step);
        history.set(i, c.result.elongation);
      }
    });
  }
  member.barrier();
}

}  // namespace stresslet
