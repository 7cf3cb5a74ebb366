/// Two resolved spheres with the calibrated sub-grid correction against the exact resistance of the pair, any
/// direction and place on the grid, both signs of the error bounded.
#include <gtest/gtest.h>

#include "../input/complaint_of.hpp"
#include "stresslet/coupling/calibration/calibrate.hpp"
#include "stresslet/coupling/subgrid/calibrated_lengths.hpp"

namespace stresslet {
namespace {

const SubgridCorrection& correction() {
  static const SubgridCorrection c = calibrated_correction("superposition", "viscosity-scaled", "TRT", 1);
  return c;
}

PairMeasurement measured(double relaxation_time, const PairPlacement& placement, std::vector<PairMotionKind> kinds) {
  PairScheme scheme;
  scheme.relaxation_time = relaxation_time;
  ThreadTeam team(1);
  return measure_pair(scheme, placement, kinds, team);
}

std::array<double, 4> errors(const PairMeasurement& m) {
  return corrected_errors(m, correction().law, correction().lengths, correction().range);
}

constexpr auto squeeze = PairMotionKind::squeeze, slide = PairMotionKind::slide, roll = PairMotionKind::roll,
               spin = PairMotionKind::spin;

/// In a small box; without correction more than half of the force is missing.
TEST(PairResistance, SpaceDiagonal) {
  const PairMeasurement m = measured(2, {5, 5, 0.2, {1, 1, 1}, {1, -1, 0}, {0.2, 0.3, 0.4}, 32}, {squeeze});
  EXPECT_NEAR(errors(m)[0], 0, 0.05);
  EXPECT_NEAR(corrected_errors(m, correction().law, {}, {})[0], -0.55, 0.05);
}

TEST(LongPairResistance, WithinFivePerCent) {
  const PairPlacement placements[] = {{5, 5, 0.05, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0.5}, 50},
                                      {5, 5, 0.5, {1, 1, 0}, {-1, 1, 0}, {0.25, 0.1, 0.3}, 50},
                                      {5, 5, 1, {0.3, -0.9, 0.5}, {1, 0, 0}, {0.1, 0.4, 0.2}, 50}};
  for (const PairPlacement& placement : placements) {
    const auto e = errors(measured(2, placement, {squeeze, slide, roll, spin}));
    EXPECT_NEAR(e[0], 0, 0.05) << placement.gap;
    EXPECT_NEAR(e[1], 0, 0.05) << placement.gap;
    EXPECT_NEAR(e[2], 0, 0.05) << placement.gap;
    EXPECT_NEAR(e[3], 0, 0.03) << placement.gap;
  }
}

TEST(LongPairResistance, DoesNotDependOnTheRelaxationTime) {
  const PairPlacement placement{5, 5, 0.2, {1, 1, 1}, {1, -1, 0}, {0.2, 0.3, 0.4}, 32};
  const double reference = errors(measured(2, placement, {squeeze}))[0];
  for (const double tau : {0.6, 1.0}) EXPECT_NEAR(errors(measured(tau, placement, {squeeze}))[0], reference, 0.003);
}

/// What is taken off for the images falls as L^-3 and is 2 to 5 per cent here; what is left falls as L^-5.
TEST(LongPairResistance, DoesNotDependOnTheBox) {
  PairPlacement placement{5, 5, 1, {1, 0, 0}, {0, 1, 0}, {}, 40};
  const PairMeasurement small = measured(2, placement, {squeeze});
  placement.edge = 50;
  const PairMeasurement large = measured(2, placement, {squeeze});
  EXPECT_NEAR(small.measured(0, 0) / large.measured(0, 0), 1, 0.01);
  EXPECT_NEAR(small.images(0, 0) / large.images(0, 0), 1.95, 0.3);
}

TEST(CalibratedCorrection, RefusesASchemeWithoutARow) {
  const std::string complaint = complaint_of([] { calibrated_correction("bounce-back", "linear", "BGK", 0.7); });
  EXPECT_NE(complaint.find("bounce-back"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("stresslet calibrate --law soft-cut-off --operator bounce-back --weight linear "
                           "--collision BGK --tau 0.7"),
            std::string::npos)
      << complaint;
}

}  // namespace
}  // namespace stresslet
