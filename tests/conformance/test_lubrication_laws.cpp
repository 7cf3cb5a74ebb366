// Every law in LubricationLaws: balance, exchange symmetry, invariance under rigid motion, dissipation, range.
#include <gtest/gtest.h>

#include "../random_pairs.hpp"
#include "stresslet/lubrication/laws.hpp"
#include "stresslet/lubrication/wall.hpp"

namespace stresslet {
namespace {

using testing::Draw;
using testing::rotate;

template <class List>
struct GTestTypes;
template <class... Laws>
struct GTestTypes<TypeList<Laws...>> {
  using type = ::testing::Types<Laws...>;
};

struct Pair {
  double a1, a2, gap;
  Vec3<double> e;
  PairMotion<double> motion;
  double distance() const { return a1 + a2 + gap; }
};

Pair draw_pair(Draw& draw) {
  Pair p;
  p.a1 = draw.log_uniform(0.1, 10);
  p.a2 = p.a1 * draw.log_uniform(0.1, 10);
  p.gap = draw.log_uniform(1e-4, 0.1) * 0.5 * (p.a1 + p.a2);
  p.e = draw.direction();
  p.motion = {draw.vector(), draw.vector(), draw.vector()};
  return p;
}

template <class Law>
PairWrench<double> wrench(const Pair& p) {
  return pair_wrench(p.e, Law::arm(p.a1, p.a2, p.distance()), Law::resistance(p.a1, p.a2, p.gap), p.motion);
}

struct OnEach {
  Vec3<double> force1, torque1, torque2;
};
OnEach split(const PairWrench<double>& w) {
  return {w.force, w.half_sum - w.half_difference, w.half_sum + w.half_difference};
}

/// Size of the terms that add up to a wrench (as a torque): what 1e-12 is relative to. The force itself would not do,
/// for it vanishes in motions that a law does not resist.
template <class Law>
double scale(const Pair& p) {
  const auto k = Law::resistance(p.a1, p.a2, p.gap);
  const double d = p.distance(), spin = norm(p.motion.w1) + norm(p.motion.w2), speed = norm(p.motion.u) + d * spin;
  return ((k.X + k.Y) * d + std::abs(k.B)) * speed + (std::abs(k.B) * d + k.C) * spin + 1e-300;
}

template <class Law>
class LubricationLaw : public ::testing::Test {};
TYPED_TEST_SUITE(LubricationLaw, GTestTypes<LubricationLaws>::type);

TYPED_TEST(LubricationLaw, TorquesBalanceTheMomentOfTheForceAboutTheLawsArm) {
  Draw draw(1);
  for (int trial = 0; trial < 10000; ++trial) {
    const Pair p = draw_pair(draw);
    const auto w = wrench<TypeParam>(p);
    const auto [force1, torque1, torque2] = split(w);
    const Vec3<double> excess = torque1 + torque2 - TypeParam::arm(p.a1, p.a2, p.distance()) * cross(p.e, force1);
    ASSERT_LE(norm(excess), 1e-12 * scale<TypeParam>(p));
  }
}

TYPED_TEST(LubricationLaw, ExchangeOfTheSpheresGivesTheSameForces) {
  Draw draw(2);
  for (int trial = 0; trial < 10000; ++trial) {
    const Pair p = draw_pair(draw);
    Pair swapped = p;
    std::swap(swapped.a1, swapped.a2);
    swapped.e = -p.e;
    swapped.motion = {-p.motion.u, p.motion.w2, p.motion.w1};
    const auto w = wrench<TypeParam>(p);
    const OnEach original = split(w), exchanged = split(wrench<TypeParam>(swapped));
    ASSERT_LE(norm(original.force1 + exchanged.force1) * p.distance(), 1e-12 * scale<TypeParam>(p));
    ASSERT_LE(norm(original.torque1 - exchanged.torque2), 1e-12 * scale<TypeParam>(p));
    ASSERT_LE(norm(original.torque2 - exchanged.torque1), 1e-12 * scale<TypeParam>(p));
  }
}

TYPED_TEST(LubricationLaw, RotatedFrameRotatesForcesAndTorques) {
  Draw draw(3);
  for (int trial = 0; trial < 10000; ++trial) {
    const Pair p = draw_pair(draw);
    const Vec3<double> axis = draw.vector();
    Pair turned = p;
    turned.e = rotate(axis, p.e);
    turned.motion = {rotate(axis, p.motion.u), rotate(axis, p.motion.w1), rotate(axis, p.motion.w2)};
    const auto w = wrench<TypeParam>(p), t = wrench<TypeParam>(turned);
    ASSERT_LE(norm(rotate(axis, w.force) - t.force) * p.distance(), 1e-12 * scale<TypeParam>(p));
    ASSERT_LE(norm(rotate(axis, w.half_sum) - t.half_sum), 1e-12 * scale<TypeParam>(p));
    ASSERT_LE(norm(rotate(axis, w.half_difference) - t.half_difference), 1e-12 * scale<TypeParam>(p));
  }
}

// A pair that turns and translates as one body. The grand-resistance law measures velocities against the fluid and uses
// the arm a1 + a2; it feels nothing when the fluid turns with the pair.
TYPED_TEST(LubricationLaw, RigidMotionFeelsNothing) {
  Draw draw(4);
  for (int trial = 0; trial < 10000; ++trial) {
    Pair p = draw_pair(draw);
    const Vec3<double> rotation = draw.vector();
    p.motion = {p.distance() * cross(rotation, p.e), rotation, rotation};
    if (TypeParam::sees_background) p.motion.u -= p.gap * cross(rotation, p.e);
    const auto k = TypeParam::resistance(p.a1, p.a2, p.gap);
    const double stiff = (k.X + k.Y) * p.distance() * norm(rotation) * p.distance() + 1e-300;
    const auto w = wrench<TypeParam>(p);
    ASSERT_LE(norm(w.force) * p.distance() + norm(w.half_sum) + norm(w.half_difference), 1e-12 * stiff);
  }
}

TYPED_TEST(LubricationLaw, NeverProducesEnergy) {
  Draw draw(5);
  for (int trial = 0; trial < 10000; ++trial) {
    const Pair p = draw_pair(draw);
    const auto w = wrench<TypeParam>(p);
    const auto [force1, torque1, torque2] = split(w);
    const double loss = dot(force1, p.motion.u) - dot(torque1, p.motion.w1) - dot(torque2, p.motion.w2);
    const auto k = TypeParam::resistance(p.a1, p.a2, p.gap);
    const double arm = TypeParam::arm(p.a1, p.a2, p.distance());
    const double quadratic = pair_dissipation(k, lubricated_motion(p.e, arm, p.motion));
    ASSERT_GE(quadratic, 0);
    ASSERT_GE(loss, -1e-12 * quadratic);
    ASSERT_NEAR(loss, quadratic, 1e-12 * (quadratic + scale<TypeParam>(p) * norm(p.motion.u)));
    ASSERT_GE(k.Y * k.C, k.B * k.B);
  }
}

TYPED_TEST(LubricationLaw, PackAndScalarAgree) {
  Draw draw(6);
  for (int trial = 0; trial < 2000; ++trial) {
    const Pair p = draw_pair(draw);
    const auto scalar = TypeParam::resistance(p.a1, p.a2, p.gap);
    const auto pack = TypeParam::resistance(Pack(p.a1), Pack(p.a2), Pack(p.gap));
    ASSERT_NEAR(pack.X[0], scalar.X, 1e-14 * std::abs(scalar.X));
    ASSERT_NEAR(pack.Y[0], scalar.Y, 1e-14 * std::abs(scalar.Y));
    ASSERT_NEAR(pack.B[0], scalar.B, 1e-14 * std::abs(scalar.B));
    ASSERT_NEAR(pack.C[0], scalar.C, 1e-14 * std::abs(scalar.C));
  }
}

// Y C - B^2 has the closed form 64*15/25 pi^2 a1^4 l^4/(1+l)^4 L^2.
TEST(Complete, DeterminantHasItsClosedForm) {
  Draw draw(7);
  for (int trial = 0; trial < 1000; ++trial) {
    const Pair p = draw_pair(draw);
    const auto k = Complete::resistance(p.a1, p.a2, p.gap);
    const double l = p.a2 / p.a1, log = std::log(0.5 * (p.a1 + p.a2) / p.gap);
    const double expected = 64 * 15 / 25.0 * pi * pi * std::pow(p.a1, 4) * std::pow(l / (1 + l), 4) * log * log;
    ASSERT_NEAR(k.Y * k.C - k.B * k.B, expected, 1e-10 * k.Y * k.C);
  }
}

TEST(WallLubrication, DissipatesAndTurnsWithTheFrame) {
  Draw draw(8);
  for (int trial = 0; trial < 10000; ++trial) {
    const double a = draw.log_uniform(0.1, 10), gap = a * draw.log_uniform(1e-4, 0.1);
    const auto k = wall_resistance(a, gap);
    const Vec3<double> e = draw.direction(), u = draw.vector(), w = draw.vector(), axis = draw.vector();
    const auto on = wall_wrench(e, k, u, w);
    ASSERT_GE(dot(on.force, u) - dot(on.torque, w), 0);
    const auto turned = wall_wrench(rotate(axis, e), k, rotate(axis, u), rotate(axis, w));
    ASSERT_LE(norm(rotate(axis, on.force) - turned.force), 1e-12 * norm(on.force));
    ASSERT_LE(norm(rotate(axis, on.torque) - turned.torque), 1e-12 * norm(on.torque));
  }
}

}  // namespace
}  // namespace stresslet
