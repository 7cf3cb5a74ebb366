#pragma once
/// Contact kernel: forces of all overlapping pairs and their tangential history.
///
/// Per active pair: reads index and gap (12 B). Per contact: reads 76 B of the pair, four twists (256 B, from cache)
/// and the densities, writes 96 B, about 60 flops; with friction reads and writes 24 B of history, about 150 flops.
/// With friction the history of every candidate that does not touch is cleared as well (4 B read, 24 B written).
/// Contacts are few (one or two per particle), so the loop stays scalar.
#include <vector>

#include "stresslet/dem/contact/contact_force.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/particles/active_pairs.hpp"
#include "stresslet/particles/twist.hpp"

namespace stresslet {

/// Elongation of the tangential spring of every pair in the Verlet list (of j relative to i); zero when apart.
struct ContactHistory {
  std::vector<double> x, y, z;
  void resize(std::size_t n) { x.assign(n, 0.0), y.assign(n, 0.0), z.assign(n, 0.0); }
  Vec3<double> get(std::size_t k) const { return {x[k], y[k], z[k]}; }
  void set(std::size_t k, const Vec3<double>& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
};

/// Twists over the last step and, for dashpots, now.
struct ContactVelocities {
  const TwistVector& over_step;
  const TwistVector& now;
};

class ContactForces {
 public:
  /// Forces at the present positions; the springs are advanced by `step`. Called by all threads; ends with a barrier.
  void update(Member& member, const ContactParameters& parameters, const ActivePairs& pairs,
              const ContactVelocities& velocities, const ParticleState& state, double velocity_jump, double step,
              ContactHistory& history);

  void prepare(std::size_t capacity);

  /// Adds the contact force and torque on one particle.
  void add_to(std::size_t particle, const ActivePairs& pairs, Twist<double>& wrench) const {
    pairs.for_each_pair_of(particle, [&](std::size_t p, double sign) {
      if (pairs.gap[p] >= 0) return;
      const double a = sign > 0 ? pairs.radius_i[p] : pairs.radius_j[p];
      const double arm = a * pairs.distance[p] / (pairs.radius_i[p] + pairs.radius_j[p]);
      wrench.linear += sign * results_[p].force;
      wrench.angular += arm * cross(pairs.normal(p), results_[p].tangential_force);
    });
  }

  /// Valid for pairs with negative gap.
  const ContactResult& operator[](std::size_t pair) const { return results_[pair]; }

 private:
  template <class Normal>
  void update_range(Range range, const ContactParameters& parameters, const ActivePairs& pairs,
                    const ContactVelocities& velocities, const ParticleState& state, double velocity_jump, double step,
                    ContactHistory& history);

  std::vector<ContactResult> results_;
};

}  // namespace stresslet
