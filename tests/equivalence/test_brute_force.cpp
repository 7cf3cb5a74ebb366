// The kernels in a running sheared suspension against loops over all pairs, in plain scalar code.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../small_system.hpp"
#include "stresslet/lubrication/laws.hpp"

namespace stresslet {
namespace {

struct Image {
  Vec3<double> r;
  double jump;  ///< velocity in x to be added to u_j - u_i
};

/// Nearest of all images one box away in every direction.
Image nearest(const Box& box, const Vec3<double>& from, const Vec3<double>& to) {
  Image best{{1e9, 0, 0}, 0};
  for (int ny = -1; ny <= 1; ++ny)
    for (int nx = -2; nx <= 2; ++nx)
      for (int nz = -1; nz <= 1; ++nz) {
        const Vec3<double> r =
            to - from + Vec3<double>{nx * box.length.x + ny * box.offset, ny * box.length.y, nz * box.length.z};
        if (norm(r) < norm(best.r)) best = {r, ny * box.length.y * box.shear_rate};
      }
  return best;
}

/// Interacting pairs as (smaller id, larger id).
using Pairs = std::set<std::pair<int, int>>;

Pairs all_pairs(const Suspension& s) {
  Pairs found;
  for (std::size_t i = 0; i < s.state.size(); ++i)
    for (std::size_t j = 0; j < s.state.size(); ++j) {
      if (s.state.id[i] >= s.state.id[j]) continue;
      const double a1 = s.state.radius[i], a2 = s.state.radius[j];
      const double reach = a1 + a2 + s.physics.cutoffs.outer * 2 * a1 * a2 / (a1 + a2);
      if (norm(nearest(s.box, s.state.position(i), s.state.position(j)).r) < reach)
        found.emplace(s.state.id[i], s.state.id[j]);
    }
  return found;
}

Pairs listed_pairs(const Suspension& s) {
  Pairs found;
  for (std::size_t p = 0; p < s.pairs.size(); ++p) {
    const int a = s.state.id[std::size_t(s.pairs.i[p])], b = s.state.id[std::size_t(s.pairs.j[p])];
    EXPECT_TRUE(found.emplace(std::min(a, b), std::max(a, b)).second) << "pair listed twice";
  }
  return found;
}

Suspension sheared_packing(const std::string& law) {
  Physics physics;
  physics.lubrication_law = law;
  physics.contact.stiffness = 2.5e4, physics.contact.friction = 0.5;
  return testing::packed_system(120, 0.5, physics, testing::time_control("semi-implicit", 5e-4));
}

TEST(NeighbourList, HoldsEveryPairThatInteractsWhileTheBoxIsSheared) {
  ThreadTeam team(1);
  Suspension s = sheared_packing("complete");
  start(s, team);
  for (int block = 0; block < 30; ++block) {
    const Pairs expected = all_pairs(s);
    EXPECT_GT(expected.size(), s.state.size());
    EXPECT_EQ(listed_pairs(s), expected) << "strain " << s.strain;
    testing::advance(s, team, 67);
  }
  EXPECT_GT(s.builds, 10);
}

/// Wrenches of all films by the scalar law.
template <class Law>
std::vector<Twist<double>> film_wrenches(const Suspension& s) {
  std::vector<Twist<double>> wrench(s.state.size());
  for (std::size_t i = 0; i < s.state.size(); ++i)
    for (std::size_t j = i + 1; j < s.state.size(); ++j) {
      const Image image = nearest(s.box, s.state.position(i), s.state.position(j));
      const double a1 = s.state.radius[i], a2 = s.state.radius[j], distance = norm(image.r);
      const double gap = distance - a1 - a2, effective = 2 * a1 * a2 / (a1 + a2);
      if (gap > s.physics.cutoffs.outer * effective) continue;
      const Vec3<double> e = image.r / distance;
      PairMotion<double> motion{s.state.velocity(j) - s.state.velocity(i), s.state.angular_velocity(i),
                                s.state.angular_velocity(j)};
      motion.u.x += image.jump;
      if (Law::sees_background) motion.u.x -= gap * e.y * s.box.shear_rate;
      const auto k = Law::template resistance<double>(a1, a2, std::max(gap, s.physics.cutoffs.inner * effective));
      const PairWrench<double> w = pair_wrench(e, Law::arm(a1, a2, distance), k, motion);
      wrench[i].linear += w.force, wrench[j].linear -= w.force;
      wrench[i].angular += w.half_sum - w.half_difference, wrench[j].angular += w.half_sum + w.half_difference;
    }
  return wrench;
}

TEST(PairKernel, SumsTheScalarLawOverAllPairs) {
  ThreadTeam team(1);
  LubricationLaws::for_each([&](auto tag) {
    using Law = typename decltype(tag)::type;
    if (Law::name == "none") return;
    SCOPED_TRACE(std::string(Law::name));
    Suspension s = sheared_packing(std::string(Law::name));
    start(s, team);
    testing::advance(s, team, 1000);
    TwistVector twist;
    twist.resize(s.state.size());
    for (std::size_t i = 0; i < s.state.size(); ++i) twist.set(i, s.state.velocity(i), s.state.angular_velocity(i));
    team.run([&](Member& member) { s.lubrication.apply<true>(member, s.pairs, twist); });

    const std::vector<Twist<double>> expected = film_wrenches<Law>(s);
    double largest = 0;
    for (const auto& w : expected) largest = std::max(largest, norm(w.linear));
    ASSERT_GT(largest, 1);
    for (std::size_t i = 0; i < s.state.size(); ++i) {
      Twist<double> found{};
      s.lubrication.add_to(i, s.pairs, found);
      EXPECT_LE(norm(found.linear - expected[i].linear), 1e-10 * largest);
      EXPECT_LE(norm(found.angular - expected[i].angular), 1e-10 * largest);
    }
  });
}

}  // namespace
}  // namespace stresslet
