// Semi-implicit and explicit steps from the same start agree on what carries the stress. The explicit step, 5e-6,
// resolves the thinnest film; both start from a packing sheared by 0.5.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "../small_system.hpp"
#include "stresslet/simulation/time_step.hpp"

namespace stresslet {
namespace {

using testing::time_control;

using MeanStress = std::map<std::string, double>;

/// Means of sigma_xy by part over the next 0.1 of strain, by the trapezoidal rule over samples 5e-4 apart.
MeanStress sheared_by_tenth(const Suspension& begin, const TimeControl& time, ThreadTeam& team) {
  constexpr double strain = 0.1, interval = 5e-4;
  Suspension s = testing::continued(begin, time, team);
  const auto steps = std::int64_t(std::round(interval / time.step));
  const auto samples = std::int64_t(std::round(strain / interval));
  MeanStress mean;
  for (std::int64_t n = 0; n <= samples; ++n) {
    if (n > 0) testing::advance(s, team, steps);
    const double weight = (n == 0 || n == samples ? 0.5 : 1.0) / double(samples);
    StressParts::for_each(sample(s, team).stress,
                          [&](const char* name, const Stress& part) { mean[name] += weight * part.xy; });
  }
  return mean;
}

struct Mixture {
  double solid_fraction, friction;
};

class LongSchemeAgreement : public ::testing::TestWithParam<Mixture> {};

TEST_P(LongSchemeAgreement, OnEveryPartOfTheStress) {
  Physics physics;
  physics.contact.stiffness = 2.5e5, physics.contact.friction = GetParam().friction;
  ThreadTeam team(1);
  Suspension s = testing::packed_system(500, GetParam().solid_fraction, physics, {});
  const double chosen = step_bounds(physics, "semi-implicit", s.state.radius, 0.1).chosen;
  const TimeControl implicit = time_control("semi-implicit", 5e-4 / std::ceil(5e-4 / chosen));
  s.time = implicit;
  start(s, team);
  testing::advance(s, team, std::int64_t(0.5 / implicit.step));

  const MeanStress expected = sheared_by_tenth(s, time_control("explicit", 5e-6), team),
                   found = sheared_by_tenth(s, implicit, team);
  double viscosity = 1;
  for (const auto& [name, value] : expected) viscosity += value;
  ASSERT_GT(viscosity, 5);
  for (const auto& [name, value] : expected) {
    const double scale = std::abs(value) > 0.01 * viscosity ? std::abs(value) : viscosity;
    RecordProperty(name + " explicit", std::to_string(value));
    RecordProperty(name + " difference", std::to_string((found.at(name) - value) / scale));
    EXPECT_NEAR(found.at(name), value, 0.01 * scale) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Dense, LongSchemeAgreement,
                         ::testing::Values(Mixture{0.5, 0}, Mixture{0.5, 1}, Mixture{0.6, 0}, Mixture{0.6, 1}));

}  // namespace
}  // namespace stresslet
