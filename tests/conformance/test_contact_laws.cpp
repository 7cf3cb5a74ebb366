// Every law in NormalContactLaws: spring from its energy, balance, symmetry, invariance, Coulomb limit, dissipation.
#include <gtest/gtest.h>

#include "../random_pairs.hpp"
#include "stresslet/dem/contact/contact_forces.hpp"
#include "stresslet/dem/laws.hpp"

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

constexpr int draws = 2000;

/// Two touching spheres with their own velocities.
struct Touching {
  double a1, a2, overlap, stiffness, step;
  Vec3<double> e, u1, u2, w1, w2, elongation;

  double distance() const { return a1 + a2 - overlap; }
  ContactGeometry geometry() const {
    const double sum = a1 + a2, m1 = std::pow(a1, 3), m2 = std::pow(a2, 3);
    return {e, overlap, a1 * a2 / sum, m1 * m2 / (m1 + m2), a1 * distance() / sum, a2 * distance() / sum};
  }
  ContactMotion motion() const { return {u2 - u1, w1, w2, dot(u2 - u1, e)}; }
  Touching exchanged() const { return {a2, a1, overlap, stiffness, step, -e, u2, u1, w2, w1, -elongation}; }
};

Touching draw_touching(Draw& draw) {
  Touching t;
  t.a1 = draw.log_uniform(0.1, 10), t.a2 = t.a1 * draw.log_uniform(0.1, 10);
  t.overlap = draw.log_uniform(1e-5, 0.1) * std::min(t.a1, t.a2);
  t.stiffness = draw.log_uniform(1, 1e6), t.step = 1e-3;
  t.e = draw.direction();
  t.u1 = draw.vector(), t.u2 = draw.vector(), t.w1 = draw.vector(), t.w2 = draw.vector();
  t.elongation = 0.01 * t.overlap * tangential_part(draw.vector(), t.e);
  return t;
}

ContactParameters parameters(const Touching& t, double friction, double damping = 0,
                             CoulombLimit limit = CoulombLimit::spring) {
  ContactParameters p;
  p.stiffness = t.stiffness, p.friction = friction, p.damping_ratio = damping, p.coulomb_limit = limit;
  return p;
}

template <class Law>
ContactResult result(const Touching& t, const ContactParameters& p) {
  return contact_force<Law>(t.geometry(), p, t.elongation, t.motion(), t.step);
}

template <class Law>
class ContactLaw : public ::testing::Test {
 protected:
  Draw draw{7};
  const std::vector<double> frictions{0.01, 0.3, 1.0, 100.0};
};
TYPED_TEST_SUITE(ContactLaw, GTestTypes<NormalContactLaws>::type);

TYPED_TEST(ContactLaw, ForceIsTheDerivativeOfTheEnergyAndStiffnessThatOfTheForce) {
  for (int n = 0; n < draws; ++n) {
    const double overlap = this->draw.log_uniform(1e-5, 0.1), r = this->draw.log_uniform(0.05, 5),
                 k = this->draw.log_uniform(1, 1e6), h = 1e-4 * overlap;
    const double slope = (TypeParam::energy(overlap + h, r, k) - TypeParam::energy(overlap - h, r, k)) / (2 * h);
    EXPECT_NEAR(slope / TypeParam::force(overlap, r, k), 1, 1e-7);
    const double slope_of_force = (TypeParam::force(overlap + h, r, k) - TypeParam::force(overlap - h, r, k)) / (2 * h);
    EXPECT_NEAR(slope_of_force / TypeParam::tangent_stiffness(overlap, r, k), 1, 1e-7);
  }
}

TYPED_TEST(ContactLaw, RepelsAlongTheLineOfCentresWithoutFriction) {
  for (int n = 0; n < draws; ++n) {
    const Touching t = draw_touching(this->draw);
    const ContactResult c = result<TypeParam>(t, parameters(t, 0));
    EXPECT_EQ(c.tangential_force, Vec3<double>{});
    EXPECT_EQ(c.sliding_power, 0);
    EXPECT_LT(dot(c.force, t.e), 0);
    EXPECT_LE(norm(tangential_part(c.force, t.e)), 1e-14 * norm(c.force));
  }
}

TYPED_TEST(ContactLaw, ExchangeOfTheSpheresReversesTheForce) {
  for (int n = 0; n < draws; ++n) {
    const Touching t = draw_touching(this->draw);
    for (const double friction : this->frictions) {
      const ContactResult a = result<TypeParam>(t, parameters(t, friction, 0.1)),
                          b = result<TypeParam>(t.exchanged(), parameters(t, friction, 0.1));
      EXPECT_LE(norm(a.force + b.force), 1e-12 * norm(a.force));
      EXPECT_LE(norm(a.elongation + b.elongation), 1e-12 * norm(a.elongation));
      EXPECT_NEAR(a.sliding_power, b.sliding_power, 1e-9 * a.sliding_power);
    }
  }
}

