/// A resolved suspension between flat walls that move: what the walls feel and what is dissipated against the summed
/// stress, which neither of them knows, and one sphere against the stresslet of a free sphere.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/simulation/any_case.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/resolved/fluid_sample.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/step.hpp"

namespace stresslet {
namespace {

Suspension between_walls(std::vector<std::string> keys) {
  keys.insert(keys.end(), {"flow.boundary=walls", "suspension.sizes.law=monodisperse", "run.strain=1"});
  const Case settled = std::get<Case>(read_any_case_text("fidelity = \"resolved\"\n", "walls", keys));
  return make_suspension(settled, make_plan(settled), {});
}

/// Free spheres in the middle of a channel, five diameters high and from each other: 2.5 phi, raised by the walls and
/// the images by 0.56 % (recomputed by the method of fundamental solutions).
TEST(ResolvedWalls, SpheresFarApartAddTheirStresslets) {
  const double phi = pi / 6 / 125;
  Suspension s = between_walls({"suspension.solid_fraction=" + std::to_string(phi), "suspension.count=2",
                                "suspension.box_aspect=[1, 1, 2]", "resolution.cells_per_diameter=6",
                                "resolution.relaxation_time=2"});
  for (std::size_t k = 0; k < 2; ++k) {
    s.state.set_position(k, {2.5, 2.5, 2.5 + 5 * double(k)});
    s.state.set_velocity(k, {});
    s.state.set_angular_velocity(k, {0, 0, -0.5});
  }
  ThreadTeam team(1);
  start(s, team);
  // Five times the slowest relaxation of the channel, H^2/(pi^2 nu), with nu = 1/Re.
  while (s.strain < 5 * 25 * 0.1 / (pi * pi)) step(s, team);
  const Stress stress = sample(s, team).stress.total();
  EXPECT_NEAR(stress.xy / (2.5 * phi * 1.0056), 1, 0.03);
  EXPECT_NEAR(s.state.wz[0], -0.5, 0.01);
  EXPECT_NEAR(sample_fluid(s, team).viscosity_through_plane / (1 + stress.xy), 1, 1e-4);
}

/// With films and contacts at the walls, out of the steady state.
TEST(ResolvedWalls, FeelTheSummedStress) {
  Suspension s = between_walls({"suspension.solid_fraction=0.35", "suspension.count=30",
                                "resolution.cells_per_diameter=8", "contact.friction=0.5"});
  ThreadTeam team(1);
  start(s, team);
  while (s.strain < 0.04) step(s, team);
  const Sample begin = sample(s, team);
  const double stored = sample_fluid(s, team).stored_momentum, begin_strain = s.strain;
  double wall = 0, summed = 0, dissipated = 0;
  Sample m;
  FluidSample fluid;
  constexpr int samples = 40;
  for (int n = 0; n < samples; ++n) {
    for (int k = 0; k < 4; ++k) step(s, team);
    m = sample(s, team);
    fluid = sample_fluid(s, team);
    wall += fluid.viscosity_through_plane / samples;
    summed += (1 + m.stress.total().xy) / samples;
    dissipated += (1 + m.stress.stresslet.xy + m.dissipation()) / samples;
  }
  const double strain = s.strain - begin_strain;
  const double kept = m.elastic_energy + m.kinetic_energy - begin.elastic_energy - begin.kinetic_energy;
  EXPECT_NEAR((summed + (fluid.stored_momentum - stored) / strain) / wall, 1, 5e-3);
  EXPECT_NEAR((dissipated + kept / strain) / summed, 1, 0.01);
  int films = 0;
  for (std::size_t i = 0; i < s.state.size(); ++i) films += s.walls[i].normal_y != 0;
  EXPECT_GT(films, 0);
}

}  // namespace
}  // namespace stresslet
