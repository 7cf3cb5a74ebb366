// Every law in SolidWeights: limits, monotony, weight and drag of one cell, packs; and cells that particles share.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../random_pairs.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/shared_cells.hpp"

namespace stresslet {
namespace {

using testing::Draw;

template <class List>
struct GTestTypes;
template <class... Laws>
struct GTestTypes<TypeList<Laws...>> {
  using type = ::testing::Types<Laws...>;
};

template <class Law>
class SolidWeight : public ::testing::Test {};
TYPED_TEST_SUITE(SolidWeight, GTestTypes<SolidWeights>::type);

TYPED_TEST(SolidWeight, GrowsFromNothingWithinItsBound) {
  for (const double tau : {0.501, 0.55, 0.7, 1.0, 2.0, 10.0}) {
    const TypeParam law(tau);
    EXPECT_EQ(law.weight(0.0), 0);
    EXPECT_EQ(law.drag(0.0), 0);
    double last = 0;
    for (int percent = 1; percent <= 100; ++percent) {
      const double weight = law.weight(percent / 100.0);
      EXPECT_GT(weight, last) << tau << ' ' << percent;
      EXPECT_LE(weight, TypeParam::largest);
      last = weight;
    }
  }
}

/// B rho (us - u*) = alpha rho (us - u) with u = u* + F/(2 rho).
TYPED_TEST(SolidWeight, IsOneForceAsWeightAndAsDrag) {
  for (const double tau : {0.51, 0.8, 2.0})
    for (int percent = 5; percent <= 100; percent += 5) {
      const TypeParam law(tau);
      const double fraction = percent / 100.0;
      const double us = 0.03, u_before = -0.01, force = law.weight(fraction) * (us - u_before);
      const double drag = law.drag(fraction), round_off = 1e-17 * (1 + drag);
      EXPECT_NEAR(drag * (us - (u_before + 0.5 * force)), force, round_off);
      EXPECT_NEAR(weight_from_drag(drag), law.weight(fraction), 1e-15);
    }
}

/// The grid shifts what the flow feels by a fraction of a cell, whatever the size.
TYPED_TEST(SolidWeight, DrawsASphereOfAboutItsSize) {
  double last = 0;
  for (const double radius : {1.0, 2.0, 3.125, 5.0, 10.0, 100.0}) {
    const double drawn = TypeParam::drawn_radius(radius);
    EXPECT_NEAR(drawn, radius, 0.5);
    EXPECT_GT(drawn, last);
    last = drawn;
  }
}

TYPED_TEST(SolidWeight, GivesThePackWhatItGivesTheCell) {
  const TypeParam law(0.7);
  const Pack fraction([](auto k) { return double(k) / (pack_width - 1); });
  const Pack weight = law.weight(fraction), drag = law.drag(fraction);
  for (std::size_t k = 0; k < pack_width; ++k) {
    EXPECT_NEAR(weight[k], law.weight(double(fraction[k])), 4e-16);
    EXPECT_NEAR(drag[k], law.drag(double(fraction[k])), 4e-15);
  }
}

TEST(SolidWeights, HaveTheirClosedForms) {
  EXPECT_EQ(LinearWeight(0.7).weight(0.37), 0.37);
  // eps lambda / ((1 - eps) + lambda): half the fraction at eps = 1 - lambda, lambda = 1/5; full where the cell is.
  EXPECT_NEAR(NobleTorczynskiWeight(0.7).weight(0.8), 0.4, 1e-15);
  EXPECT_EQ(NobleTorczynskiWeight(0.6).weight(1.0), 1);
  EXPECT_NEAR(NobleTorczynskiWeight(1e9).weight(0.25), 0.25, 1e-9);
  // alpha = 1/5 * 0.5 / 0.53 = 0.1 / 0.53, B = 0.1 / 0.58; at eps = 1 they are 0.2 / 0.03 and 0.2 / 0.13.
  EXPECT_NEAR(ViscosityScaledWeight(0.7).drag(0.5), 0.188679245283019, 1e-14);
  EXPECT_NEAR(ViscosityScaledWeight(0.7).weight(0.5), 0.172413793103448, 1e-14);
  EXPECT_NEAR(ViscosityScaledWeight(0.7).weight(1.0), 1.538461538461538, 1e-13);
}

TEST(SolidWeights, ScaleTheDragWithTheViscosity) {
  for (const double fraction : {0.1, 0.5, 0.9, 1.0})
    EXPECT_NEAR(ViscosityScaledWeight(2.0).drag(fraction), 7.5 * ViscosityScaledWeight(0.7).drag(fraction), 1e-12);
}

/// Some solids in one cell, and the cell's own mean velocity u from its implicit definition.
struct Shared {
  static constexpr int most = 4;
  int solids = 0;
  std::array<double, most> drag{};
  std::array<Vec3<double>, most> velocity{};
  double density = 1;
  Vec3<double> before;  ///< u*

