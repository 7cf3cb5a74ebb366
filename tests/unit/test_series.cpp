#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/series.hpp"
#include "stresslet/simulation/summary.hpp"

namespace stresslet {
namespace {

TEST(Series, ColumnsAreDistinctAndDescribed) {
  std::set<std::string> names;
  for (const Column& column : series_columns(FluidColumns::resolved_and_sheared)) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(column.unit.empty() || column.description.empty()) << column.name;
  }
  for (const char* part : {"contact", "lubrication_normal", "lubrication_tangential", "lubrication_rotational",
                           "lubrication_strain", "stresslet", "reynolds", "acceleration"})
    for (const char* axes : {"_xx", "_yy", "_zz", "_xy", "_xz", "_yz"})
      EXPECT_TRUE(names.count(std::string(part) + axes)) << part << axes;
}

TEST(Series, RowFollowsFromTheSample) {
  Sample sample;
  sample.stress.contact = {1, 2, 4, 8, 0, 0};  // xx yy zz xy xz yz
  sample.stress.stresslet.xy = 1.25;
  sample.stress.reynolds.xx = -0.5;
  sample.contacts = 30;
  Series series;
  series.add(0.5, sample, 20, 7);
  EXPECT_EQ(series["strain"][0], 0.5);
  EXPECT_EQ(series["relative_viscosity"][0], 1 + 8 + 1.25);
  EXPECT_EQ(series["N1"][0], 0.5 - 2);
  EXPECT_EQ(series["N2"][0], 2 - 4);
  EXPECT_DOUBLE_EQ(series["particle_pressure"][0], -(0.5 + 2 + 4) / 3);
  EXPECT_EQ(series["contacts_per_particle"][0], 3.0);
  EXPECT_EQ(series["solver_iterations"][0], 7.0);
  EXPECT_THROW(series["viscosity"], std::out_of_range);
}

/// Dissipated, stored or done by the stresslet: together the power that the stress puts in.
TEST(Series, ViscosityFromDissipationHoldsTheGrowthOfEnergy) {
  Sample sample;
  sample.stress.stresslet.xy = 1.25;
  sample.dissipation_lubrication = 2, sample.dissipation_sliding = 0.5;
  sample.dissipation_dashpot = 0.25, sample.dissipation_drag = 0.125;
  sample.elastic_energy = 1, sample.kinetic_energy = 0.1;
  Series series;
  series.add(0, sample, 20, 0);
  sample.elastic_energy = 1.3, sample.kinetic_energy = 0.2;
  series.add(0.1, sample, 20, 0);
  series.add(0.2, sample, 20, 0);
  const auto& viscosity = series["relative_viscosity_from_dissipation"];
  EXPECT_DOUBLE_EQ(viscosity[0], 1 + 1.25 + 2.875);
  EXPECT_NEAR(viscosity[1], 1 + 1.25 + 2.875 + 4, 1e-12);
  EXPECT_NEAR(viscosity[2], 1 + 1.25 + 2.875, 1e-12);
}

TEST(Series, RestoredRowsGoOnLikeAddedOnes) {
  Sample sample;
  sample.elastic_energy = 1;
  Series whole, restored;
  restored.restore(whole.add(0, sample, 20, 0));
  sample.elastic_energy = 3;
  EXPECT_EQ(whole.add(0.5, sample, 20, 0), restored.add(0.5, sample, 20, 0));
}

TEST(Series, FirstRowFromForgivesRoundOff) {
  Series series;
  for (int k = 0; k < 10; ++k) series.add(0.1 * k, {}, 20, 0);
  EXPECT_EQ(series.first_row_from(0), 0u);
  EXPECT_EQ(series.first_row_from(0.3), 3u);  // 0.1 * 3 > 0.3 in binary, 0.7 < 0.1 * 7
  EXPECT_EQ(series.first_row_from(0.7), 7u);
  EXPECT_EQ(series.first_row_from(0.31), 4u);
  EXPECT_EQ(series.first_row_from(2), 10u);
}

Case case_with(const std::string& run) {
  return read_case_text("[suspension]\nsolid_fraction = 0.5\n[run]\nstrain = 10\n" + run, "case.toml");
}

/// Settles exponentially from 9 to 4 within about 1 of strain, with a regular ripple.
Series settling_series(double strain) {
  Series series;
  Sample sample;
  for (int k = 0; 0.01 * k < strain; ++k) {
    sample.stress.contact.xy = 3 + 5 * std::exp(-0.03 * k) + 0.1 * std::sin(0.7 * k);
    series.add(0.01 * k, sample, 20, 0);
  }
  return series;
}

TEST(AveragingWindow, StartsWhereTheInputSays) {
  const AveragingWindow window = averaging_window(case_with("average_from = 2\n"), settling_series(5));
  EXPECT_EQ(window.first_row, 200u);
  EXPECT_TRUE(window.steady);
}

TEST(AveragingWindow, IsTheSecondHalfOfARunThatEndedBefore) {
  const AveragingWindow window = averaging_window(case_with("average_from = 8\n"), settling_series(5));
  EXPECT_EQ(window.first_row, 250u);
  EXPECT_FALSE(window.steady);
}

TEST(AveragingWindow, IsDetectedOtherwise) {
  const Series series = settling_series(10);
  const AveragingWindow window = averaging_window(case_with(""), series);
  EXPECT_TRUE(window.steady);
  EXPECT_GT(window.first_row, 50u);
  EXPECT_LT(window.first_row, 500u);
  EXPECT_NEAR(mean_over(series, window, "relative_viscosity").mean, 4, 0.05);
}

}  // namespace
}  // namespace stresslet
