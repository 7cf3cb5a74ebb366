// Explicit steps through a contact are of second order: errors at 1/20, 1/50 and 1/100 of its duration.
#include <gtest/gtest.h>

#include <cmath>

#include "../small_system.hpp"

namespace stresslet {
namespace {

constexpr double mass_density = 1, radius = 0.5, speed = 1;
constexpr double mass = mass_density * 4 / 3 * pi * radius * radius * radius;
constexpr double frequency = 1e7;  // stiff: overlaps of 1e-7 leave the lever arm of friction alone

struct OnWall {
  double overlap, elongation;
};

/// A sphere already pressed into the wall, moving on and along it; its overlap and tangential spring after 0.6 of the
/// duration of a contact.
OnWall after_part_of_contact(double damping, int steps_per_contact) {
  const double duration = pi / (frequency * std::sqrt(1 - damping * damping));
  ContactParameters contact;
  contact.stiffness = mass * frequency * frequency, contact.damping_ratio = damping;
  contact.friction = 1e6, contact.tangential_ratio = 2.0 / 7.0;
  const Box box{BoxKind::walls, {8, 8, 8}, 0, 0};
  Suspension s = testing::small_system(box, {{{4, radius - 0.2 * speed / frequency, 4}, radius, {speed, -speed, 0}}},
                                       testing::dry(contact),
                                       testing::time_control("explicit", duration / steps_per_contact), mass_density);
  ThreadTeam team(1);
  start(s, team);
  testing::advance(s, team, 6 * steps_per_contact / 10);
  return {radius - s.state.y[0], std::abs(s.wall_contacts.history.x[0])};
}

/// Damped oscillator from (overlap, rate) = (0.2, 1); tangential frequency sqrt(7/2 kt/m) = the normal one for 2/7.
OnWall exact(double damping) {
  const double rest = std::sqrt(1 - damping * damping), t = 0.6 * pi / rest;
  const double overlap =
      std::exp(-damping * t) * (0.2 * std::cos(rest * t) + (1 + 0.2 * damping) / rest * std::sin(rest * t));
  return {overlap * speed / frequency, std::sin(t) * speed / frequency};
}

class ContactTimeStep : public ::testing::TestWithParam<double> {};

TEST_P(ContactTimeStep, IsOfSecondOrder) {
  const OnWall limit = exact(GetParam());
  const int steps[] = {20, 50, 100};
  double overlap[3], elongation[3];
  for (int k = 0; k < 3; ++k) {
    const OnWall found = after_part_of_contact(GetParam(), steps[k]);
    overlap[k] = std::abs(found.overlap / limit.overlap - 1);
    elongation[k] = std::abs(found.elongation / limit.elongation - 1);
  }
  for (int k = 1; k < 3; ++k) {
    const double refinement = std::log(double(steps[k]) / steps[k - 1]);
    EXPECT_NEAR(std::log(overlap[k - 1] / overlap[k]) / refinement, 2, 0.2);
    EXPECT_NEAR(std::log(elongation[k - 1] / elongation[k]) / refinement, 2, 0.2);
  }
  EXPECT_LT(overlap[2], 1e-3);
  EXPECT_LT(elongation[2], 1e-3);
}

INSTANTIATE_TEST_SUITE_P(DampingRatios, ContactTimeStep, ::testing::Values(0.0, 0.0335, 0.2155));

}  // namespace
}  // namespace stresslet
