// Every law in SubgridLaws: limits in the gap, continuity, balance, rigid motion, exchange, dissipation, size ratios.
#include <gtest/gtest.h>

#include "../random_pairs.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/subgrid/subgrid_links.hpp"

namespace stresslet {
namespace {

using testing::Draw;

constexpr SubgridLengths lengths{0.6, 0.15, 0.25};
constexpr double viscosity = 0.1;

template <class List>
struct GTestTypes;
template <class... Laws>
struct GTestTypes<TypeList<Laws...>> {
  using type = ::testing::Types<Laws...>;
};
template <class Law>
class SubgridLaw : public ::testing::Test {
 protected:
  static PairResistance<double> at(double a1, double a2, double gap, const SubgridRange& range = {}) {
    return subgrid_resistance<Law>(a1, a2, gap, lengths, range);
  }
  static PairResistance<double> wall_at(double a, double gap, const SubgridRange& range = {}) {
    return subgrid_wall_resistance<Law>(a, gap, lengths, range);
  }
  /// Two spheres, the second with an image elsewhere, in any motion.
  static std::vector<ResolvedSphere> draw_pair(Draw& draw, double& gap, ImageShift& image) {
    const double a1 = 10 * draw.log_uniform(0.3, 3), a2 = a1 * draw.log_uniform(0.1, 10);
    gap = draw.log_uniform(1e-3, 2.9);
    image = {20.0 * draw.vector(), draw.vector()};
    std::vector<ResolvedSphere> s(2);
    s[0] = {10.0 * draw.vector(), a1, draw.vector(), draw.vector()};
    s[1] = {s[0].centre + (a1 + a2 + gap) * draw.direction() - image.displacement, a2, draw.vector(), draw.vector()};
    return s;
  }
  static SphereLink link(const std::vector<ResolvedSphere>& s, const ImageShift& image) {
    return *subgrid_link(s, 0, 1, image, viscosity, {std::string(Law::name), lengths, {}, {}});
  }
};
TYPED_TEST_SUITE(SubgridLaw, GTestTypes<SubgridLaws>::type);

Vector12 velocities(const Vec3<double>& u1, const Vec3<double>& w1, const Vec3<double>& u2, const Vec3<double>& w2) {
  Vector12 v;
  v << u1.x, u1.y, u1.z, w1.x, w1.y, w1.z, u2.x, u2.y, u2.z, w2.x, w2.y, w2.z;
  return v;
}
Vec3<double> part(const Vector12& v, int i) { return {v(3 * i), v(3 * i + 1), v(3 * i + 2)}; }

TYPED_TEST(SubgridLaw, ResolvesNoFilmThinnerThanItIs) {
  Draw draw(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const double gap = draw.log_uniform(1e-4, 10), length = draw.log_uniform(1e-2, 2);
    EXPECT_GE(TypeParam::resolved_gap(gap, length), gap);
    EXPECT_GE(TypeParam::resolved_gap(gap, length), length);
    EXPECT_LE(TypeParam::resolved_gap(gap, length), gap + length);
    EXPECT_EQ(TypeParam::resolved_gap(gap, 0.0), gap);
  }
}

/// The difference to the whole film stays bounded while both grow without bound.
TYPED_TEST(SubgridLaw, IsTheWholeFilmAtContact) {
  SubgridRange range;
  range.inner = 0;
  for (const double ratio : {0.1, 0.5, 1.0, 1.4, 10.0}) {
    const double a1 = 5, a2 = ratio * a1;
    const auto whole = [&](double h) { return Complete::resistance(a1, a2, h); };
    for (const double h : {1e-6, 1e-8}) {
      const auto k = this->at(a1, a2, h, range);
      EXPECT_NEAR(k.X / whole(h).X, 1, 10 * h);
    }
    const auto near = this->at(a1, a2, 1e-8, range), nearer = this->at(a1, a2, 1e-10, range);
    EXPECT_NEAR(nearer.Y - near.Y, whole(1e-10).Y - whole(1e-8).Y, 1e-9 * near.Y);
    EXPECT_NEAR(nearer.C - near.C, whole(1e-10).C - whole(1e-8).C, 1e-9 * near.C);
    // Of the mean sqrt(D_s D_r) the difference falls as (ln(l_r/l_s))^2/(8 L).
    EXPECT_NEAR(nearer.B - near.B, whole(1e-10).B - whole(1e-8).B, 1e-3 * std::abs(near.B) + 1e-12);
  }
}

TYPED_TEST(SubgridLaw, IsContinuousNeverNegativeAndEndsAtZero) {
  const SubgridRange range;
  for (const double ratio : {0.1, 1.0, 1.4, 10.0}) {
    const double a1 = 5, a2 = ratio * a1, inner = range.inner * effective_diameter(a1, a2);
    auto before = this->at(a1, a2, inner);
    for (double h = inner * 1.0005; h < 3.1; h *= 1.0005) {
      const auto k = this->at(a1, a2, h);
      const double step = 1.5e-3;  // 3 times that of the gap
      EXPECT_GE(k.X, 0);
      EXPECT_GE(k.Y, 0);
      EXPECT_GE(k.C, 0);
      EXPECT_GE(k.Y * k.C, k.B * k.B);
      EXPECT_LE(k.X, before.X);
      EXPECT_NEAR(k.X, before.X, step * Complete::resistance(a1, a2, h).X + 1e-9);
      EXPECT_NEAR(k.Y, before.Y, step * this->at(a1, a2, inner).Y);
      EXPECT_NEAR(k.C, before.C, step * this->at(a1, a2, inner).C);
      before = k;
    }
    EXPECT_EQ(before.X, 0);
    EXPECT_EQ(before.Y, 0);
    EXPECT_EQ(before.C, 0);
    for (const double h : {0.0, 0.5 * inner, -1.0}) {
      EXPECT_EQ(this->at(a1, a2, h).X, this->at(a1, a2, inner).X);
      EXPECT_EQ(this->at(a1, a2, h).C, this->at(a1, a2, inner).C);
    }
  }
}

TYPED_TEST(SubgridLaw, BalancesIsSymmetricAndOnlyDissipates) {
  Draw draw(2);
  for (int trial = 0; trial < 1000; ++trial) {
    double gap;
    ImageShift image;
    const auto s = this->draw_pair(draw, gap, image);
    const SphereLink link = this->link(s, image);
    const Matrix12& r = link.resistance;
    const double size = r.norm() * 1e-12;
    EXPECT_LE((r - r.transpose()).norm(), size);
    EXPECT_GE((Eigen::SelfAdjointEigenSolver<Matrix12>(r, Eigen::EigenvaluesOnly).eigenvalues()(0)), -size);
    const Vec3<double> arm = s[1].centre + image.displacement - s[0].centre;
    const Vector12 f = -r * velocities(draw.vector(), draw.vector(), draw.vector(), draw.vector());
    EXPECT_LE(norm(part(f, 0) + part(f, 2)), 100 * size);
    EXPECT_LE(norm(part(f, 1) + part(f, 3) + cross(arm, part(f, 2))), 1e4 * size);
    const Vec3<double> u = draw.vector(), w = draw.vector();
    EXPECT_LE((r * velocities(u, w, u + cross(w, arm), w)).norm(), 1e4 * size);
  }
}

TYPED_TEST(SubgridLaw, DoesNotCareWhichSphereIsFirst) {
  Draw draw(3);
  for (int trial = 0; trial < 1000; ++trial) {
    double gap;
    ImageShift image;
    const auto s = this->draw_pair(draw, gap, image);
    const SphereLink there = this->link(s, image);
    const std::vector<ResolvedSphere> other{s[1], s[0]};
    const SphereLink back = this->link(other, {-image.displacement, -image.velocity});
    const double size = there.resistance.norm() * 1e-11;
    EXPECT_LE((there.resistance.topLeftCorner<6, 6>() - back.resistance.bottomRightCorner<6, 6>()).norm(), size);
    EXPECT_LE((there.resistance.topRightCorner<6, 6>() - back.resistance.bottomLeftCorner<6, 6>()).norm(), size);
    const Vec3<double> one = link_force(there, s), two = link_force(back, other);
    EXPECT_LE(norm(one + two), 1e3 * size);
  }
}

/// The matrix is the wrench of pair_law.hpp; the first moment is tension positive: spheres that part are held together.
TYPED_TEST(SubgridLaw, MatrixGivesTheWrenchOfThePairLaw) {
  Draw draw(4);
  for (int trial = 0; trial < 1000; ++trial) {
    double gap;
    ImageShift image;
    const auto s = this->draw_pair(draw, gap, image);
    const SphereLink link = this->link(s, image);
    const Vec3<double> arm = s[1].centre + image.displacement - s[0].centre;
    const double distance = norm(arm);
    const PairMotion<double> motion{s[1].velocity + image.velocity - s[0].velocity, s[0].angular_velocity,
                                    s[1].angular_velocity};
    const auto k = this->at(s[0].radius, s[1].radius, distance - s[0].radius - s[1].radius);
    const auto w = pair_wrench(arm / distance, distance, k, motion);
    const Vector12 f = -link.resistance * velocities(s[0].velocity, s[0].angular_velocity,
                                                     s[1].velocity + image.velocity, s[1].angular_velocity);
    const double size = 1e-10 * link.resistance.norm();
    EXPECT_LE(norm(part(f, 0) - viscosity * w.force), size);
    EXPECT_LE(norm(part(f, 1) - viscosity * (w.half_sum - w.half_difference)), size);
    EXPECT_LE(norm(part(f, 3) - viscosity * (w.half_sum + w.half_difference)), size);
    EXPECT_LE(norm(link_force(link, s) - part(f, 0)), size);
    const double parting = dot(motion.u, arm);
    EXPECT_NEAR(trace(link_stresslet(part(f, 0), arm)), viscosity * k.X * parting, distance * size);
  }
}

/// The wall is a sphere without bound; the logarithms then count from the sphere's own gap, as both laws do.
TYPED_TEST(SubgridLaw, WallIsTheLimitOfALargeSphere) {
  for (const double gap : {0.02, 0.1, 0.4, 0.55}) {
    const double a = 5, b = 1e6 * a;
    const auto wall = this->wall_at(a, gap);
    const auto pair = this->at(a, b, gap);
    // The logarithm of X has the factor of the wall in both, so the difference is that of 1/xi alone.
    EXPECT_NEAR(pair.X, wall.X, 2e-5 * wall.X);
    EXPECT_NEAR(pair.Y, wall.Y, 2e-5 * wall.Y);
    EXPECT_GT(wall.X, 0);
  }
  const auto beyond = this->wall_at(5, 3.0);
  EXPECT_EQ(beyond.X, 0);
  EXPECT_EQ(beyond.Y, 0);
  EXPECT_EQ(this->wall_at(5, -1).X, this->wall_at(5, 0).X);
}

TYPED_TEST(SubgridLaw, WallOnlyDissipates) {
  Draw draw(5);
  for (int trial = 0; trial < 300; ++trial) {
    const double a = 10 * draw.log_uniform(0.3, 3), gap = draw.log_uniform(1e-3, 2.9);
    const Vec3<double> e = draw.direction(), u = draw.vector(), w = draw.vector();
    const auto r =
        subgrid_wall_resistance_matrix(a, e, gap, viscosity, {std::string(TypeParam::name), lengths, {}, {}});
    ASSERT_TRUE(r);
    EXPECT_LE((*r - r->transpose()).norm(), 1e-12 * r->norm());
    EXPECT_GE((Eigen::SelfAdjointEigenSolver<Matrix6>(*r, Eigen::EigenvaluesOnly).eigenvalues()(0)),
              -1e-12 * r->norm());
    Vector6 v;
    v << u.x, u.y, u.z, w.x, w.y, w.z;
    const Vector6 f = -*r * v;
    const auto expected = wall_wrench(e, this->wall_at(a, gap), -u, w);
    EXPECT_LE(norm(Vec3<double>{f(0), f(1), f(2)} - viscosity * expected.force), 1e-12 * r->norm());
    EXPECT_LE(norm(Vec3<double>{f(3), f(4), f(5)} - viscosity * expected.torque), 1e-12 * r->norm());
  }
}

/// Closed form of equal spheres: X = (3 pi/2) a^2 (1/h - 1/l) + (27 pi/20) a ln(l/h) for h < l.
TEST(HardCutOff, EqualSpheresHaveTheirClosedForm) {
  const double a = 5, h = 0.2, l = 0.75;
  const auto k = subgrid_resistance<HardCutOff>(a, a, h, {l, 0.5, 0.3}, {});
  EXPECT_NEAR(k.X, 1.5 * pi * a * a * (1 / h - 1 / l) + 1.35 * pi * a * std::log(l / h), 1e-10);
  EXPECT_NEAR(k.Y, pi * a * std::log(0.5 / h), 1e-10);
  EXPECT_NEAR(k.C, 2.4 * pi * a * a * a * std::log(0.3 / h), 1e-9);
  EXPECT_EQ(k.B, 0);
}

}  // namespace
}  // namespace stresslet
