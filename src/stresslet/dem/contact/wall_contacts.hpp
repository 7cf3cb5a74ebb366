#pragma once
/// Contact of every sphere with the nearer of the two flat walls at y = 0 and y = length.y: the pair laws with an
/// infinitely large and heavy second sphere (reduced radius a, reduced mass m, whole arm on the sphere's side).
#include <vector>

#include "stresslet/dem/contact/contact_forces.hpp"

namespace stresslet {

class WallContacts {
 public:
  void prepare(std::size_t particles);

  /// All threads; ends with a barrier. Does nothing in boxes without walls.
  void update(Member& member, const ContactParameters& parameters, const ParticleState& state,
              const ContactVelocities& velocities, const Box& box, double step);

  /// Adds the wall's force and torque on one particle.
  void add_to(std::size_t particle, Twist<double>& wrench) const {
    const Contact& c = contacts_[particle];
    if (c.normal_y == 0) return;
    wrench.linear += c.result.force;
    wrench.angular += c.arm * cross(Vec3<double>{0, c.normal_y, 0}, c.result.tangential_force);
  }

  /// Contact of one particle; `normal_y` is 0 when it touches no wall, else the direction towards the wall.
  struct Contact {
    double normal_y = 0;
    double arm = 0;
    double overlap = 0;
    ContactResult result;
  };
  const Contact& operator[](std::size_t particle) const { return contacts_[particle]; }

  ContactHistory history;  ///< per particle

 private:
  std::vector<Contact> contacts_;
};

}  // namespace stresslet
