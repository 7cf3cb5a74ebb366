// Resistance functions against exact two-sphere solutions and the sum rules of their singular parts; the
// grand-resistance law against the full sums; wall films against exact sphere-wall solutions.
#include <gtest/gtest.h>

#include "../random_pairs.hpp"
#include "stresslet/lubrication/grand_resistance_reference.hpp"
#include "stresslet/lubrication/laws.hpp"
#include "stresslet/lubrication/wall.hpp"

namespace stresslet {
namespace {

using testing::Draw;
using Function = double (*)(const double&, const resistance::Singular<double>&);

// Exact two-body functions from multipole collocation, printed in two ways: exact - singular at xi = 1e-3, which has
// converged to a constant there, and 100 (singular - exact)/|exact| to 0.1 at xi = 0.1, 0.01, 0.001. Both must agree
// through our singular functions; a wrong coefficient of 1/xi or ln(1/xi) would shift one against the other.
struct Exact {
  const char* name;
  Function function;
  double percent[4][3];  // lambda = 1, 1.4, 2, 5; xi = 0.1, 0.01, 0.001
  double remainder_at_1e3[4];
};
const double lambdas[4] = {1, 1.4, 2, 5};
const Exact tables[] = {
    {"XA11",
     resistance::XA11<double>,
     {{-25.1, -3.7, -0.4}, {-21.5, -3.0, -0.3}, {-19.1, -2.6, -0.3}, {-18.6, -2.4, -0.2}},
     {0.9956, 0.9115, 0.8091, 0.5811}},
    {"XA12",
     resistance::XA12<double>,
     {{10.7, 1.3, 0.1}, {10.9, 1.4, 0.1}, {11.5, 1.4, 0.1}, {15.5, 1.9, 0.2}},
     {-0.3505, -0.3365, -0.2961, -0.1562}},
    {"YA11",
     resistance::YA11<double>,
     {{-72.5, -56.6, -46.4}, {-68.3, -51.5, -41.4}, {-63.0, -45.3, -35.5}, {-45.9, -27.2, -19.7}},
     {0.9984, 0.9638, 0.9012, 0.5947}},
    {"YA12",
     resistance::YA12<double>,
     {{41.8, 26.3, 19.2}, {41.1, 25.7, 18.7}, {38.8, 23.6, 17.1}, {27.9, 14.0, 9.5}},
     {-0.2737, -0.2614, -0.2247, -0.0848}},
    {"YB11",
     resistance::YB11<double>,
     {{-45.9, -25.0, -16.0}, {-64.8, -33.5, -20.9}, {-94.3, -45.6, -27.7}, {-266.3, -100.8, -54.6}},
     {0.2378, 0.3135, 0.3993, 0.6098}},
    {"YC11",
     resistance::YC11<double>,
     {{-62.7, -43.7, -33.8}, {-56.6, -36.6, -27.4}, {-50.1, -29.2, -20.9}, {-33.6, -9.8, -5.0}},
     {0.7044, 0.6073, 0.4871, 0.1223}},
    {"YC12",
     resistance::YC12<double>,
     {{13.2, 12.0, 8.5}, {16.4, 14.2, 9.9}, {27.5, 21.3, 14.4}, {110.4, 67.3, 40.6}},
     {-0.0270, -0.0294, -0.0344, -0.0308}},
    {"XG11",
     resistance::XG11<double>,
     {{9.3, 1.2, 0.1}, {12.4, 1.5, 0.2}, {14.6, 1.7, 0.2}, {6.4, 0.6, 0.1}},
     {-0.4676, -0.6660, -0.7761, -0.2160}},
    {"XG12",
     resistance::XG12<double>,
     {{-2.7, -0.5, -0.1}, {-5.6, -0.8, -0.1}, {-8.0, -1.1, -0.1}, {-1.5, -0.2, -0.0}},
     {0.1936, 0.2614, 0.2273, 0.0108}},
    {"YG11",
     resistance::YG11<double>,
     {{62.8, 31.1, 19.4}, {75.6, 36.3, 22.4}, {98.1, 45.0, 27.2}, {226.8, 86.4, 47.9}},
     {-0.1404, -0.2088, -0.3278, -0.9012}},
    {"YG12",
     resistance::YG12<double>,
     {{-36.1, -20.6, -13.4}, {-49.0, -26.6, -17.0}, {-68.9, -35.5, -22.1}, {-176.2, -76.4, -43.5}},
     {0.1018, 0.1151, 0.1235, 0.0938}},
    {"YH12",
     resistance::YH12<double>,
     {{5.6, 6.1, 4.4}, {15.9, 12.0, 8.2}, {32.9, 21.5, 14.2}, {123.2, 63.9, 37.9}},
     {-0.0290, -0.0558, -0.0848, -0.0880}},
};

TEST(ResistanceFunctions, SingularPartsHaveThePublishedDistanceFromTheExactFunctions) {
  for (const auto& row : tables)
    for (int l = 0; l < 4; ++l) {
      const auto relative_error = [&](double xi) {
        const double singular = row.function(lambdas[l], resistance::singular(xi));
        const double exact = singular + row.remainder_at_1e3[l];
        return 100 * (singular - exact) / std::abs(exact);
      };
      // Rounding of the remainder (5e-5) and of the percentage (0.05); at xi = 1e-2 the remainder itself moves by
      // O(xi ln xi).
      const double size = std::abs(row.function(lambdas[l], resistance::singular(1e-3)) + row.remainder_at_1e3[l]);
      EXPECT_NEAR(relative_error(1e-3), row.percent[l][2], 0.06 + 0.02 / size) << row.name << " " << lambdas[l];
      if (lambdas[l] > 2) continue;  // beyond, the O(xi ln xi) terms are as large as the remainder at xi = 1e-2
      EXPECT_NEAR(relative_error(1e-2), row.percent[l][1], 0.3 + 0.12 * std::abs(row.percent[l][1]))
          << row.name << " " << lambdas[l];
    }
}

TEST(ResistanceFunctions, MutualFunctionsAreSymmetricInTheSizeRatio) {
  const auto s = resistance::singular(1e-3);
  for (double lambda : {1.4, 2.0, 5.0, 10.0})
    for (Function f : {resistance::XA12<double>, resistance::YA12<double>, resistance::YC12<double>})
      EXPECT_NEAR(f(lambda, s), f(1 / lambda, s), 1e-13 * std::abs(f(lambda, s)));
}

// Exact functions of equal spheres, normalised by 6 pi a, 4 pi a^2, 8 pi a^3 (bispherical series; Jeffrey & Onishi
// 1984). The 12 functions in that normalisation are ours for lambda = 1. Remainder: the O(1) constants printed with the
// asymptotes; what is left is O(xi ln xi).
struct ExactRow {
  double xi, XA11, XA12, YA11, YA12, T1, T2, YC11, YC12;
};
const ExactRow exact_rows[] = {
    {0.01, 27.0340, -26.3883, 1.76696, -1.04144, 0.92098, 1.15677, 1.63506, 0.20555},
    {0.02, 14.3802, -13.7339, 1.65254, -0.92616, 0.75461, 0.98891, 1.50504, 0.17279},
    {0.05, 6.67966, -6.03163, 1.50312, -0.77418, 0.54319, 0.77305, 1.34306, 0.13126},
};

TEST(ResistanceFunctions, EqualSpheresApproachTheExactSolution) {
  for (const auto& row : exact_rows) {
    const auto s = resistance::singular(row.xi);
    const double next = 0.7 * row.xi * std::log(1 / row.xi);  // bound on the first neglected term
    EXPECT_NEAR(resistance::XA11(1.0, s) + 0.9954, row.XA11, next);
    EXPECT_NEAR(resistance::XA12(1.0, s) - 0.3502, row.XA12, next);
    EXPECT_NEAR(resistance::YA11(1.0, s) + 0.9983, row.YA11, next);
    EXPECT_NEAR(resistance::YA12(1.0, s) - 0.2737, row.YA12, next);
    EXPECT_NEAR(resistance::YB11(1.0, s) + 0.2390, -row.T1, next);
    EXPECT_NEAR(resistance::YB12(1.0, s) - 0.0017, row.T2, next);
    EXPECT_NEAR(resistance::YC11(1.0, s) + 0.7028, row.YC11, next);
    EXPECT_NEAR(resistance::YC12(1.0, s) - 0.0274, row.YC12, next);
  }
}

TEST(ResistanceFunctions, SingularSumRulesHoldForEverySizeRatio) {
  Draw draw(11);
  for (int trial = 0; trial < 1000; ++trial) {
    const double a1 = draw.log_uniform(0.1, 10), a2 = a1 * draw.log_uniform(0.1, 10), sum = a1 + a2;
    const DimensionalResistance f(a1, a2, draw.log_uniform(1e-5, 0.1) * 0.5 * sum);
    const auto equal = [](double x, double y) { EXPECT_NEAR(x, y, 1e-12 * (std::abs(x) + std::abs(y))); };
    equal(f.XA(0, 1), -f.XA(0, 0));
    equal(f.YA(0, 1), -f.YA(0, 0));
    equal(f.YB(0, 1), -f.YB(0, 0));
    equal(f.XG(0, 1), -f.XG(0, 0));
    equal(f.YG(0, 1), -f.YG(0, 0));
    equal(f.XG(0, 0) + f.XG(1, 0), sum * f.XA(0, 0));
    equal(2 * (f.YG(0, 0) + f.YG(1, 0)), sum * f.YA(0, 0));
    equal(f.YB(0, 0) + f.YB(1, 0), -sum * f.YA(0, 0));
    equal(f.YC(0, 0) + f.YC(0, 1), -sum * f.YB(0, 0));
    equal(2 * (f.YH(0, 0) + f.YH(1, 0)), -sum * f.YB(0, 0));
    equal(f.XA(0, 0), f.XA(1, 1));
    equal(f.YA(0, 0), f.YA(1, 1));
  }
}

TEST(GrandResistance, KernelFormEqualsTheSumsTermByTerm) {
  Draw draw(12);
  for (int trial = 0; trial < 5000; ++trial) {
    const double a1 = draw.log_uniform(0.2, 5), a2 = a1 * draw.log_uniform(0.1, 10);
    const double gap = draw.log_uniform(1e-4, 0.1) * 0.5 * (a1 + a2), distance = a1 + a2 + gap;
    const Vec3<double> e = draw.direction(), rotation = draw.vector(), x1 = draw.vector();
    const Vec3<double> U[2] = {draw.vector(), draw.vector()}, w[2] = {draw.vector(), draw.vector()};
    const SymTensor3<double> E = draw.strain_rate();
    const auto fluid = [&](const Vec3<double>& x) { return cross(rotation, x) + E * x; };
    const PairInFlow pair{
        e, {a1, a2}, gap, {fluid(x1) - U[0], fluid(x1 + distance * e) - U[1]}, {rotation - w[0], rotation - w[1]}, E};
    const GrandResistanceTerms one = grand_resistance_terms(pair, 0), two = grand_resistance_terms(pair, 1);

    PairMotion<double> motion{U[1] - U[0] - gap * (cross(rotation, e) + E * e), w[0], w[1]};
    const auto k = GrandResistance::resistance(a1, a2, gap);
    const auto kernel = pair_wrench(e, GrandResistance::arm(a1, a2, distance), k, motion);
    const double force = norm(one.force_normal) + norm(one.force_strain) + norm(one.force_tangential);
    EXPECT_LE(norm(kernel.force - one.force()), 1e-11 * force);
    EXPECT_LE(norm(kernel.force + two.force()), 1e-11 * force);
    EXPECT_LE(norm(kernel.half_sum - kernel.half_difference - one.total_torque()), 1e-11 * force * (a1 + a2));
    EXPECT_LE(norm(kernel.half_sum + kernel.half_difference - two.total_torque()), 1e-11 * force * (a1 + a2));
  }
}

// The simplified law drops terms of relative size xi: the normal forces differ by exactly X gap E_nn -> 6 pi abar^2
// E_nn, the tangential ones vanish as gap ln(gap).
TEST(GrandResistance, EqualsTheSimplifiedLawToTheStatedOrder) {
  Draw draw(13);
  for (double lambda : {1.0, 1.4, 2.0, 5.0}) {
    double previous_tangential = 0;
    for (double xi : {1e-2, 1e-3, 1e-4}) {
      const double a1 = 1, a2 = lambda, gap = 0.5 * xi * (a1 + a2), distance = a1 + a2 + gap;
      const Vec3<double> e{1, 0, 0};
      const SymTensor3<double> E{0.3, -0.1, -0.2, 0.5, -0.4, 0.25};
      const PairMotion<double> simple{{0.7, -0.2, 0.4}, {0.1, 0.6, -0.3}, {-0.5, 0.2, 0.8}};
      PairMotion<double> full = simple;
      full.u -= gap * (E * e);
      const auto k = Complete::resistance(a1, a2, gap);
      const auto s = pair_wrench(e, Complete::arm(a1, a2, distance), k, simple);
      const auto g = pair_wrench(e, GrandResistance::arm(a1, a2, distance), k, full);
      const double mean = a1 * a2 / (a1 + a2);
      const double difference = dot(s.force - g.force, e);
      EXPECT_NEAR(difference, 6 * pi * mean * mean * E.xx, 2 * xi * std::log(1 / xi) * 6 * pi * mean * mean * 6);
      const double tangential = norm(tangential_part(s.force - g.force, e));
      if (previous_tangential > 0) {
        EXPECT_LT(tangential, 0.2 * previous_tangential);
        EXPECT_GT(tangential, 0.1 * previous_tangential);
      }
      previous_tangential = tangential;
    }
  }
}

// Exact sphere-wall series: normal approach (Brenner 1961), translation and rotation (Goldman, Cox & Brenner 1967).
TEST(WallLubrication, ApproachesTheExactSolution) {
  struct Row {
    double height, normal;
  };
  for (const Row& row : {Row{1.001, 1002.353}, Row{1.005, 202.0330}, Row{1.01, 101.8962}}) {
    const double gap = row.height - 1;
    EXPECT_NEAR(wall_resistance(1.0, gap).X / (6 * pi) + 0.9713, row.normal, 0.1 * gap * std::log(1 / gap) + 0.002);
  }
  // Differences between two heights cancel the unknown constants of the logarithmic functions.
  const auto near = wall_resistance(1.0, 0.05), far = wall_resistance(1.0, 0.1);
  EXPECT_NEAR((near.Y - far.Y) / (6 * pi), 2.59896 - 2.26430, 0.05);
  EXPECT_NEAR((near.C - far.C) / (8 * pi), 1.66746 - 1.45485, 0.08);
  EXPECT_NEAR((near.B - far.B) / (8 * pi), 0.13793 - 0.08876, 0.03);
}

}  // namespace
}  // namespace stresslet
