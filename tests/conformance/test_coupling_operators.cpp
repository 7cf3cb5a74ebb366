// Every operator in CouplingOperators with every collision: balance of mass and momentum, fixed points, limits, packs,
// and the kinetic stress that it states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "../random_pairs.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/operators/kinetic_stress.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {
namespace {

using testing::Draw;

template <class Operator_, class Collision_, class Stencil_>
struct Choice {
  using Operator = Operator_;
  using Collision = Collision_;
  using Stencil = Stencil_;
};

/// All operators with all collisions on D3Q19, and with TRT in two dimensions.
template <class Stencil, class Collision, class List>
struct WithOperators;
template <class Stencil, class Collision, class... Operators>
struct WithOperators<Stencil, Collision, TypeList<Operators...>> {
  using type = std::tuple<Choice<Operators, Collision, Stencil>...>;
};
template <class Tuple>
struct GTestTypes;
template <class... Choices>
struct GTestTypes<std::tuple<Choices...>> {
  using type = ::testing::Types<Choices...>;
};
template <class... Collisions>
constexpr auto on_main_stencil(TypeList<Collisions...>) {
  return std::tuple_cat(typename WithOperators<D3Q19, Collisions, CouplingOperators>::type{}...);
}
using AllChoices =
    decltype(std::tuple_cat(on_main_stencil(CollisionLaws{}), WithOperators<D2Q9, Trt, CouplingOperators>::type{}));

template <class Stencil>
Vec3<double> velocity_in(Draw& draw, double size = 0.05) {
  const Vec3<double> v = size * draw.vector();
  return {v.x, v.y, Stencil::dimensions == 3 ? v.z : 0};
}

template <class Stencil>
CellPopulations<Stencil, double> equilibrium(double density_deviation, const Vec3<double>& velocity) {
  const Equilibrium<Stencil, double> eq(density_deviation, velocity);
  CellPopulations<Stencil, double> f;
  f.rest = eq.rest();
  unroll<Stencil::pairs>([&](auto k) { f.pair[k] = eq.template pair<first_of_pair(k)>(); });
  return f;
}

/// Random populations, far from equilibrium.
template <class Stencil>
CellPopulations<Stencil, double> draw_populations(Draw& draw) {
  CellPopulations<Stencil, double> f = equilibrium<Stencil>(draw.uniform(-0.1, 0.1), velocity_in<Stencil>(draw));
  f.rest += draw.uniform(-0.02, 0.02);
  for (auto& pair : f.pair) pair.even += draw.uniform(-0.02, 0.02), pair.odd += draw.uniform(-0.02, 0.02);
  return f;
}

template <class Stencil>
double difference(const CellPopulations<Stencil, double>& a, const CellPopulations<Stencil, double>& b) {
  double worst = std::abs(a.rest - b.rest);
  for (int k = 0; k < Stencil::pairs; ++k)
    worst = std::max({worst, std::abs(a.pair[k].even - b.pair[k].even), std::abs(a.pair[k].odd - b.pair[k].odd)});
  return worst;
}

template <class Choice>
class CouplingOperator : public ::testing::Test {
 public:
  using Chosen = Choice;
  using Cell = CellPopulations<typename Choice::Stencil, double>;

  Draw draw{7};
  static constexpr double tau = 0.8;
  const RelaxationRates rates = Choice::Collision::rates(CollisionInput{tau, 1.0 / 12, std::nullopt, std::nullopt});

  BodyForce<double> force(const Vec3<double>& density = {}) const { return {density, rates.odd}; }