TYPED_TEST(ContactLaw, TurnsWithTheFrame) {
  for (int n = 0; n < draws; ++n) {
    const Touching t = draw_touching(this->draw);
    const Vec3<double> axis = this->draw.vector();
    Touching turned = t;
    for (auto* v : {&turned.e, &turned.u1, &turned.u2, &turned.w1, &turned.w2, &turned.elongation})
      *v = rotate(axis, *v);
    const ContactParameters p = parameters(t, 0.3, 0.1);
    const ContactResult a = result<TypeParam>(t, p), b = result<TypeParam>(turned, p);
    EXPECT_LE(norm(rotate(axis, a.force) - b.force), 1e-12 * norm(a.force));
    EXPECT_LE(norm(rotate(axis, a.elongation) - b.elongation), 1e-11 * norm(a.elongation));
  }
}

TYPED_TEST(ContactLaw, FeelsNeitherCommonTranslationNorRigidRotation) {
  for (int n = 0; n < draws; ++n) {
    const Touching t = draw_touching(this->draw);
    const Vec3<double> drift = this->draw.vector(), spin = this->draw.vector();
    Touching moved = t;
    moved.u1 += drift, moved.u2 += drift + t.distance() * cross(spin, t.e);
    moved.w1 += spin, moved.w2 += spin;
    const ContactParameters p = parameters(t, 0.3, 0.1);
    const ContactResult a = result<TypeParam>(t, p), b = result<TypeParam>(moved, p);
    EXPECT_LE(norm(a.force - b.force), 1e-11 * norm(a.force));
  }
}

TYPED_TEST(ContactLaw, StaysWithinTheCoulombLimitAndReachesIt) {
  for (int n = 0; n < draws; ++n) {
    const Touching t = draw_touching(this->draw);
    const double spring = TypeParam::force(t.overlap, t.a1 * t.a2 / (t.a1 + t.a2), t.stiffness);
    for (const double friction : this->frictions) {
      const ContactResult c = result<TypeParam>(t, parameters(t, friction));
      EXPECT_LE(norm(c.tangential_force), friction * spring * (1 + 1e-12));
      if (c.sliding_power > 0) {
        EXPECT_GE(norm(c.tangential_force), friction * spring * (1 - 1e-12));
      }
      EXPECT_GE(c.sliding_power, 0);
    }
  }
}

TYPED_TEST(ContactLaw, HistoryLiesInTheTangentPlaneAndKeepsItsLengthWhenTurned) {
  for (int n = 0; n < draws; ++n) {
    Touching t = draw_touching(this->draw);
    t.elongation = 1e-3 * t.overlap * this->draw.vector();
    const ContactResult c = result<TypeParam>(t, parameters(t, 0.5));
    EXPECT_LE(std::abs(dot(c.elongation, t.e)), 1e-12 * norm(c.elongation));
    t.step = 0;
    const ContactResult turned = result<TypeParam>(t, parameters(t, 1e6));
    EXPECT_NEAR(norm(turned.elongation) / norm(t.elongation), 1, 1e-12);
    EXPECT_LE(std::abs(dot(turned.elongation, t.e)), 1e-12 * norm(t.elongation));
  }
}

TYPED_TEST(ContactLaw, CoulombVariantsDifferOnlyWithDashpot) {
  for (int n = 0; n < draws; ++n) {
    Touching t = draw_touching(this->draw);
    const double friction = 1e-3;
    const auto with = [&](double damping, CoulombLimit limit) {
      return result<TypeParam>(t, parameters(t, friction, damping, limit));
    };
    EXPECT_EQ(with(0, CoulombLimit::spring).force, with(0, CoulombLimit::spring_and_dashpot).force);
    t.elongation = t.overlap * tangential_part(this->draw.vector(), t.e) / norm(t.e);
    const ContactResult a = with(0.2, CoulombLimit::spring), b = with(0.2, CoulombLimit::spring_and_dashpot);
    const double spring = TypeParam::force(t.overlap, t.a1 * t.a2 / (t.a1 + t.a2), t.stiffness);
    const double total = std::max(-dot(b.force, t.e), 0.0);
    if (a.sliding_power > 0) {
      EXPECT_NEAR(norm(a.tangential_force), friction * spring, 1e-12 * friction * spring);
    }
    if (b.sliding_power > 0) {
      EXPECT_NEAR(norm(b.tangential_force), friction * total, 1e-9 * friction * total);
    }
  }
}

TYPED_TEST(ContactLaw, DashpotTakesEnergyOutWhicheverWayTheSpheresMove) {
  for (int n = 0; n < draws; ++n) {
    const Touching t = draw_touching(this->draw);
    const ContactResult elastic = result<TypeParam>(t, parameters(t, 0)),
                        damped = result<TypeParam>(t, parameters(t, 0, 0.2));
    const Vec3<double> dashpot = damped.force - elastic.force;
    EXPECT_NEAR(dot(dashpot, t.u2 - t.u1), damped.dashpot_power, 1e-9 * norm(damped.force) * norm(t.u2 - t.u1));
    EXPECT_GT(damped.dashpot_power, 0);
  }
}

}  // namespace
}  // namespace stresslet
