/// Friction of spheres through the fluid: the kernel over packs against the force of one friction, and what a change of
/// frame leaves as it is.
#include <gtest/gtest.h>

#include <random>

#include "stresslet/lubrication/fluid_coupling.hpp"

namespace stresslet {
namespace {

constexpr std::size_t particles = 9, frictions = 21;  // the last pack is not full

class FluidFriction : public testing::Test {
 protected:
  FluidFriction() {
    velocity_.resize(particles);
    coupling_.resistance.resize(particles);
    coupling_.push.resize(particles);
    for (std::size_t i = 0; i < particles; ++i) {
      velocity_.set(i, vector(), vector());
      coupling_.resistance[i] = {2 + number(), vector(), {3, 4, 5, 0.1, 0.2, 0.3}};
      coupling_.push[i] = {vector(), vector()};
    }
    std::vector<PointFriction> all;
    for (std::size_t k = 0; k < frictions; ++k) {
      const std::int32_t first = std::int32_t(k % particles), second = std::int32_t((k * k + 1 + k) % particles);
      if (first != second) all.push_back({first, second, 1.5 + number(), vector(), vector(), {number(), 0, 0}});
    }
    coupling_.set_friction(std::move(all), particles);
  }

  /// From the frictions one by one.
  template <bool background>
  std::vector<Twist<double>> expected() const {
    std::vector<Twist<double>> sum(particles);
    for (std::size_t i = 0; i < particles; ++i) {
      const ExchangeResistance& e = coupling_.resistance[i];
      const Twist<double> v = velocity_.get(i);
      sum[i] = {-e.linear * v.linear - cross(v.angular, e.offset), -cross(e.offset, v.linear) - e.angular * v.angular};
      if (background) sum[i].linear += coupling_.push[i].linear, sum[i].angular += coupling_.push[i].angular;
    }
    for (const PointFriction& f : coupling_.friction()) {
      const std::size_t i = std::size_t(f.first), j = std::size_t(f.second);
      const Vec3<double> force = f.force(velocity_.get(i), velocity_.get(j), background);
      sum[i].linear += force, sum[i].angular += cross(f.arm_first, force);
      sum[j].linear -= force, sum[j].angular -= cross(f.arm_second, force);
    }
    return sum;
  }
  template <bool background>
  std::vector<Twist<double>> computed(int threads) {
    ThreadTeam team(threads);
    team.run([&](Member& member) { coupling_.apply<background>(member, velocity_); });
    std::vector<Twist<double>> sum(particles);
    for (std::size_t i = 0; i < particles; ++i) coupling_.add_to<background>(i, velocity_.get(i), sum[i]);
    return sum;
  }
  static void expect_equal(const std::vector<Twist<double>>& a, const std::vector<Twist<double>>& b) {
    for (std::size_t i = 0; i < particles; ++i) {
      EXPECT_LT(norm(a[i].linear - b[i].linear), 1e-13) << "particle " << i;
      EXPECT_LT(norm(a[i].angular - b[i].angular), 1e-13) << "particle " << i;
    }
  }

  double number() { return uniform_(random_); }
  Vec3<double> vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  std::mt19937_64 random_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
  TwistVector velocity_;
  FluidCoupling coupling_;
};

TEST_F(FluidFriction, PacksGiveWhatSingleFrictionsGive) {
  ASSERT_NE(coupling_.friction().size() % pack_width, 0u);
  for (const int threads : {1, 2, 5}) {
    expect_equal(computed<true>(threads), expected<true>());
    expect_equal(computed<false>(threads), expected<false>());
  }
}

TEST_F(FluidFriction, ForcesStayWhenAParticleIsCountedFromAnotherFrame) {
  const auto before = computed<true>(2);
  const Vec3<double> change{0.7, 0, 0};
  Twist<double> v = velocity_.get(3);
  velocity_.set(3, v.linear + change, v.angular);
  coupling_.change_frame(3, change);
  expect_equal(computed<true>(2), before);
}

}  // namespace
}  // namespace stresslet