  SharedDrag<double> sum() const {
    SharedDrag<double> all;
    for (int k = 0; k < solids; ++k) all.add(drag[k], velocity[k]);
    return all;
  }
  Vec3<double> friction(int k) const {
    Vec3<double> f{};
    for (int j = 0; j < solids; ++j)
      f += shared_cell_friction(density, drag[k], share_of_weight(drag[j], sum().drag)) * (velocity[k] - velocity[j]);
    return f;
  }
  Vec3<double> given_by(int k) const {
    return (share_of_weight(drag[k], sum().drag) * density) * (velocity[k] - before) + friction(k);
  }
};
Shared draw_shared(Draw& draw, int solids) {
  Shared s;
  s.solids = solids, s.density = draw.uniform(0.9, 1.1), s.before = draw.vector();
  for (int k = 0; k < solids; ++k) s.drag[k] = draw.log_uniform(1e-3, 100), s.velocity[k] = draw.vector();
  return s;
}

TEST(SharedCells, SolveTheImplicitBalance) {
  Draw draw(1);
  for (int n = 0; n < 300; ++n) {
    const Shared s = draw_shared(draw, 1 + n % Shared::most);
    // F_k = alpha_k rho (us_k - u), u = u* + sum F/(2 rho)
    Vec3<double> total{};
    for (int k = 0; k < s.solids; ++k) total += s.given_by(k);
    const Vec3<double> u = s.before + (0.5 / s.density) * total;
    // The frictions cancel in u only to the round-off of terms up to the sum of all drags.
    for (int k = 0; k < s.solids; ++k)
      EXPECT_LT(norm(s.given_by(k) - (s.drag[k] * s.density) * (s.velocity[k] - u)),
                1e-15 * (1 + s.drag[k]) * (1 + s.sum().drag));
  }
}

TEST(SharedCells, LetTheFluidSeeOneSolid) {
  Draw draw(2);
  for (int n = 0; n < 300; ++n) {
    const Shared s = draw_shared(draw, 1 + n % Shared::most);
    const CoveredCell<double> seen = covered_cell(s.sum());
    Vec3<double> total{};
    double weights = 0;
    for (int k = 0; k < s.solids; ++k) {
      total += s.given_by(k);
      weights += share_of_weight(s.drag[k], s.sum().drag);
    }
    EXPECT_NEAR(weights, seen.weight, 1e-15 * 4);
    EXPECT_LT(seen.weight, 2);
    EXPECT_LT(norm(total - (seen.weight * s.density) * (seen.velocity - s.before)), 2e-14);
  }
}

TEST(SharedCells, OfOneSolidAreThatSolid) {
  Draw draw(3);
  const Shared s = draw_shared(draw, 1);
  const CoveredCell<double> seen = covered_cell(s.sum());
  EXPECT_EQ(seen.weight, weight_from_drag(s.drag[0]));
  EXPECT_LT(norm(seen.velocity - s.velocity[0]), 1e-15 * 4);
  EXPECT_EQ(norm(s.friction(0)), 0);
}

TEST(SharedCells, RubWithoutDriving) {
  Draw draw(4);
  for (int n = 0; n < 300; ++n) {
    const Shared s = draw_shared(draw, 2 + n % 3);
    Vec3<double> sum{};
    double power = 0;  // on the solids, whose force is the opposite of `friction`
    for (int k = 0; k < s.solids; ++k) {
      sum += s.friction(k);
      power -= dot(s.friction(k), s.velocity[k]);
    }
    EXPECT_LT(norm(sum), 1e-13);
    EXPECT_LT(power, 0);
  }
}

TEST(SharedCells, WithoutSolidAreFluid) {
  const CoveredCell<double> seen = covered_cell(SharedDrag<double>{});
  EXPECT_EQ(seen.weight, 0);
  EXPECT_EQ(seen.velocity, Vec3<double>{});
}

TEST(SharedCells, GiveThePackWhatTheyGiveTheCell) {
  Draw draw(5);
  const Shared s = draw_shared(draw, 3);
  SharedDrag<Pack> sum;
  const Pack lane([](auto k) { return double(k); });  // lane 0 is fluid
  const auto in_pack = [](const Vec3<double>& v) { return Vec3<Pack>{Pack(v.x), Pack(v.y), Pack(v.z)}; };
  for (int k = 0; k < s.solids; ++k) sum.add(lane * s.drag[k], in_pack(s.velocity[k]));
  const CoveredCell<Pack> seen = covered_cell(sum);
  for (std::size_t l = 0; l < pack_width; ++l) {
    SharedDrag<double> alone;
    for (int k = 0; k < s.solids; ++k) alone.add(double(l) * s.drag[k], s.velocity[k]);
    const CoveredCell<double> cell = covered_cell(alone);
    EXPECT_NEAR(seen.weight[l], cell.weight, 1e-15);
    EXPECT_LT(norm(Vec3<double>{seen.velocity.x[l], seen.velocity.y[l], seen.velocity.z[l]} - cell.velocity), 4e-15);
  }
}

TEST(SharedCells, ThesisRuleFillsTheCellOnlyWhereItOverflows) {
  EXPECT_EQ(thesis_weight_scale(1.0, 0.7), 1);
  EXPECT_EQ(thesis_weight_scale(0.8, 0.8), 1);
  EXPECT_NEAR(thesis_weight_scale(1.25, 0.8) * 0.8, 1, 1e-15);
}

TEST(RigidVelocity, ChangesAlongARowByTheSameStep) {
  const Vec3<double> u{0.1, -0.2, 0.3}, w{0.5, 0.25, -0.125}, arm{2, -1, 4};
  EXPECT_EQ(rigid_velocity(u, w, arm),
            (Vec3<double>{0.1 + (0.25 * 4 - 0.125), -0.2 + (-0.125 * 2 - 0.5 * 4), 0.3 + (-0.5 - 0.25 * 2)}));
  const Vec3<double> step = rigid_velocity(u, w, {3, -1, 4}) - rigid_velocity(u, w, arm);
  EXPECT_LT(norm(step - Vec3<double>{0, w.z, -w.y}), 1e-15);
}

}  // namespace
}  // namespace stresslet
