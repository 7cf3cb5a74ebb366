/// A sheared simple cubic lattice through the whole coupled step: eight spheres that move with the shear, through the
/// sheared faces, against the exact rheology of the lattice at that strain (recomputed after Adler, Zuzovsky & Brenner,
/// Int. J. Multiphase Flow 11 (1985) 387).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/simulation/any_case.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/resolved/fluid_sample.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/step.hpp"

namespace stresslet {
namespace {

constexpr double phi = 0.1;
const double spacing = std::cbrt(pi / 6 / phi);

/// The plan of a case with the box of eight spheres; its packing is replaced by the lattice, `shift` up along y.
Suspension sheared_lattice(double shift, const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> keys{"suspension.solid_fraction=0.1", "suspension.count=8",
                                "suspension.sizes.law=monodisperse", "resolution.cells_per_diameter=9.79",
                                "run.strain=1"};
  keys.insert(keys.end(), overrides.begin(), overrides.end());
  const Case settled = std::get<Case>(read_any_case_text("fidelity = \"resolved\"\n", "lattice", keys));
  const Plan plan = make_plan(settled);
  Suspension s = make_suspension(settled, plan, {});
  for (std::size_t k = 0; k < 8; ++k) {
    const auto along = [&](std::size_t bit) { return (0.5 + double(k >> bit & 1)) * spacing; };
    const double y = std::fmod(along(1) + shift, 2 * spacing);
    s.state.set_position(k, {along(0), y, along(2)});
    s.state.set_velocity(k, {s.box.mean_flow(y), 0, 0});
    s.state.set_angular_velocity(k, {0, 0, -0.5});
  }
  return s;
}

struct Exact {
  double strain, viscosity, N1, N2;
};
constexpr Exact eighth{0.125, 1.24586, -0.02641, 0.01545};

void expect_rheology(Suspension& s, ThreadTeam& team, const Exact& exact) {
  while (s.strain < exact.strain - 0.5 * s.time.step) step(s, team);
  const Stress stress = sample(s, team).stress.total();
  EXPECT_NEAR((1 + stress.xy) / exact.viscosity, 1, 0.003);
  EXPECT_NEAR(stress.xx - stress.yy, exact.N1, 0.05 * std::abs(exact.N1) + 1e-3);
  EXPECT_NEAR(stress.yy - stress.zz, exact.N2, 0.05 * std::abs(exact.N2) + 1e-3);
}

TEST(ResolvedSuspension, ShearedLattice) {
  Suspension s = sheared_lattice(0);
  ThreadTeam team(1);
  start(s, team);
  expect_rheology(s, team, eighth);
}

TEST(ResolvedSuspension, ShearedLatticeInSubsteps) {
  Suspension s = sheared_lattice(0);
  s.time.substeps = 3;
  ThreadTeam team(1);
  start(s, team);
  expect_rheology(s, team, eighth);
}

/// The same with layers of spheres cut by the sheared face, and a strain on.
TEST(LongResolvedSuspension, ShearedLatticeCutByTheFace) {
  Suspension s = sheared_lattice(0.5 * spacing, {"flow.stokes=0.02"});
  ThreadTeam team(1);
  start(s, team);
  for (const Exact& exact : {eighth, Exact{0.25, 1.25616, -0.03634, 0.02127}, Exact{0.5, 1.26973, 0, 0}})
    expect_rheology(s, team, exact);
}

/// Power of the stress less what is dissipated and what is stored, over the power; means over [from, strain].
double imbalance(Suspension& s, ThreadTeam& team, double from) {
  while (s.strain < from) step(s, team);
  const Sample begin = sample(s, team);
  double stress = 0, dissipated = 0;
  Sample m = begin;
  constexpr int samples = 8, steps_between = 12;
  const double start_strain = s.strain;
  for (int n = 0; n < samples; ++n) {
    for (int k = 0; k < steps_between; ++k) step(s, team);
    m = sample(s, team);
    stress += (1 + m.stress.total().xy) / samples;
    dissipated += (1 + m.stress.stresslet.xy + m.dissipation()) / samples;
  }
  const double stored = m.elastic_energy + m.kinetic_energy - begin.elastic_energy - begin.kinetic_energy;
  return (dissipated + stored / (s.strain - start_strain)) / stress - 1;
}

/// Energy: what the stress puts in is dissipated by collisions and slip, in steady Stokes flow all of it.
TEST(ResolvedSuspension, ShearedLatticeDissipatesThePowerOfItsStress) {
  for (const char* law : {"superposition", "bounce-back"}) {
    SCOPED_TRACE(law);
    std::vector<std::string> keys{"resolution.cells_per_diameter=6.91",
                                  "resolution.coupling=\"" + std::string(law) + "\""};
    if (std::string(law) == "bounce-back")
      keys.insert(keys.end(), {"resolution.solid_weight=\"noble-torczynski\"", "resolution.correction=\"none\""});
    Suspension s = sheared_lattice(0.3, keys);
    ThreadTeam team(1);
    start(s, team);
    EXPECT_LT(std::abs(imbalance(s, team, 0.06)), 5e-4);
  }
}

Suspension dense_suspension(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> keys{"suspension.solid_fraction=0.4", "suspension.count=24",
                                "suspension.sizes.law=monodisperse", "run.strain=1", "resolution.cells_per_diameter=8"};
  keys.insert(keys.end(), overrides.begin(), overrides.end());
  const Case settled = std::get<Case>(read_any_case_text("fidelity = \"resolved\"\n", "dense", keys));
  return make_suspension(settled, make_plan(settled), {});
}

/// The same of spheres close enough for films, shared cells and contacts, out of the steady state.
TEST(ResolvedSuspension, DenseDissipatesThePowerOfItsStress) {
  Suspension s = dense_suspension();
  ThreadTeam team(1);
  start(s, team);
  EXPECT_LT(std::abs(imbalance(s, team, 0.02)), 0.01);
}

struct ThroughPlane {
  double plane, summed;  ///< relative viscosities, means; the second with the growth of the stored momentum
};
ThroughPlane through_plane(Suspension& s, ThreadTeam& team, double from, double until) {
  while (s.strain < from) step(s, team);
  sample(s, team);
  const double stored = sample_fluid(s, team).stored_momentum, begin = s.strain;
  ThroughPlane sum{0, 0};
  FluidSample fluid;
  int samples = 0;
  while (s.strain < until) {
    for (int k = 0; k < 8; ++k) step(s, team);
    const Sample m = sample(s, team);
    fluid = sample_fluid(s, team);
    sum.plane += fluid.viscosity_through_plane;
    sum.summed += 1 + m.stress.total().xy;
    ++samples;
  }
  const double growth = (fluid.stored_momentum - stored) / (s.strain - begin);
  return {sum.plane / samples, sum.summed / samples + growth};
}

/// The flux of momentum through the sheared plane holds no first moments; layers of spheres are cut by the plane.
TEST(ResolvedSuspension, ShearedLatticeCarriesItsStressThroughThePlane) {
  Suspension s = sheared_lattice(0.45 * spacing, {"resolution.cells_per_diameter=6.91"});
  ThreadTeam team(1);
  start(s, team);
  const ThroughPlane found = through_plane(s, team, 0.06, 0.12);
  EXPECT_NEAR(found.plane / found.summed, 1, 2e-3);
}

/// With films, shared cells and contacts across the plane.
TEST(ResolvedSuspension, DenseCarriesItsStressThroughThePlane) {
  Suspension s = dense_suspension();
  ThreadTeam team(1);
  start(s, team);
  const ThroughPlane found = through_plane(s, team, 0.04, 0.12);
  EXPECT_NEAR(found.plane / found.summed, 1, 5e-3);
}

/// Where the sheared face cuts the suspension makes no difference: the same spheres, half the box (a whole number of
/// cells) higher, those that leave through the face again below. Later they lie elsewhere between the cells, for the
/// frame moves with the face.
TEST(ResolvedSuspension, StartsAlikeWhereverTheFaceLies) {
  const std::vector<std::string> keys{"resolution.cells_per_diameter=8.24", "flow.reynolds=0.01", "flow.stokes=0.01"};
  Suspension centred = dense_suspension(keys), shifted = dense_suspension(keys);
  ASSERT_EQ(shifted.resolved->setup().cells[1], 26);
  const double height = shifted.box.length.y;
  for (std::size_t k = 0; k < shifted.state.size(); ++k) {
    Vec3<double> at = shifted.state.position(k);
    at.y = std::fmod(at.y + 0.5 * height, height);
    shifted.state.set_position(k, at);
    shifted.state.set_velocity(k, {shifted.box.mean_flow(at.y), 0, 0});
  }
  ThreadTeam team(1);
  start(centred, team);
  start(shifted, team);
  const StressParts a = sample(centred, team).stress, b = sample(shifted, team).stress;
  EXPECT_NEAR(b.total().xy / a.total().xy, 1, 1e-6);
  EXPECT_NEAR(b.stresslet.xy / a.stresslet.xy, 1, 1e-6);
  EXPECT_NEAR(b.stresslet.xx, a.stresslet.xx, 1e-6 * std::abs(a.stresslet.xy));
}

/// Momentum of the lattice in units of the program: rho dx^3 per cell, velocities dx/dt.
Vec3<double> fluid_momentum(const Suspension& s, ThreadTeam& team) {
  const ResolvedSetup& lattice = s.resolved->setup();
  return lattice.reynolds * std::pow(lattice.cell, 4) / lattice.step() * s.resolved->totals(team).momentum;
}

Suspension quiescent_suspension(double stokes) {
  const Case settled = std::get<Case>(
      read_any_case_text("fidelity = \"resolved\"\n", "quiescent",
                         {"suspension.solid_fraction=0.45", "suspension.count=30", "suspension.sizes.law=monodisperse",
                          "run.strain=1", "resolution.cells_per_diameter=8", "flow.boundary=periodic",
                          "flow.reynolds=0.2", fmt::format("flow.stokes={}", stokes)}));
  return make_suspension(settled, make_plan(settled), {});
}

/// Spheres as heavy as the fluid have no mass besides that of the fluid inside: it starts with their velocity.
TEST(ResolvedSuspension, FluidInsideStartsWithTheSpheres) {
  Suspension s = quiescent_suspension(0.2);
  Vec3<double> momentum{};
  for (std::size_t k = 0; k < s.state.size(); ++k) {
    s.state.set_velocity(k, {1, std::sin(double(k)), -0.5});
    s.state.set_angular_velocity(k, {0, 0, 2});
    momentum += s.state.mass(k) * s.state.velocity(k);
    EXPECT_EQ(s.state.own_mass(k), 0);
  }
  ThreadTeam team(1);
  start(s, team);
  // The cells with their centre in a sphere of 8 across make up its volume within some per cent.
  EXPECT_LT(norm(fluid_momentum(s, team) - momentum), 0.02 * norm(momentum));
  for (std::size_t k = 0; k < s.state.size(); ++k) {
    EXPECT_GT(s.state.wz[k], 0.5) << k;
    EXPECT_LT(s.state.wz[k], 2) << k;
  }
}

/// Momentum of fluid and particles together stays what it is; spheres close enough for films and shared cells. The same
/// when the particles take several steps in one of the lattice.
class ResolvedMomentum : public ::testing::TestWithParam<int> {};

TEST_P(ResolvedMomentum, IsConserved) {
  Suspension s = quiescent_suspension(0.6);
  s.time.substeps = GetParam();
  for (std::size_t k = 0; k < s.state.size(); ++k)
    s.state.set_velocity(k, {std::sin(double(k)), std::cos(2.0 * double(k)), 0.3});
  ThreadTeam team(1);
  const auto momentum = [&] {
    Vec3<double> sum = fluid_momentum(s, team);
    for (std::size_t k = 0; k < s.state.size(); ++k) sum += s.state.own_mass(k) * s.state.velocity(k);
    return sum;
  };
  start(s, team);
  const Vec3<double> before = momentum();
  for (int n = 0; n < 50; ++n) step(s, team);
  const double scale = s.state.mass(0) * double(s.state.size());
  EXPECT_LT(norm(momentum() - before), 50 * 1e-12 * scale);
  EXPECT_GT(s.fluid_coupling.friction().size(), 0u) << "no cells are shared";
}

INSTANTIATE_TEST_SUITE_P(Substeps, ResolvedMomentum, ::testing::Values(1, 3));

/// Particles are sorted in memory now and then, at a moment that must not matter: what the fluid said of them at the
/// begin of its step is kept by their places through the steps of the particles.
TEST(ResolvedSuspension, SortedOrNotInTheMidstOfAStep) {
  constexpr std::int64_t sort_in_the_fifth = 20, sort_later = 1;
  const auto after_two_steps = [](std::int64_t builds) {
    Suspension s = dense_suspension();
    s.time.substeps = 3;
    s.time.solver_tolerance = 1e-10;
    s.list = VerletList(s.list.range(), 1e-6);  // built anew at every step
    s.builds = builds;
    ThreadTeam team(1);
    start(s, team);
    for (int n = 0; n < 2; ++n) step(s, team);
    EXPECT_EQ(s.builds, builds + 7);
    std::vector<Vec3<double>> by_id(s.state.size());
    for (std::size_t i = 0; i < by_id.size(); ++i) by_id[std::size_t(s.state.id[i])] = s.state.velocity(i);
    return by_id;
  };
  const auto sorted = after_two_steps(sort_in_the_fifth), unsorted = after_two_steps(sort_later);
  for (std::size_t k = 0; k < sorted.size(); ++k) EXPECT_LT(norm(sorted[k] - unsorted[k]), 1e-7) << k;
}

/// Spheres that cross the sheared face in the midst of a step of the lattice, between two of their own, keep to the
/// fluid that they met before: as the same spheres nine cells lower do, where no face is. They are heavy, so that they
/// keep the velocity that they are given.
TEST(ResolvedSuspension, CrossedOrNotInTheMidstOfAStep) {
  constexpr double up = 0.5;  // velocity of all
  const auto after_two_steps = [](double cells_lower) {
    const std::vector<std::string> keys{"flow.reynolds=0.01", "flow.stokes=1"};
    Suspension s = sheared_lattice(0, keys);
    s.time.substeps = 3;
    s.time.solver_tolerance = 1e-10;
    const double cell = s.resolved->setup().cell, below = 1.5 * up * s.time.substep();
    for (std::size_t k = 0; k < s.state.size(); ++k) {
      Vec3<double> x = s.state.position(k);
      x.y += 0.5 * spacing - below - cells_lower * cell;
      s.state.set_position(k, x);
      s.state.set_velocity(k, {s.box.mean_flow(x.y), up, 0});
    }
    ThreadTeam team(1);
    start(s, team);
    // The velocities of the start are those that the fluid leaves: all up once more.
    std::vector<Vec3<double>> by_id(s.state.size());
    for (std::size_t k = 0; k < s.state.size(); ++k) s.state.uy[k] = up;
    int crossed = 0;
    for (int n = 0; n < 2; ++n) step(s, team);
    for (std::size_t k = 0; k < s.state.size(); ++k) {
      const Vec3<double> u = s.state.velocity(k);
      by_id[std::size_t(s.state.id[k])] = {u.x - s.box.mean_flow(s.state.y[k]), u.y, u.z};
      crossed += s.state.y[k] < 0.1 * spacing;
    }
    EXPECT_EQ(crossed, cells_lower == 0 ? 4 : 0);
    return by_id;
  };
  const auto crossed = after_two_steps(0), inside = after_two_steps(9);
  for (std::size_t k = 0; k < crossed.size(); ++k) EXPECT_LT(norm(crossed[k] - inside[k]), 1e-4) << k;
}

/// Stiffer contacts shorten the step of the particles, not that of the lattice.
TEST(ResolvedSuspension, ParticlesTakeTheStepsTheyNeed) {
  const auto settled = [](const char* stiffness) {
    return std::get<Case>(read_any_case_text("fidelity = \"resolved\"\n", "stiff",
                                             {"suspension.solid_fraction=0.2", "suspension.count=20", "run.strain=1",
                                              std::string("contact.stiffness=") + stiffness}));
  };
  const auto plan = [&](const char* stiffness) { return make_plan(settled(stiffness)); };
  const Plan soft = plan("1e4"), stiff = plan("1e6");
  EXPECT_EQ(stiff.time.step, soft.time.step);
  EXPECT_EQ(soft.time.substeps, 1);
  EXPECT_GT(stiff.time.substeps, 1);
  EXPECT_LE(stiff.time.substep(), stiff.bounds.chosen);
  EXPECT_GT(stiff.time.step / (stiff.time.substeps - 1), stiff.bounds.chosen) << "more than they need";
  EXPECT_THROW(plan("1e10"), InputError);
  const Case stiffer = settled("1e7");
  const Plan planned = make_plan(stiffer);
  EXPECT_GT(planned.time.step, 2.5 * planned.bounds.chosen);
  EXPECT_THAT(plan_report(stiffer, planned), testing::Not(testing::HasSubstr("times the default")));
}

}  // namespace
}  // namespace stresslet
