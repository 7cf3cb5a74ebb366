// Normal collisions against closed forms: damped linear spring, elastic and damped Hertzian contact, sphere on wall.
// Steps are short (1/4000 of the contact or less), so what is left of the time step is below the tolerances.
#include <gtest/gtest.h>

#include <cmath>

#include "impact.hpp"

namespace stresslet {
namespace {

using testing::collide;
using testing::head_on;
using testing::Impact;
using testing::onto_wall;
using testing::sphere_mass;

ContactParameters contact_law(const std::string& law, double stiffness, double restitution = 1) {
  ContactParameters c;
  c.normal_law = law, c.stiffness = stiffness;
  c.damping_ratio = restitution < 1 ? damping_ratio(restitution) : 0.0;
  return c;
}

double restitution_of(const Impact& impact, double speed) {
  return (impact.velocity[1].x - impact.velocity[0].x) / speed;
}

struct LinearCase {
  double restitution, duration, largest_overlap;  // radius 0.5 mm, 2500 kg/m3, 1000 N/m, 0.1 m/s
};

class LinearImpact : public ::testing::TestWithParam<LinearCase> {};

TEST_P(LinearImpact, HasTheRestitutionDurationAndOverlapOfTheDampedOscillator) {
  const LinearCase c = GetParam();
  Suspension s = head_on(5e-4, 5e-4, 2500, 0.1, contact_law("hooke", 1000, c.restitution), c.duration / 10000);
  const Impact impact = collide(s);
  EXPECT_NEAR(restitution_of(impact, 0.1) / c.restitution, 1, 2e-4);
  EXPECT_NEAR(impact.duration / c.duration, 1, 3e-4);
  EXPECT_NEAR(impact.largest_overlap / c.largest_overlap, 1, 2e-4);
  EXPECT_NEAR(impact.velocity[0].x + impact.velocity[1].x, -0.1, 1e-12);
}

TEST_P(LinearImpact, HoldsForUnequalSpheres) {
  const LinearCase c = GetParam();
  const double a1 = 3e-4, a2 = 12e-4, speed = 0.1, stiffness = 1000, density = 2500;
  const double m1 = sphere_mass(a1, density), m2 = sphere_mass(a2, density), m = m1 * m2 / (m1 + m2);
  const double log = std::log(c.restitution), beta = -log / std::sqrt(pi * pi + log * log);
  const double rest = std::sqrt(1 - beta * beta), frequency = std::sqrt(stiffness / m);
  const double duration = pi / (frequency * rest);
  const double overlap = speed / frequency * std::exp(-beta / rest * std::atan(rest / beta));
  Suspension s = head_on(a1, a2, density, speed, contact_law("hooke", stiffness, c.restitution), duration / 10000);
  const Impact impact = collide(s);
  EXPECT_NEAR(restitution_of(impact, speed) / c.restitution, 1, 2e-4);
  EXPECT_NEAR(impact.duration / duration, 1, 3e-4);
  EXPECT_NEAR(impact.largest_overlap / overlap, 1, 2e-4);
  EXPECT_NEAR((m1 * impact.velocity[0].x + m2 * impact.velocity[1].x) / (m2 * speed), -1, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Restitutions, LinearImpact,
                         ::testing::Values(LinearCase{0.9, 8.041708e-5, 2.429763e-6},
                                           LinearCase{0.5, 8.230490e-5, 1.897787e-6}));

/// Chung & Ooi, Granular Matter 13 (2011) 643, tests 1 and 2; Hertz theory.
struct HertzCase {
  double young, poisson, density, largest_overlap, largest_force, duration;
};

class HertzPair : public ::testing::TestWithParam<HertzCase> {};

TEST_P(HertzPair, HasTheOverlapForceAndDurationOfHertz) {
  const HertzCase c = GetParam();
  const double pair_modulus = 0.5 * c.young / (1 - c.poisson * c.poisson);
  Suspension s = head_on(0.01, 0.01, c.density, 20, contact_law("hertz", 4.0 / 3.0 * pair_modulus), c.duration / 4000);
  const Impact impact = collide(s);
  EXPECT_NEAR(impact.largest_overlap / c.largest_overlap, 1, 1e-4);
  EXPECT_NEAR(impact.largest_force / c.largest_force, 1, 1e-4);
  EXPECT_NEAR(impact.duration / c.duration, 1, 4e-4);
  EXPECT_NEAR(restitution_of(impact, 20), 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(GlassAndLimestone, HertzPair,
                         ::testing::Values(HertzCase{4.8e10, 0.20, 2800, 2.7411e-4, 1.0697e4, 4.0340e-5},
                                           HertzCase{2.0e10, 0.25, 2500, 3.6830e-4, 7.1082e3, 5.4201e-5}));

class HertzWall : public ::testing::TestWithParam<HertzCase> {};

TEST_P(HertzWall, HasTheOverlapForceAndDurationOfHertz) {
  const HertzCase c = GetParam();
  const double wall_modulus = c.young / (1 - c.poisson * c.poisson);
  Suspension s =
      onto_wall(0.1, c.density, {0, -0.2, 0}, contact_law("hertz", 4.0 / 3.0 * wall_modulus), c.duration / 4000);
  const Impact impact = collide(s);
  EXPECT_NEAR(impact.largest_overlap / c.largest_overlap, 1, 1e-4);
  EXPECT_NEAR(impact.largest_force / c.largest_force, 1, 1e-4);
  EXPECT_NEAR(impact.duration / c.duration, 1, 4e-4);
  EXPECT_NEAR(impact.velocity[0].y / 0.2, 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(AluminiumAndMagnesium, HertzWall,
                         ::testing::Values(HertzCase{7.0e10, 0.30, 2699, 4.9717e-5, 1.1370e4, 7.3166e-4},
                                           HertzCase{4.0e10, 0.35, 1800, 5.2123e-5, 7.2327e3, 7.6707e-4}));

TEST(HertzDashpot, GivesTheSameRestitutionAtEverySpeed) {
  const double stiffness = 4.0 / 3.0 * 2.5e10, density = 2800;
  for (const double restitution : {0.9, 0.5}) {
    for (const double speed : {0.1, 20.0}) {
      // Duration of the elastic contact: 2.8682657 (m^2/(R E^2 v))^(1/5); damping changes it by less than a fifth.
      const double m = 0.5 * sphere_mass(0.01, density), r = 0.005, modulus = 2.5e10;
      const double duration = 2.8682657 * std::pow(m * m / (r * modulus * modulus * speed), 0.2);
      Suspension s = head_on(0.01, 0.01, density, speed, contact_law("hertz", stiffness, restitution), duration / 8000);
      EXPECT_NEAR(restitution_of(collide(s), speed) / restitution, 1, 5e-4);
    }
  }
}

}  // namespace
}  // namespace stresslet
