/// Step bounds and stability against closed forms written out here.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/stability.hpp"
#include "stresslet/simulation/step.hpp"
#include "stresslet/simulation/time_step.hpp"

namespace stresslet {
namespace {

constexpr double pi_ = std::numbers::pi;
const std::vector<double> standard_radii{0.5, 0.7};

Physics standard_physics(double friction = 0) {
  Physics physics;
  physics.contact.stiffness = 2.5e5;
  physics.contact.tangential_ratio = 2.0 / 7;
  physics.contact.friction = friction;
  physics.cutoffs = {0.001, 0.05};
  return physics;
}

/// 6 pi a (1/(4 xi) + 9/40 ln 1/xi), the squeezing resistance of equal spheres.
double squeezing(double radius, double xi) { return 6 * pi_ * radius * (0.25 / xi - 9.0 / 40 * std::log(xi)); }

double mass(double radius, double density) { return density * 4 / 3 * pi_ * radius * radius * radius; }

/// Two spheres of diameter 1, St = 0.1: m_eff = pi/120, xi = 0.001.
TEST(StepBounds, StandardPairInExplicit) {
  const StepBounds b = step_bounds(standard_physics(), "explicit", standard_radii, 0.1);
  EXPECT_NEAR(b.contact, pi_ * std::sqrt(pi_ / 120 / 2.5e5), 1e-9);
  EXPECT_NEAR(b.contact, 1.02e-3, 0.005e-3);
  EXPECT_NEAR(b.film, pi_ / 120 / squeezing(0.5, 0.001), 1e-10);
  EXPECT_NEAR(b.film, 1.104e-5, 0.001e-5);
  EXPECT_NEAR(b.relaxation, 9.48e-3, 0.005e-3);
  EXPECT_NEAR(b.chosen, 4.97e-6, 0.01e-6);
  EXPECT_NEAR(b.largest, 5.52e-6, 0.01e-6);
  EXPECT_NE(b.binding.find("film"), std::string::npos);
}

TEST(StepBounds, StandardPairInSemiImplicit) {
  const StepBounds b = step_bounds(standard_physics(), "semi-implicit", standard_radii, 0.1);
  EXPECT_NEAR(b.chosen, 0.02 * 9.48e-3, 1e-6);
  EXPECT_NE(b.binding.find("contacts"), std::string::npos);
  const StepBounds sliding = step_bounds(standard_physics(1), "semi-implicit", standard_radii, 0.1);
  EXPECT_NEAR(sliding.sliding, std::sqrt(2.0 / 7 * pi_ / 120 / (2.0 / 7 * 2.5e5)), 1e-9);
  EXPECT_LE(sliding.largest, b.largest);
}

/// Without films a contact is an undamped oscillator.
TEST(StepBounds, DryContacts) {
  Physics dry = standard_physics();
  dry.lubrication_law = "none";
  const double half_period = pi_ * std::sqrt(pi_ / 120 / 2.5e5);
  for (const char* scheme : {"explicit", "semi-implicit"}) {
    const StepBounds b = step_bounds(dry, scheme, standard_radii, 0.1);
    EXPECT_NEAR(b.chosen, half_period / 50, 1e-9) << scheme;
    EXPECT_NEAR(b.largest, half_period / 20, 1e-9) << scheme;
  }
}

/// m_eff/X grows as the square of the size and in proportion to the density; the smallest pair decides.
TEST(StepBounds, ScaleWithSizeAndDensity) {
  const auto chosen = [](std::vector<double> radii, double density) {
    return step_bounds(standard_physics(), "explicit", radii, density).chosen;
  };
  EXPECT_NEAR(chosen({0.5}, 0.2) / chosen({0.5}, 0.1), 2, 1e-9);
  EXPECT_NEAR(chosen({0.25}, 0.1) / chosen({0.5}, 0.1), 0.25, 1e-9);
  EXPECT_EQ(chosen({0.5, 0.7, 1.0}, 0.1), chosen({0.5}, 0.1));
  std::vector<double> many;
  for (int k = 0; k < 1000; ++k) many.push_back(0.5 + 0.001 * ((k * 337) % 1000));
  EXPECT_EQ(chosen(many, 0.1), chosen({0.5}, 0.1));
}

TEST(StepBounds, NeverAboveAThousandthOfTheStrain) {
  Physics soft = standard_physics();
  soft.lubrication_law = "none";
  soft.contact.stiffness = 1;
  EXPECT_EQ(step_bounds(soft, "semi-implicit", standard_radii, 1).chosen, 1e-3);
}

Case standard_case(const std::vector<std::string>& overrides) {
  return read_case_text("[suspension]\nsolid_fraction = 0.5\ncount = 1000\n[run]\nstrain = 1\n", "case.toml",
                        overrides);
}

TEST(Plan, RefusesStepsAboveTheLimitAndTakesThoseBelow) {
  EXPECT_THROW(make_plan(standard_case({"time.scheme=explicit", "time.step=2e-5"})), InputError);
  EXPECT_THROW(make_plan(standard_case({"time.scheme=explicit", "time.step=5.6e-6"})), InputError);
  EXPECT_EQ(make_plan(standard_case({"time.scheme=explicit", "time.step=5e-6"})).time.step, 5e-6);
}

TEST(Plan, DerivedStepsFitBetweenTwoSamples) {
  for (const char* every : {"0.001", "0.0007", "0.01", "1e-6"}) {
    const Plan plan = make_plan(standard_case({std::string("output.sample_every=") + every}));
    const double steps = std::stod(every) / plan.time.step;
    EXPECT_NEAR(steps, std::round(steps), 1e-9 * steps) << every;
    EXPECT_LE(plan.time.step, plan.bounds.chosen * (1 + 1e-9)) << every;
  }
}

TEST(Plan, BoxHoldsTheSolidFraction) {
  const Plan plan = make_plan(standard_case({"suspension.box_aspect=[2, 1, 1]"}));
  double volume = 0;
  for (const double a : plan.radii) volume += 4.0 / 3 * pi_ * a * a * a;
  EXPECT_NEAR(volume / (plan.box.length.x * plan.box.length.y * plan.box.length.z), 0.5, 1e-12);
  EXPECT_NEAR(plan.box.length.x, 2 * plan.box.length.y, 1e-12);
  EXPECT_EQ(plan.count(), 1000u);
  EXPECT_NEAR(plan.density, 0.1, 1e-15);
}

/// Spheres of diameter 1 in a row along x, each `gap` from the next, in a large box at rest.
Suspension row(std::size_t count, double gap, double step) {
  Suspension s;
  s.physics = standard_physics();
  s.time.scheme = "explicit";
  s.time.step = step;
  s.box.kind = BoxKind::periodic;
  s.box.length = {20, 20, 20};
  s.state.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    s.state.set_position(i, {5 + double(i) * (1 + gap), 10, 10});
    s.state.radius[i] = 0.5, s.state.density[i] = 0.1, s.state.id[i] = std::int32_t(i);
  }
  s.list = VerletList({0.05}, 0.15);
  return s;
}

/// The fastest mode of a pair squeezes its film: lambda = X/m_eff = 2 X/m. A chain of three oscillates against its
/// middle: 3 X/m.
TEST(ExplicitStepNumber, OfAPairAndAChain) {
  const double step = 1e-6, gap = 0.002;
  const double rate = squeezing(0.5, 2 * gap) / mass(0.5, 0.1);  // xi = 2 gap/(a1 + a2)
  ThreadTeam team(1);
  Suspension pair = row(2, gap, step), chain = row(3, gap, step);
  start(pair, team), start(chain, team);
  EXPECT_NEAR(explicit_step_number(pair, team) / (step * 2 * rate), 1, 0.02);
  EXPECT_NEAR(explicit_step_number(chain, team) / (step * 3 * rate), 1, 0.03);
}

TEST(ExplicitStepNumber, StaysAtTheInnerCutoffAndVanishesBeyondTheOuter) {
  const double step = 1e-6;
  ThreadTeam team(2);
  Suspension touching = row(2, 1e-7, step), apart = row(2, 0.03, step);
  start(touching, team), start(apart, team);
  EXPECT_NEAR(explicit_step_number(touching, team), step / 1.104e-5, 0.02 * step / 1.104e-5);
  EXPECT_EQ(explicit_step_number(apart, team), 0.0);
}

}  // namespace
}  // namespace stresslet
