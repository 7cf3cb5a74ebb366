/// The films that the lubricated model would see in a resolved run, against those of a lubricated run at the same
/// positions and velocities.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stresslet/simulation/any_case.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/resolved/virtual_films.hpp"
#include "stresslet/simulation/step.hpp"

namespace stresslet {
namespace {

Suspension suspension(const std::string& fidelity, const std::string& correction, const std::string& boundary) {
  std::vector<std::string> keys{"suspension.solid_fraction=0.45", "suspension.count=60", "run.strain=1",
                                "flow.boundary=" + boundary, "resolution.cells_per_diameter=6"};
  if (!correction.empty()) keys.push_back("resolution.correction=" + correction);
  const Case settled = std::get<Case>(read_any_case_text("fidelity = \"" + fidelity + "\"\n", "films", keys));
  return make_suspension(settled, make_plan(settled), {});
}

double largest_component(const Stress& s) {
  return std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.zz), std::abs(s.xy), std::abs(s.xz), std::abs(s.yz)});
}

/// Twists of `from` in the order of particles of `to`, which are sorted by lists of another range.
TwistVector twists_in_order(const Suspension& from, const Suspension& to) {
  const TwistVector velocity = synchronous_velocities(from);
  TwistVector sorted;
  sorted.resize(to.state.size());
  for (std::size_t i = 0; i < to.state.size(); ++i) {
    const auto same = std::find(from.state.id.begin(), from.state.id.end(), to.state.id[i]);
    sorted.set(i, velocity.get(std::size_t(same - from.state.id.begin())));
  }
  return sorted;
}

class VirtualFilms : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(VirtualFilms, AreThoseOfALubricatedRunInTheSameState) {
  const auto [correction, boundary] = GetParam();
  Suspension lubricated = suspension("lubricated", "", boundary),
             resolved = suspension("resolved", correction, boundary);
  resolved.state = lubricated.state;
  resolved.box = lubricated.box;
  ThreadTeam team(1);
  start(lubricated, team);
  start(resolved, team);
  const StressParts expected = sample(lubricated, team).stress;
  const StressParts found = virtual_film_stress(resolved, twists_in_order(lubricated, resolved), team);
  EXPECT_GT(expected.lubrication_normal.xy, 0.1);
  EXPECT_GT(expected.lubrication_tangential.xy, 0.1);
  for (const auto part : {&StressParts::lubrication_normal, &StressParts::lubrication_tangential,
                          &StressParts::lubrication_rotational, &StressParts::lubrication_strain})
    EXPECT_LT(largest_component(found.*part - expected.*part), 1e-10 * largest_component(expected.lubrication_normal));
}

INSTANTIATE_TEST_SUITE_P(All, VirtualFilms,
                         testing::Combine(testing::Values("none", "soft-cut-off"),
                                          testing::Values("lees-edwards", "walls")),
                         [](const auto& choice) {
                           std::string name = std::string(std::get<0>(choice.param)) + "_" + std::get<1>(choice.param);
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace stresslet
