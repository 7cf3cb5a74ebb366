/// Two-sphere resistance functions against published and recomputed tables: Jeffrey & Onishi, J. Fluid Mech. 139
/// (1984) 261; Stimson & Jeffery, Proc. R. Soc. A 111 (1926) 110; the bispherical series of the approach.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lubrication/resistance_functions.hpp"
#include "stresslet/lubrication/two_spheres_exact.hpp"

namespace stresslet {
namespace {

TEST(TwoSpheresExact, EqualSpheresAtTheTabulatedGaps) {
  struct Row {
    double gap, XA11, XA12, YA11, YA12, YB11, YB21, XC11, XC12, YC11, YC12;
  };
  const Row rows[] = {
      {0.01, 27.0340, -26.3883, 1.76696, -1.04144, -0.92098, -1.15677, 1.04678, -0.14419, 1.63506, 0.20555},
      {0.05, 6.67966, -6.03163, 1.50312, -0.77418, -0.54319, -0.77305, 1.03623, -0.12960, 1.34306, 0.13126},
      {0.20, 2.64105, -1.98449, 1.28804, -0.54675, -0.26187, -0.47073, 1.01876, -0.09830, 1.13981, 0.07426},
      {1.00, 1.36848, -0.67017, 1.09210, -0.29718, -0.05675, -0.18539, 1.00196, -0.03714, 1.01799, 0.02167},
      {4.00, 1.06744, -0.26272, 1.01711, -0.12957, -0.00552, -0.04240, 1.00002, -0.00463, 1.00068, 0.00239}};
  for (const Row& row : rows) {
    const TwoSphereResistance f = exact_two_spheres(1, 1, row.gap, 1e-7);
    EXPECT_NEAR(f.XA[0] / (6 * pi), row.XA11, row.XA11 > 10 ? 6e-5 : 1.2e-5) << row.gap;
    EXPECT_NEAR(f.XA[1] / (6 * pi), row.XA12, row.XA11 > 10 ? 6e-5 : 1.2e-5) << row.gap;
    EXPECT_NEAR(f.YA[0] / (6 * pi), row.YA11, 1.2e-5) << row.gap;
    EXPECT_NEAR(f.YA[1] / (6 * pi), row.YA12, 1.2e-5) << row.gap;
    EXPECT_NEAR(f.YB[0] / (4 * pi), row.YB11, 1.2e-5) << row.gap;
    EXPECT_NEAR(f.YB[2] / (4 * pi), row.YB21, 1.2e-5) << row.gap;
    EXPECT_NEAR(f.XC[0] / (8 * pi), row.XC11, 1.2e-5) << row.gap;
    EXPECT_NEAR(f.XC[1] / (8 * pi), row.XC12, 1.2e-5) << row.gap;
    EXPECT_NEAR(f.YC[0] / (8 * pi), row.YC11, 1.2e-5) << row.gap;
    EXPECT_NEAR(f.YC[1] / (8 * pi), row.YC12, 1.2e-5) << row.gap;
  }
}

/// Both along the line of centres at one speed, and towards each other.
TEST(TwoSpheresExact, AxisymmetricSeries) {
  const auto together = [](double gap) {
    const auto f = exact_two_spheres(1, 1, gap, 2e-7);
    return (f.XA[0] + f.XA[1]) / (6 * pi);
  };
  EXPECT_NEAR(together(0.01), 0.645722, 2e-6);
  EXPECT_NEAR(together(0.5), 0.672916, 1e-6);
  EXPECT_NEAR(together(2), 0.742258, 1e-6);
  const auto apart = [](double gap) {
    const auto f = exact_two_spheres(1, 1, gap, 2e-7);
    return (f.XA[0] - f.XA[1]) / (6 * pi);
  };
  EXPECT_NEAR(apart(0.005), 103.732, 6e-4);
  EXPECT_NEAR(apart(0.02), 28.1140, 6e-5);
  EXPECT_NEAR(apart(1), 2.03865, 6e-6);
}

/// What is left after the singular parts, at xi = 0.001 (independent series, four digits).
void near_contact(double l, const std::array<double, 9>& rest) {
  namespace near = resistance;
  const auto s = near::singular(1e-3);
  const double a2 = l, sum = 1 + l;
  const TwoSphereResistance f = exact_two_spheres(1, a2, 1e-3 * sum / 2, 2e-5);
  const double bound = 1.5e-4;
  EXPECT_NEAR(f.XA[0] / (6 * pi) - near::XA11(l, s), rest[0], 6e-3);  // 2e-5 of a function of some 300
  EXPECT_NEAR(f.YA[0] / (6 * pi) - near::YA11(l, s), rest[1], bound);
  EXPECT_NEAR(f.YA[1] / (3 * pi * sum) - near::YA12(l, s), rest[2], bound);
  EXPECT_NEAR(f.YB[0] / (4 * pi) - near::YB11(l, s), rest[3], bound);
  EXPECT_NEAR(f.YB[1] / (pi * sum * sum) - near::YB12(l, s), rest[4], bound);
  EXPECT_NEAR(f.YC[0] / (8 * pi) - near::YC11(l, s), rest[5], bound);
  EXPECT_NEAR(f.YC[1] / (pi * sum * sum * sum) - near::YC12(l, s), rest[6], bound);
  EXPECT_NEAR(f.XC[0] / (8 * pi), rest[7], bound);
  EXPECT_NEAR(f.XC[1] / (pi * sum * sum * sum), rest[8], bound);
}

/// In per cent of the exact functions, what the singular parts alone are off at xi = 0.01, lambda = 5 (one decimal).
TEST(TwoSpheresExact, UnequalSpheres) {
  namespace near = resistance;
  const auto s = near::singular(0.01);
  const TwoSphereResistance f = exact_two_spheres(1, 5, 0.03, 1e-4);
  const auto off = [](double singular, double exact) { return 100 * (singular - exact) / std::abs(exact); };
  EXPECT_NEAR(off(near::XA11(5.0, s), f.XA[0] / (6 * pi)), -2.4, 0.06);
  EXPECT_NEAR(off(near::XA12(5.0, s), f.XA[1] / (18 * pi)), 1.9, 0.06);
  EXPECT_NEAR(off(near::YA11(5.0, s), f.YA[0] / (6 * pi)), -27.2, 0.06);
  EXPECT_NEAR(off(near::YA12(5.0, s), f.YA[1] / (18 * pi)), 14.0, 0.06);
  EXPECT_NEAR(off(near::YB11(5.0, s), f.YB[0] / (4 * pi)), -100.8, 0.06);
  EXPECT_NEAR(off(near::YB12(5.0, s), f.YB[1] / (36 * pi)), 54.0, 0.06);
  EXPECT_NEAR(off(near::YC11(5.0, s), f.YC[0] / (8 * pi)), -9.8, 0.06);
  EXPECT_NEAR(off(near::YC12(5.0, s), f.YC[1] / (216 * pi)), 67.3, 0.06);
}

TEST(LongTwoSpheresExact, UnequalSpheresNearContact) {
  near_contact(1.4, {0.9115, 0.9638, -0.2614, 0.3135, -0.0432, 0.6073, -0.0294, 1.0705, -0.1373});
  near_contact(2, {0.8091, 0.9012, -0.2247, 0.3993, -0.0676, 0.4871, -0.0344, 1.0922, -0.1049});
  near_contact(0.5, {1.0883, 1.0194, -0.2247, 0.1194, 0.0828, 0.8497, -0.0344, 1.0205, -0.1049});
}

TEST(TwoSpheresExact, ReciprocalAndDissipative) {
  for (const double l : {0.1, 0.7, 1.0, 3.0, 10.0}) {
    const auto r = resistance_matrix(exact_two_spheres(1, l, 0.3), {0.6, 0, 0.8});
    EXPECT_LT((r - r.transpose()).norm(), 1e-10 * r.norm()) << l;
    EXPECT_GT((Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>>(r).eigenvalues()(0)), 0) << l;
  }
}

TEST(TwoSpheresExact, FarApartEachIsAlone) {
  const auto f = exact_two_spheres(1, 2, 1e4);
  EXPECT_NEAR(f.XA[0] / (6 * pi), 1, 1e-6);
  EXPECT_NEAR(f.YA[3] / (12 * pi), 1, 1e-6);
  EXPECT_NEAR(f.YC[3] / (64 * pi), 1, 1e-6);
  EXPECT_NEAR(f.XA[1] / (-18 * pi * pi / (pi * 1e4)), 1, 2e-3);  // -6 pi a1 a2 3/(2 R)
}

}  // namespace
}  // namespace stresslet
