// Oblique collisions of a sphere with a wall: gross sliding, sticking, and what lies between.
#include <gtest/gtest.h>

#include <cmath>

#include "impact.hpp"

namespace stresslet {
namespace {

using testing::collide;
using testing::Impact;
using testing::onto_wall;
using testing::sphere_mass;

constexpr double degree = pi / 180;

/// Stiff enough that the overlap, about 1e-4 radii, does not change the lever arm.
struct WallImpact {
  double radius, density, restitution, friction, tangential_ratio;
  CoulombLimit limit = CoulombLimit::spring;

  double mass() const { return sphere_mass(radius, density); }
  Impact at(double speed, double angle) const {
    const double frequency = 1e4 * speed / radius, beta = damping_ratio(restitution);
    const double duration = pi / (frequency * std::sqrt(1 - beta * beta));
    ContactParameters c;
    c.stiffness = mass() * frequency * frequency;
    c.friction = friction, c.tangential_ratio = tangential_ratio, c.damping_ratio = beta, c.coulomb_limit = limit;
    Suspension s =
        onto_wall(radius, density, {speed * std::sin(angle), -speed * std::cos(angle), 0}, c, duration / 10000);
    return collide(s);
  }
};

// Kharaz, Gorham & Salman, Powder Technol. 120 (2001) 281: aluminium oxide, radius 2.5 mm, 3.9 m/s. Sliding throughout:
// v_t' = v_t - mu (1 + e) v_n, w' = 5/2 mu (1 + e) v_n/a.
TEST(ObliqueImpact, SlidesThroughoutAtGrazingAngles) {
  const WallImpact alumina{2.5e-3, 4000, 0.98, 0.092, 2.0 / 7.0};
  const struct { double angle, tangential, spin; } cases[] = {{40, 0.7829, 544}, {60, 0.8948, 355}};
  for (const auto& c : cases) {
    const Impact impact = alumina.at(3.9, c.angle * degree);
    const double tangential = 3.9 * std::sin(c.angle * degree), normal = 3.9 * std::cos(c.angle * degree);
    EXPECT_NEAR(impact.velocity[0].x / tangential, c.tangential, 1e-4);
    EXPECT_NEAR(std::abs(impact.angular_velocity[0].z), c.spin, 0.5);
    EXPECT_NEAR(std::abs(impact.angular_velocity[0].z) * 2.5e-3 / (2.5 * 0.092 * 1.98 * normal), 1, 5e-4);
    EXPECT_LT(impact.angular_velocity[0].z, 0);  // rolls along +x on the lower wall
    EXPECT_NEAR(impact.velocity[0].y / normal, 0.98, 2e-4);
    EXPECT_EQ(impact.velocity[0].z, 0);
  }
}

// The hard sphere without tangential restitution keeps 5/7 of its tangential velocity and rolls. The surface has the
// reduced mass 2/7 m against a force at the contact, so a tangential spring kt swings with w_t^2 = 7/2 kt/m. With
// kt = kn/14 it is half the normal frequency: the undamped normal contact ends after half its period, when the
// tangential spring has just brought the surface to rest. Friction is high, so that only the last moments slide.
TEST(ObliqueImpact, SticksAndRollsWhenTheSurfaceIsBroughtToRest) {
  const WallImpact sticking{2.5e-3, 4000, 1, 1e4, 1.0 / 14.0};
  for (const double angle : {10.0, 25.0}) {
    const Impact impact = sticking.at(3.9, angle * degree);
    const double expected = 5.0 / 7.0 * 3.9 * std::sin(angle * degree);
    EXPECT_NEAR(impact.velocity[0].x / expected, 1, 5e-4);
    EXPECT_NEAR(-impact.angular_velocity[0].z * 2.5e-3 / expected, 1, 5e-4);
  }
  EXPECT_NEAR(-sticking.at(3.9, 10 * degree).angular_velocity[0].z, 193.5, 0.2);
  EXPECT_NEAR(-sticking.at(3.9, 25 * degree).angular_velocity[0].z, 470.9, 0.4);
}

/// Foerster et al., Phys. Fluids 6 (1994) 1108: psi = v_s/v_n before, psi' = v_s'/v_n after, v_s the velocity of the
/// surface; sticking psi' = -beta_0 psi, sliding psi' = psi - 7/2 mu (1 + e).
struct Material {
  const char* name;
  double restitution, friction, beta0;
};

class Foerster : public ::testing::TestWithParam<Material> {
 protected:
  /// A tangential spring never slipping leaves cos(w_t t_c) of the surface velocity: kt for cos(w_t t_c) = -beta_0,
  /// with t_c = pi/(w_n sqrt(1 - beta^2)) the damped contact.
  WallImpact impact(double friction) const {
    const Material m = GetParam();
    const double beta = damping_ratio(m.restitution), turned = std::acos(-m.beta0) / pi;
    return {1.5e-3, 2500, m.restitution, friction, 2.0 / 7.0 * turned * turned * (1 - beta * beta)};
  }
  static double psi_after(const WallImpact& w, double psi) {
    const Impact after = w.at(1.0, std::atan(psi));
    const double surface = after.velocity[0].x + w.radius * after.angular_velocity[0].z;
    return surface / std::cos(std::atan(psi));
  }
};

TEST_P(Foerster, ReversesTheSurfaceVelocityWhenItSticks) {
  for (const double psi : {0.1, 0.5}) EXPECT_NEAR(psi_after(impact(1e4), psi) / psi, -GetParam().beta0, 2e-3);
}

TEST_P(Foerster, FollowsWaltonsLineWhenItSlides) {
  const Material m = GetParam();
  for (const double psi : {3.0, 6.0})
    EXPECT_NEAR(psi_after(impact(m.friction), psi), psi - 3.5 * m.friction * (1 + m.restitution), 2e-3);
}

/// Independent slow reference for the branch between: the spring of fixed line of action (overlap small against the
/// radius), normal motion in closed form, tangential motion by small steps. In units of v_n, w_n and m.
double psi_by_integration(const Material& m, double tangential_ratio, double psi) {
  const double beta = damping_ratio(m.restitution), rest = std::sqrt(1 - beta * beta), duration = pi / rest;
  constexpr int steps = 400000;
  const double dt = duration / steps;
  double surface = psi, spring = 0;
  for (int n = 0; n < steps; ++n) {
    const double t = (n + 0.5) * dt, overlap = std::exp(-beta * t) * std::sin(rest * t) / rest;
    spring += surface * dt;
    const double limit = m.friction * overlap / tangential_ratio;
    spring = std::min(std::max(spring, -limit), limit);
    surface -= 3.5 * tangential_ratio * spring * dt;
  }
  return surface;
}

// With the friction of the material the last moments of a sticking impact slide, since the normal force vanishes while
// the spring is still stretched, so -beta_0 is not exact there; it bounds the result from below.
TEST_P(Foerster, FollowsTheSpringBetweenStickingAndSliding) {
  const Material m = GetParam();
  const WallImpact w = impact(m.friction);
  for (const double psi : {0.05, 0.4, 1.0}) {
    const double found = psi_after(w, psi);
    EXPECT_NEAR(found, psi_by_integration(m, w.tangential_ratio, psi), 2e-3);
    EXPECT_GT(found, -m.beta0 * psi - 1e-3);
    EXPECT_LT(found, psi);
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, Foerster,
                         ::testing::Values(Material{"glass on glass", 0.97, 0.092, 0.44},
                                           Material{"glass on aluminium", 0.831, 0.125, 0.31},
                                           Material{"cellulose acetate", 0.87, 0.25, 0.43}));

// A sphere set down on a wall with u0: u = u0 - mu g t, w = 5/2 mu g t/a until it rolls at t = 2 u0/(7 mu g), having
// come x = 12 u0^2/(49 mu g), with 5/7 u0 from then on. Gravity is applied between the steps.
TEST(SlidingSphere, SlowsDownAndRolls) {
  const double a = 1, u0 = 1, friction = 0.2, gravity = 10, density = 1;
  const double mass = sphere_mass(a, density), stiffness = 1e8 * mass, rolls = 2 * u0 / (7 * friction * gravity);
  ContactParameters contact;
  contact.stiffness = stiffness, contact.friction = friction;
  const double dt = rolls / 2 / 8192;
  Box box{BoxKind::walls, {16, 16, 16}, 0, 0};
  Suspension s = testing::small_system(box, {{{3, a - mass * gravity / stiffness, 8}, a, {u0, 0, 0}}},
                                       testing::dry(contact), testing::time_control("explicit", dt), density);
  ThreadTeam team(1);
  start(s, team);
  s.state.uy[0] -= 0.5 * gravity * dt;
  const auto run_half = [&] {
    for (int n = 0; n < 8192; ++n) {
      step(s, team);
      s.state.uy[0] -= gravity * dt;
    }
  };
  run_half();
  const double t = rolls / 2;
  EXPECT_NEAR(s.state.ux[0], u0 - friction * gravity * t, 1e-3);
  EXPECT_NEAR(-s.state.wz[0], 2.5 * friction * gravity * t / a, 2.5e-3);
  run_half();
  EXPECT_NEAR(s.state.x[0] - 3, 12 * u0 * u0 / (49 * friction * gravity), 1e-3 * rolls);
  run_half(), run_half();
  EXPECT_NEAR(s.state.ux[0], 5.0 / 7.0 * u0, 1e-3);
  EXPECT_NEAR(-s.state.wz[0] * a, 5.0 / 7.0 * u0, 2e-3);
  EXPECT_NEAR(s.state.x[0] - 3, 12 * u0 * u0 / (49 * friction * gravity) + 5.0 / 7.0 * u0 * rolls, 2e-3 * rolls);
}

}  // namespace
}  // namespace stresslet
