/// The restart state: complete, exact, and refused when anything in it is missing or damaged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "stresslet/base/error.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/checkpoint.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/step.hpp"

namespace stresslet {
namespace {

using ::testing::HasSubstr;

/// Sixty rough spheres with contacts, sheared for some steps.
class CheckpointOfARun : public ::testing::TestWithParam<const char*> {
 protected:
  CheckpointOfARun() {
    start(suspension_, team_);
    advance(suspension_, 60);
  }

  void advance(Suspension& s, int steps) {
    for (int k = 0; k < steps; ++k) step(s, team_);
  }

  Suspension restored(const Checkpoint& checkpoint) const {
    Suspension s = make_empty_suspension(plan_);
    restore_checkpoint(s, checkpoint);
    return s;
  }

  void expect_refused(const Checkpoint& checkpoint, const std::string& what) const {
    try {
      restored(checkpoint);
      ADD_FAILURE() << "accepted without complaint: " << what;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("\n  fix: ")) << what;
    }
  }

  Case case_ = read_case_text(
      "[suspension]\nsolid_fraction = 0.55\ncount = 60\n[contact]\nfriction = 1\n[run]\nstrain = 1\n", "case.toml",
      {std::string("time.scheme=") + GetParam(),
       GetParam() == std::string("inertialess") ? "flow.boundary=walls" : "flow.boundary=lees-edwards"});
  Plan plan_ = make_plan(case_);
  ThreadTeam team_{1};
  Suspension suspension_ = make_suspension(case_, plan_, {});
};

TEST_P(CheckpointOfARun, RoundTripIsExactAndTheContinuationEqual) {
  const Checkpoint saved = make_checkpoint(suspension_);
  Suspension copy = restored(saved);
  EXPECT_TRUE(make_checkpoint(copy) == saved);
  resume(copy);
  advance(copy, 50), advance(suspension_, 50);
  EXPECT_TRUE(make_checkpoint(copy) == make_checkpoint(suspension_));
  EXPECT_EQ(sample(copy, team_).stress.total().xy, sample(suspension_, team_).stress.total().xy);
}

TEST_P(CheckpointOfARun, EveryMissingPartIsNoticed) {
  const Checkpoint saved = make_checkpoint(suspension_);
  for (const auto& [name, array] : saved.arrays) {
    Checkpoint damaged = saved;
    damaged.arrays.erase(name);
    expect_refused(damaged, "without " + name);
  }
  for (const auto& [name, scalar] : saved.scalars) {
    Checkpoint damaged = saved;
    damaged.scalars.erase(name);
    expect_refused(damaged, "without " + name);
  }
}

TEST_P(CheckpointOfARun, EveryWrongLengthAndTypeIsNoticed) {
  const Checkpoint saved = make_checkpoint(suspension_);
  for (const auto& [name, array] : saved.arrays) {
    Checkpoint longer = saved, other_type = saved;
    std::visit([](auto& values) { values.push_back({}); }, longer.arrays[name]);
    expect_refused(longer, name + " longer");
    other_type.arrays[name] = std::vector<std::int64_t>(3, 1);
    expect_refused(other_type, name + " of another type");
    if (std::visit([](const auto& values) { return values.empty(); }, array)) continue;
    Checkpoint shorter = saved;
    std::visit([](auto& values) { values.pop_back(); }, shorter.arrays[name]);
    expect_refused(shorter, name + " shorter");
  }
}

TEST_P(CheckpointOfARun, EveryNumberThatIsNotFiniteIsNoticed) {
  const Checkpoint saved = make_checkpoint(suspension_);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [name, array] : saved.arrays) {
    const auto* values = std::get_if<std::vector<double>>(&array);
    if (!values || values->empty()) continue;
    Checkpoint damaged = saved;
    std::get<std::vector<double>>(damaged.arrays[name]).back() = nan;
    expect_refused(damaged, name + " with NaN");
  }
  for (const auto& [name, scalar] : saved.scalars) {
    if (!std::holds_alternative<double>(scalar)) continue;
    Checkpoint damaged = saved;
    damaged.scalars[name] = nan;
    expect_refused(damaged, name + " NaN");
  }
}

TEST_P(CheckpointOfARun, IndicesAndSizesOutOfRangeAreNoticed) {
  const Checkpoint saved = make_checkpoint(suspension_);
  for (const std::int32_t index : {-1, 60, 1 << 30})
    for (const char* side : {"list_i", "list_j"}) {
      Checkpoint damaged = saved;
      std::get<std::vector<std::int32_t>>(damaged.arrays[side])[0] = index;
      expect_refused(damaged, side + std::to_string(index));
    }
  for (const char* name : {"state_radius", "state_density"})
    for (const double value : {0.0, -1.0}) {
      Checkpoint damaged = saved;
      std::get<std::vector<double>>(damaged.arrays[name])[5] = value;
      expect_refused(damaged, name);
    }
  for (const char* name : {"box_length_x", "box_length_y", "box_length_z"}) {
    Checkpoint damaged = saved;
    damaged.scalars[name] = 0.0;
    expect_refused(damaged, name);
  }
  Checkpoint damaged = saved;
  std::get<std::vector<std::int32_t>>(damaged.arrays["state_id"])[3] = 4000;
  expect_refused(damaged, "state_id");
}

INSTANTIATE_TEST_SUITE_P(Checkpoint, CheckpointOfARun, ::testing::Values("semi-implicit", "explicit", "inertialess"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace stresslet
