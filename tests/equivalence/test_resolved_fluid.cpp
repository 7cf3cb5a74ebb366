/// Spheres in the resolved fluid: momentum of both together, and the same bits whatever the division of the work.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/coupling/sphere_update.hpp"

namespace stresslet {
namespace {

constexpr int edge = 20;

FluidSetup stirred_box(Closure closure_in_y) {
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.grid.closure[1] = closure_in_y;
  setup.rates.relaxation_time = 0.8;
  setup.rates.magic_parameter = 1.0 / 12;
  return setup;
}

std::vector<ResolvedSphere> spheres() {
  return {{{4.3, 18.8, 10.2}, 3.5, {0.002, -0.004, 0.001}, {2e-4, 0, -4e-4}},
          {{13.1, 9.4, 0.4}, 4.1, {-0.002, 0.002, 0}, {0, 6e-4, 0}},
          {{13.3, 1.6, 0.9}, 3.6, {0.001, 0.003, 0}, {0, 0, 3e-4}}};  // shares cells with the second
}

/// Free spheres for some steps; calls `watch(fluid, spheres)` after every step.
template <class Watch>
void run(ResolvedFluid& fluid, ThreadTeam& team, int steps, Watch&& watch) {
  fluid.initialise(team, [](const Cells& c) {
    CellState s;
    s.velocity = {0.002 * std::sin(0.3 * c[1]), 0.001 * std::cos(0.3 * c[0]), 4e-4};
    return s;
  });
  std::vector<ResolvedSphere> free = spheres();
  std::vector<SphereInertia> inertia;
  for (const ResolvedSphere& s : free) {
    const double mass = 4.0 * std::pow(s.radius, 3);
    inertia.push_back({mass, 0.4 * mass * s.radius * s.radius});
  }
  SphereUpdate update;
  for (int n = 0; n < steps; ++n) {
    team.run([&](Member& member) {
      fluid.prepare(member, free);
      if (member.rank() == 0) {
        std::vector<SphereLink> links;
        for (const PointFriction& friction : fluid.friction()) links.push_back(link_of(friction));
        update.settle(
            free, inertia, links, [&](std::size_t k) -> const auto& { return fluid.exchange(k); });
      }
      member.barrier();
      fluid.sweep(member, free);
    });
    watch(fluid, free);
    for (ResolvedSphere& sphere : free) sphere.centre += sphere.velocity;
  }
}

class EveryOperator : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryOperator, ConservesTheMomentumOfFluidAndSpheres) {
  CouplingSetup coupling;
  coupling.coupling_operator = GetParam();
  CouplingOperators::dispatch(GetParam(), [&](auto law) {
    if (decltype(law)::type::largest_weight < 2) coupling.solid.weight = "linear";
  });
  ResolvedFluidOf<double> fluid(stirred_box(Closure::periodic), coupling);
  ThreadTeam team(1);
  Vec3<double> before{};
  bool first = true;
  run(fluid, team, 12, [&](ResolvedFluid& now, const std::vector<ResolvedSphere>& free) {
    Vec3<double> momentum = now.totals(team).momentum;
    for (const ResolvedSphere& s : free) momentum += 4.0 * std::pow(s.radius, 3) * s.velocity;
    if (!first) {
      EXPECT_LT(norm(momentum - before), 1e-12);
    }
    before = momentum;
    first = false;
  });
}

INSTANTIATE_TEST_SUITE_P(Coupling, EveryOperator, ::testing::ValuesIn(CouplingOperators::names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Velocities of the free spheres, one after the other, over 9 steps in a sheared box.
std::vector<double> velocities(bool single_precision, const Cells& blocks, int threads) {
  FluidSetup setup = stirred_box(Closure::sheared);
  setup.shear_velocity_lu = 0.03;
  setup.grid.blocks = blocks;
  setup.single_precision = single_precision;
  const auto fluid = ResolvedFluid::make(setup, {});
  ThreadTeam team(threads);
  std::vector<double> found;
  run(*fluid, team, 9, [&](ResolvedFluid&, const std::vector<ResolvedSphere>& free) {
    for (const ResolvedSphere& s : free)
      for (const Vec3<double>& v : {s.velocity, s.angular_velocity}) found.insert(found.end(), {v.x, v.y, v.z});
  });
  return found;
}

class ResolvedFluidInPrecision : public ::testing::TestWithParam<bool> {};

TEST_P(ResolvedFluidInPrecision, SameBitsForAnyThreadsAndBlocks) {
  const std::vector<double> expected = velocities(GetParam(), {1, 1, 1}, 1);
  for (const Cells& blocks : {Cells{1, 1, 1}, Cells{2, 1, 1}, Cells{2, 3, 2}})
    for (const int threads : {1, 2, 3})
      EXPECT_EQ(velocities(GetParam(), blocks, threads), expected)
          << blocks[0] << blocks[1] << blocks[2] << " blocks, " << threads << " threads";
}

TEST_P(ResolvedFluidInPrecision, GoesOnWithTheSameBits) {
  FluidSetup setup = stirred_box(Closure::periodic);
  setup.single_precision = GetParam();
  ThreadTeam team(2);
  const auto first = ResolvedFluid::make(setup, {}), second = ResolvedFluid::make(setup, {});
  run(*first, team, 5, [](auto&&...) {});
  second->restore(team, first->populations(team), 5);
  for (const auto& fluid : {first.get(), second.get()})
    team.run([&](Member& member) {
      fluid->prepare(member, spheres());
      fluid->sweep(member, spheres());
    });
  EXPECT_EQ(first->populations(team), second->populations(team));
}

INSTANTIATE_TEST_SUITE_P(Precision, ResolvedFluidInPrecision, ::testing::Values(false, true),
                         [](const auto& test) { return test.param ? "Single" : "Double"; });

TEST(ResolvedFluid, SinglePrecisionFollowsDouble) {
  const std::vector<double> fine = velocities(false, {1, 1, 1}, 1), coarse = velocities(true, {1, 1, 1}, 1);
  ASSERT_EQ(fine.size(), coarse.size());
  double largest = 0;
  for (std::size_t k = 0; k < fine.size(); ++k) largest = std::max(largest, std::abs(coarse[k] - fine[k]));
  // Velocities are some 1e-3: a few units of 1.2e-7 of them.
  EXPECT_LT(largest, 3e-9);
  EXPECT_GT(largest, 0);
}

TEST(ResolvedFluid, SinglePrecisionKeepsMomentumToItsRoundOff) {
  FluidSetup setup = stirred_box(Closure::periodic);
  setup.single_precision = true;
  const auto fluid = ResolvedFluid::make(setup, {});
  ThreadTeam team(1);
  std::vector<Vec3<double>> momenta;
  run(*fluid, team, 12, [&](ResolvedFluid& now, const std::vector<ResolvedSphere>& free) {
    momenta.push_back(now.totals(team).momentum);
    for (const ResolvedSphere& s : free) momenta.back() += 4.0 * std::pow(s.radius, 3) * s.velocity;
  });
  // Of some 10 in all.
  EXPECT_LT(norm(momenta.back() - momenta.front()), 2e-6);
}

}  // namespace
}  // namespace stresslet
