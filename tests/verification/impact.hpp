#pragma once
/// Collisions run through whole time steps: two spheres head-on, or a sphere on the lower wall. SI units.
#include <algorithm>

#include "../small_system.hpp"

namespace stresslet::testing {

struct Impact {
  double duration = 0;
  double largest_overlap = 0;
  double largest_force = 0;
  std::vector<Vec3<double>> velocity, angular_velocity;  ///< afterwards, by id
};

/// Steps `s` until its one contact has begun and ended.
inline Impact collide(Suspension& s) {
  ThreadTeam team(1);
  start(s, team);
  Impact impact;
  std::int64_t contact_steps = 0;
  for (bool touched = false, apart = false; !apart;) {
    step(s, team);
    double overlap = 0, force = 0;
    for (std::size_t p = 0; p < s.pairs.size(); ++p)
      if (s.pairs.gap[p] < 0) overlap = -s.pairs.gap[p], force = norm(s.contacts[p].force);
    if (s.box.kind == BoxKind::walls)
      for (std::size_t i = 0; i < s.state.size(); ++i)
        if (s.wall_contacts[i].normal_y != 0)
          overlap = s.wall_contacts[i].overlap, force = norm(s.wall_contacts[i].result.force);
    apart = touched && overlap <= 0;
    touched = touched || overlap > 0;
    contact_steps += overlap > 0;
    impact.largest_overlap = std::max(impact.largest_overlap, overlap);
    impact.largest_force = std::max(impact.largest_force, force);
  }
  impact.duration = double(contact_steps) * s.time.step;
  for (std::int32_t id = 0; id < std::int32_t(s.state.size()); ++id) {
    impact.velocity.push_back(s.state.velocity(index_of(s, id)));
    impact.angular_velocity.push_back(s.state.angular_velocity(index_of(s, id)));
  }
  return impact;
}

/// Two spheres that touch after half a step: sphere 0 at rest, sphere 1 comes along -x with `speed`.
inline Suspension head_on(double a1, double a2, double density, double speed, const ContactParameters& contact,
                          double time_step) {
  const double length = 8 * (a1 + a2), gap = 0.5 * speed * time_step;
  Box box{BoxKind::periodic, {length, length, length}, 0, 0};
  const Vec3<double> middle{length / 2, length / 2, length / 2};
  return small_system(box, {{middle, a1}, {middle + Vec3<double>{a1 + a2 + gap, 0, 0}, a2, {-speed, 0, 0}}},
                      dry(contact), time_control("explicit", time_step), density, 0.5 * std::min(a1, a2));
}

/// A sphere that reaches the resting lower wall after half a step.
inline Suspension onto_wall(double a, double density, const Vec3<double>& velocity, const ContactParameters& contact,
                            double time_step) {
  const double length = 16 * a;
  Box box{BoxKind::walls, {length, length, length}, 0, 0};
  return small_system(box, {{{length / 2, a - 0.5 * velocity.y * time_step, length / 2}, a, velocity}}, dry(contact),
                      time_control("explicit", time_step), density, 0.5 * a);
}

inline double sphere_mass(double a, double density) { return density * 4.0 / 3.0 * pi * a * a * a; }

}  // namespace stresslet::testing