  template <class Forcing>
  Vec3<double> collide(Cell& f, const BodyForce<double>& body, const CoveredCell<double>& solid) const {
    typename Choice::Collision::template Cell<typename Choice::Stencil, double> cell(rates);
    return Choice::Operator::template collide<typename Choice::Collision, Forcing>(f, cell, body, solid);
  }
  template <class Forcing>
  Cell fluid_collision(Cell f, const BodyForce<double>& body) const {
    typename Choice::Collision::template Cell<typename Choice::Stencil, double> cell(rates);
    stresslet::collide<typename Choice::Collision, Forcing>(f, cell, body);
    return f;
  }
  CoveredCell<double> draw_solid() {
    return {draw.uniform(0, Choice::Operator::largest_weight), velocity_in<typename Choice::Stencil>(draw)};
  }
};
TYPED_TEST_SUITE(CouplingOperator, GTestTypes<AllChoices>::type);

/// Mass is kept; momentum changes by the body force and exchange B rho (us - u*), which is also what is returned.
template <class Forcing, class Test>
void expect_balance(Test& test) {
  using Stencil = typename Test::Chosen::Stencil;
  for (int n = 0; n < 20; ++n) {
    const auto before = draw_populations<Stencil>(test.draw);
    const auto solid = test.draw_solid();
    const auto body =
        test.force(std::is_same_v<Forcing, NoForce> ? Vec3<double>{} : velocity_in<Stencil>(test.draw, 1e-2));
    auto after = before;
    const Vec3<double> given = test.template collide<Forcing>(after, body, solid);
    const auto m0 = moments_of(before), m1 = moments_of(after);
    const double rho = m0.density();
    const Vec3<double> u = (m0.momentum + 0.5 * body.density) / rho;
    const Vec3<double> expected = (Test::Chosen::Operator::exchange * solid.weight * rho) * (solid.velocity - u);
    EXPECT_NEAR(m1.density_deviation, m0.density_deviation, 2e-16 * 8);
    EXPECT_LT(norm(given - expected), 1e-16);
    EXPECT_LT(norm(m1.momentum - m0.momentum - body.density - expected), 1e-15);
  }
}

TYPED_TEST(CouplingOperator, KeepsMassAndStatesItsMomentum) { expect_balance<NoForce>(*this); }

TYPED_TEST(CouplingOperator, KeepsTheBalanceUnderABodyForce) {
  expect_balance<Guo>(*this);
  expect_balance<VelocityShift>(*this);
}

TYPED_TEST(CouplingOperator, LeavesEquilibriumWithTheSolidAlone) {
  using Stencil = typename TypeParam::Stencil;
  for (int n = 0; n < 20; ++n) {
    const CoveredCell<double> solid = this->draw_solid();
    const auto before = equilibrium<Stencil>(this->draw.uniform(-0.1, 0.1), solid.velocity);
    auto after = before;
    const Vec3<double> given = this->template collide<NoForce>(after, this->force(), solid);
    EXPECT_LT(difference(after, before), 3e-16);
    EXPECT_LT(norm(given), 3e-16);
  }
}

TYPED_TEST(CouplingOperator, IsTheFluidsCollisionWithoutSolid) {
  using Stencil = typename TypeParam::Stencil;
  for (int n = 0; n < 20; ++n) {
    const auto before = draw_populations<Stencil>(this->draw);
    const CoveredCell<double> solid{0, velocity_in<Stencil>(this->draw)};
    const auto body = this->force(velocity_in<Stencil>(this->draw, 1e-2));
    auto after = before;
    EXPECT_EQ(this->template collide<Guo>(after, body, solid), Vec3<double>{});
    EXPECT_LT(difference(after, this->template fluid_collision<Guo>(before, body)), 1e-16);
    after = before;
    this->template collide<NoForce>(after, this->force(), solid);
    EXPECT_LT(difference(after, this->template fluid_collision<NoForce>(before, this->force())), 1e-16);
  }
}

/// What the operators do to one population, written out as in the literature, for BGK.
TYPED_TEST(CouplingOperator, IsItsFormulaForBgk) {
  using Stencil = typename TypeParam::Stencil;
  using Operator = typename TypeParam::Operator;
  if constexpr (std::is_same_v<typename TypeParam::Collision, Bgk>) {
    for (int n = 0; n < 20; ++n) {
      const auto before = draw_populations<Stencil>(this->draw);
      const CoveredCell<double> solid = this->draw_solid();
      auto after = before;
      this->template collide<NoForce>(after, this->force(), solid);
      const auto m = moments_of(before);
      const Vec3<double> u = m.momentum / m.density();
      const auto list = [](const CellPopulations<Stencil, double>& f) {
        std::array<double, Stencil::size> all{f.rest};
        for (int k = 0; k < Stencil::pairs; ++k) {
          all[first_of_pair(k)] = 0.5 * (f.pair[k].even + f.pair[k].odd);
          all[first_of_pair(k) + 1] = 0.5 * (f.pair[k].even - f.pair[k].odd);
        }
        return all;
      };
      const auto f = list(before), out = list(after);
      const auto eq_u = list(equilibrium<Stencil>(m.density_deviation, u));
      const auto eq_s = list(equilibrium<Stencil>(m.density_deviation, solid.velocity));
      for (int i = 0; i < Stencil::size; ++i) {
        const int j = opposite(i);
        const double fluid = (eq_u[i] - f[i]) / this->tau, b = solid.weight;
        double expected = out[i];
        if constexpr (std::is_same_v<Operator, Superposition>)
          expected = f[i] + fluid + b * (eq_s[i] - eq_u[i]);
        else if constexpr (std::is_same_v<Operator, NonEquilibriumBounceBack>)
          expected = f[i] + (1 - b) * fluid + b * (f[j] - f[i] + eq_s[i] - eq_u[j]);
        else if constexpr (std::is_same_v<Operator, Holdych>)
          expected = f[i] + (1 - b) * fluid + b * (f[j] - f[i] + eq_s[i] - eq_s[j]);
        else if constexpr (std::is_same_v<Operator, HalfHoldych>)
          expected = f[i] + (1 - b) * fluid + 0.5 * b * (f[j] - f[i] + eq_s[i] - eq_s[j]);
        else if constexpr (std::is_same_v<Operator, GuoForm>) {
          const Vec3<double> p = (b * m.density()) * (solid.velocity - u), v = u + (0.5 / m.density()) * p;
          const auto& c = Stencil::velocity[i];
          const Vec3<double> ci{double(c[0]), double(c[1]), double(c[2])};
          const double source = Stencil::weight[i] * (3 * dot(ci - v, p) + 9 * dot(ci, v) * dot(ci, p));
          const double eq_v = list(equilibrium<Stencil>(m.density_deviation, v))[i];
          expected = f[i] + (eq_v - f[i]) / this->tau + (1 - 0.5 / this->tau) * source;
        } else {
          ADD_FAILURE() << Operator::name << " has no formula here";
        }
        EXPECT_NEAR(out[i], expected, 2e-16) << i;
      }
    }
  }
}

TYPED_TEST(CouplingOperator, AtFullWeightSuperpositionKeepsOnlyTheStress) {
  using Stencil = typename TypeParam::Stencil;
  if constexpr (std::is_same_v<typename TypeParam::Operator, Superposition> &&
                std::is_same_v<typename TypeParam::Collision, Bgk>) {
    const auto before = draw_populations<Stencil>(this->draw);
    const CoveredCell<double> solid{1, velocity_in<Stencil>(this->draw)};
    auto after = before;
    this->template collide<NoForce>(after, this->force(), solid);
    const auto m = moments_of(before);
    const auto eq_u = equilibrium<Stencil>(m.density_deviation, m.momentum / m.density());
    auto expected = equilibrium<Stencil>(m.density_deviation, solid.velocity);
    const double left = 1 - 1 / this->tau;
    expected.rest += left * (before.rest - eq_u.rest);
    for (int k = 0; k < Stencil::pairs; ++k) {
      expected.pair[k].even += left * (before.pair[k].even - eq_u.pair[k].even);
      expected.pair[k].odd += left * (before.pair[k].odd - eq_u.pair[k].odd);
    }
    EXPECT_LT(difference(after, expected), 2e-16);
  }
}

/// A cell of steady stress: the stress that it carries, -(before + after)/2 of the collision, less the Newtonian stress
/// of the strain rate that its relaxation implies, is the kinetic stress.
TYPED_TEST(CouplingOperator, StatesItsKineticStress) {
  using Stencil = typename TypeParam::Stencil;
  using Operator = typename TypeParam::Operator;
  for (int n = 0; n < 20; ++n) {
    const auto before = draw_populations<Stencil>(this->draw);
    const auto m = moments_of(before);
    const Vec3<double> u = m.momentum / m.density();
    const CoveredCell<double> solid{this->draw.uniform(0, Operator::largest_weight), u};
    auto after = before;
    this->template collide<NoForce>(after, this->force(), solid);
    const auto pi0 = non_equilibrium_stress(before, u), pi1 = non_equilibrium_stress(after, u);
    const auto expected = -0.5 * (pi0 + pi1) + (this->tau - 0.5) * (pi0 - pi1);
    const auto stated = kinetic_stress<Operator>(solid.weight, pi0);
    for (const auto part : {&SymTensor3<double>::xx, &SymTensor3<double>::yy, &SymTensor3<double>::zz,
                            &SymTensor3<double>::xy, &SymTensor3<double>::xz, &SymTensor3<double>::yz})
      EXPECT_NEAR(stated.*part, expected.*part, 3e-16);
  }
}

TYPED_TEST(CouplingOperator, TakesOverTheSolidsVelocityAtUnitExchange) {
  using Stencil = typename TypeParam::Stencil;
  const auto before = draw_populations<Stencil>(this->draw);
  const CoveredCell<double> solid{1 / TypeParam::Operator::exchange, velocity_in<Stencil>(this->draw)};
  auto after = before;
  this->template collide<NoForce>(after, this->force(), solid);
  const auto m = moments_of(after);
  EXPECT_LT(norm(m.momentum / m.density() - solid.velocity), 3e-16);
}

template <class R, class Test>
void expect_packs_agree(Test& test, double tolerance) {
  using Stencil = typename Test::Chosen::Stencil;
  using Value = typename R::value_type;
  CellPopulations<Stencil, double> cells[R::size()];
  CoveredCell<double> solids[R::size()];
  for (auto& cell : cells) cell = draw_populations<Stencil>(test.draw);
  for (auto& solid : solids) solid = test.draw_solid();
  const auto lanes = [](auto&& of) { return R([&](auto k) { return Value(of(k)); }); };
  const auto vector = [&](auto&& of) {
    return Vec3<R>{lanes([&](auto k) { return of(k).x; }), lanes([&](auto k) { return of(k).y; }),
                   lanes([&](auto k) { return of(k).z; })};
  };
  CellPopulations<Stencil, R> pack;
  pack.rest = lanes([&](auto k) { return cells[k].rest; });
  for (int p = 0; p < Stencil::pairs; ++p)
    pack.pair[p] = {lanes([&](auto k) { return cells[k].pair[p].even; }),
                    lanes([&](auto k) { return cells[k].pair[p].odd; })};
  const CoveredCell<R> solid{lanes([&](auto k) { return solids[k].weight; }),
                             vector([&](auto k) { return solids[k].velocity; })};
  const Vec3<double> f = velocity_in<Stencil>(test.draw, 1e-2);
  const BodyForce<R> body{{R(Value(f.x)), R(Value(f.y)), R(Value(f.z))}, R(Value(test.rates.odd))};
  using Choice = typename Test::Chosen;
  typename Choice::Collision::template Cell<Stencil, R> rates(test.rates);
  const Vec3<R> given = Choice::Operator::template collide<typename Choice::Collision, Guo>(pack, rates, body, solid);
  for (std::size_t k = 0; k < R::size(); ++k) {
    const Vec3<double> alone = test.template collide<Guo>(cells[k], test.force(f), solids[k]);
    EXPECT_LT(norm(Vec3<double>{given.x[k], given.y[k], given.z[k]} - alone), tolerance);
    CellPopulations<Stencil, double> lane;
    lane.rest = pack.rest[k];
    for (int p = 0; p < Stencil::pairs; ++p) lane.pair[p] = {pack.pair[p].even[k], pack.pair[p].odd[k]};
    EXPECT_LT(difference(lane, cells[k]), tolerance);
  }
}

TYPED_TEST(CouplingOperator, GivesThePackWhatItGivesTheCell) {
  expect_packs_agree<PackOf<double>>(*this, 4e-16);
  if constexpr (std::is_same_v<typename TypeParam::Collision, Trt>) expect_packs_agree<PackOf<float>>(*this, 2e-7);
}

}  // namespace
}  // namespace stresslet
