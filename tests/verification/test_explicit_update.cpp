// The explicit update of resolved spheres: closed forms of its decay, its limit, momentum, and the semi-implicit update
// as the limit of small steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/coupling/explicit_update.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"

namespace stresslet {
namespace {

/// A fluid that moves as one with velocity u under a sphere of fluid mass m per weight B.
ExchangeSums uniform(double weight, double fluid_mass, double radius, const Vec3<double>& u) {
  ExchangeSums s;
  s.mass = weight * fluid_mass;
  s.second = (0.2 * s.mass * radius * radius) * identity3<double>();
  s.momentum = s.mass * u;
  return s;
}

TEST(ExplicitUpdate, DecaysAsTheClosedFormAgainstAFluidAtRest) {
  const double mass = 40, fluid_mass = 10, weight = 0.4, radius = 3;
  const SphereInertia inertia{mass, 0.4 * mass * radius * radius};
  std::vector<ResolvedSphere> explicit_one{{{}, radius, {1, 2, -1}, {0, 3, 1}}}, implicit_one = explicit_one;
  const auto sums = [&](std::size_t) { return uniform(weight, fluid_mass, radius, {}); };
  ExplicitUpdate update(weight);
  SphereUpdate semi_implicit;
  const int steps = 12;
  for (int n = 0; n < steps; ++n) {
    update.advance(explicit_one, {inertia}, {}, sums);
    semi_implicit.settle(implicit_one, {inertia}, {}, sums);
  }
  // Both rates are A/M: the moment of inertia of the fluid is that of its mass.
  const double rate = weight * fluid_mass / mass;
  EXPECT_NEAR(update.largest_rate(), weight + rate, 1e-14);
  EXPECT_NEAR(explicit_one[0].velocity.y, 2 * std::pow(1 - rate, steps), 1e-13);
  EXPECT_NEAR(explicit_one[0].angular_velocity.y, 3 * std::pow(1 - rate, steps), 1e-13);
  EXPECT_NEAR(implicit_one[0].velocity.y, 2 * std::pow(1 + rate, -steps), 1e-13);
  EXPECT_NEAR(implicit_one[0].angular_velocity.y, 3 * std::pow(1 + rate, -steps), 1e-13);
}

/// Slip after `steps` between a sphere and the fluid in it, both free, from a slip of 1.
double slip_after(int steps, double weight, double density_ratio) {
  const double fluid_mass = 10, mass = density_ratio * fluid_mass;
  std::vector<ResolvedSphere> sphere{{{}, 3, {1, 0, 0}, {}}};
  Vec3<double> u{};
  ExplicitUpdate update(weight);
  for (int n = 0; n < steps; ++n) {
    const ExchangeSums s = uniform(weight, fluid_mass, 3, u);
    u += weight * (sphere[0].velocity - u);
    update.advance(sphere, {{mass, 3.6 * mass}}, {}, [&](std::size_t) { return s; });
  }
  return sphere[0].velocity.x - u.x;
}

TEST(ExplicitUpdate, IsStableExactlyUpToItsLimit) {
  for (const double weight : {0.5, 1.0, 1.9}) {
    const double limit = explicit_density_ratio_limit(weight);
    EXPECT_NEAR(weight, 2 / (1 + 1 / limit), 1e-14);
    for (const double above : {1.01, 1.3}) {
      const double factor = 1 - weight * (1 + 1 / (above * limit));
      EXPECT_NEAR(slip_after(20, weight, above * limit), std::pow(factor, 20), 1e-12);
      EXPECT_LT(std::abs(factor), 1);
    }
    EXPECT_THROW(slip_after(1, weight, 0.99 * limit), NumericalFailure);
  }
}

TEST(ExplicitUpdate, RefusalNamesLimitAndCure) {
  try {
    slip_after(1, 1, 0.1);
    FAIL();
  } catch (const NumericalFailure& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("rate 11 per step"));
    EXPECT_THAT(e.what(), testing::HasSubstr("density ratio above 1"));
    EXPECT_THAT(e.what(), testing::HasSubstr("semi-implicit"));
  }
}

struct Path {
  std::vector<double> velocity, spin;  ///< at fixed physical times
  double momentum_drift = 0;           ///< per step, over what was given
};

/// A sphere pushed and twisted in a periodic box of fluid at rest, as sin^2 so that there is no sound to speak of.
Path pushed(bool is_explicit, double lambda, double density_ratio) {
  const double radius = 3, tau = 0.5 + lambda, nu = lambda / 3;
  FluidSetup setup;
  setup.grid.size = {14, 14, 14};
  setup.collision = "TRT";
  setup.rates.relaxation_time = tau;
  setup.rates.magic_parameter = 1.0 / 12;
  ResolvedFluidOf<double> fluid(setup, {"superposition", {"plane-cut", "linear", tau}});
  ThreadTeam team(1);
  fluid.initialise(team, [](const Cells&) { return CellState{}; });
  const double mass = density_ratio * 4 * pi / 3 * std::pow(radius, 3);
  SphereInertia inertia{mass, 0.4 * mass * radius * radius};
  const double speed = 0.01 * nu, push = 6 * pi * nu * radius * speed;
  std::vector<ResolvedSphere> sphere{{{6.7, 7, 7.2}, radius, {}, {}}};
  SphereUpdate semi_implicit;
  ExplicitUpdate update(LinearWeight::largest);
  const auto sums = [&](std::size_t) -> const ExchangeSums& { return fluid.exchange(0); };
  const auto momentum = [&] { return fluid.totals(team).momentum.x + mass * sphere[0].velocity.x; };
  double given = 0;
  Path path;
  const int interval = int(std::lround(6 / nu)), times = 4;
  for (int n = 1; n <= times * interval; ++n) {
    inertia.force.x = push * std::pow(std::sin(pi * (n - 0.5) / (times * interval)), 2);
    inertia.torque.z = radius * inertia.force.x;
    given += inertia.force.x;
    team.run([&](Member& member) {
      fluid.prepare(member, sphere);
      if (!is_explicit) semi_implicit.settle(sphere, {inertia}, {}, sums);
      fluid.sweep(member, sphere);
      if (is_explicit) update.advance(sphere, {inertia}, {}, sums);
    });
    sphere[0].centre += sphere[0].velocity;
    if (n % interval) continue;
    path.velocity.push_back(sphere[0].velocity.x / speed);
    path.spin.push_back(sphere[0].angular_velocity.z * radius / speed);
  }
  path.momentum_drift = std::abs(momentum() / given - 1) / (times * interval);
  return path;
}

TEST(ExplicitUpdate, MovesAsTheSemiImplicitOneAsTheStepShrinks) {
  double last = 0;
  for (const double lambda : {0.4, 0.2, 0.1}) {
    const Path one = pushed(true, lambda, 2), other = pushed(false, lambda, 2);
    EXPECT_LT(one.momentum_drift, 1e-13);
    EXPECT_LT(other.momentum_drift, 1e-13);
    double difference = 0;
    for (std::size_t k = 0; k < one.velocity.size(); ++k)
      difference =
          std::max({difference, std::abs(one.velocity[k] - other.velocity[k]), std::abs(one.spin[k] - other.spin[k])});
    EXPECT_LT(difference, 0.01);
    if (last > 0) {
      // First order; the linear weight holds the fluid more firmly, against its viscosity, as the step shrinks.
      EXPECT_NEAR(std::log2(last / difference), 1, 0.2) << lambda;
    }
    last = difference;
  }
}

TEST(ExplicitUpdate, RefusesALightSphereInTheFluid) { EXPECT_THROW(pushed(true, 0.4, 0.1), NumericalFailure); }

}  // namespace
}  // namespace stresslet
