// Forces and torques that the contact kernel hands to the particles of a pair balance, for every law.
#include <gtest/gtest.h>

#include "../random_pairs.hpp"
#include "../small_system.hpp"
#include "stresslet/dem/laws.hpp"

namespace stresslet {
namespace {

using testing::Draw;
using testing::Sphere;

Suspension touching_pair(Draw& draw, const std::string& law) {
  const double a1 = draw.log_uniform(0.1, 10), a2 = std::clamp(a1 * draw.log_uniform(0.1, 10), 0.1, 10.0);
  const double length = 6 * (a1 + a2), distance = (a1 + a2) * draw.uniform(0.97, 0.999);
  const Vec3<double> e = draw.direction(), middle{length / 2, length / 2, length / 2};
  const auto sphere = [&](double place, double radius) {
    return Sphere{middle + place * distance * e, radius, draw.vector(), draw.vector()};
  };
  ContactParameters contact;
  contact.normal_law = law, contact.stiffness = draw.log_uniform(1, 1e4), contact.friction = 0.4;
  contact.damping_ratio = 0.05;
  Box box{BoxKind::periodic, {length, length, length}, 0, 0};
  return testing::small_system(box, {sphere(-0.5, a1), sphere(0.5, a2)}, testing::dry(contact),
                               testing::time_control("explicit", 1e-6), 1.0);
}

TEST(ContactBalance, ForcesCancelAndTorquesSumToTheCoupleOfTheForce) {
  Draw draw(3);
  ThreadTeam team(1);
  for (const std::string& law : NormalContactLaws::names()) {
    for (int n = 0; n < 200; ++n) {
      Suspension s = touching_pair(draw, law);
      start(s, team);
      testing::advance(s, team, 5);
      const std::size_t i = testing::index_of(s, 0), j = testing::index_of(s, 1);
      Twist<double> on_i{}, on_j{};
      s.contacts.add_to(i, s.pairs, on_i);
      s.contacts.add_to(j, s.pairs, on_j);
      const Vec3<double> r = s.state.position(j) - s.state.position(i);
      ASSERT_GT(norm(on_i.angular), 0);
      EXPECT_EQ(on_i.linear, -on_j.linear);
      EXPECT_LE(norm(on_i.angular + on_j.angular - cross(r, on_i.linear)), 1e-12 * norm(r) * norm(on_i.linear));
      EXPECT_NEAR(norm(on_i.angular) * s.state.radius[j], norm(on_j.angular) * s.state.radius[i],
                  1e-12 * norm(on_i.angular) * s.state.radius[j]);
    }
  }
}

}  // namespace
}  // namespace stresslet
