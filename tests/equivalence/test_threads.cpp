// The number of threads changes no bit: every scheme, friction on, list rebuilds included.
#include <gtest/gtest.h>

#include "../small_system.hpp"

namespace stresslet {
namespace {

struct Bits {
  ParticleState state;
  std::vector<double> sampled;
  std::int64_t builds;
};

Bits after_shear(const Suspension& begin, int threads, int steps) {
  ThreadTeam team(threads);
  Suspension s = begin;
  start(s, team);
  testing::advance(s, team, steps);
  const Sample last = sample(s, team);
  Bits bits{s.state, {last.dissipation(), last.elastic_energy, last.kinetic_energy, last.momentum.x}, s.builds};
  StressParts::for_each(last.stress, [&](const char*, const Stress& p) {
    for (const double v : {p.xx, p.yy, p.zz, p.xy, p.xz, p.yz}) bits.sampled.push_back(v);
  });
  return bits;
}

void expect_identical(const Bits& a, const Bits& b) {
  const auto same = [](const auto& x, const auto& y) { return std::equal(x.begin(), x.end(), y.begin(), y.end()); };
  const ParticleState &s = a.state, &t = b.state;
  EXPECT_TRUE(same(s.id, t.id));
  EXPECT_TRUE(same(s.x, t.x) && same(s.y, t.y) && same(s.z, t.z));
  EXPECT_TRUE(same(s.ux, t.ux) && same(s.uy, t.uy) && same(s.uz, t.uz));
  EXPECT_TRUE(same(s.wx, t.wx) && same(s.wy, t.wy) && same(s.wz, t.wz));
  EXPECT_EQ(a.sampled, b.sampled);
}

struct SchemeStep {
  const char* scheme;
  double step;
};

class Threads : public ::testing::TestWithParam<SchemeStep> {};

TEST_P(Threads, ChangeNoBit) {
  Physics physics;
  physics.contact.stiffness = 2.5e4, physics.contact.friction = 1;
  // More particles than one chunk of the sums holds, so that every thread has a share.
  Suspension s = testing::packed_system(400, 0.45, physics, testing::time_control(GetParam().scheme, GetParam().step));
  s.list = VerletList(s.list.range(), 0.02);
  constexpr int steps = 200;
  const Bits one = after_shear(s, 1, steps);
  for (const int threads : {2, 3}) {
    SCOPED_TRACE(threads);
    expect_identical(one, after_shear(s, threads, steps));
  }
  if (GetParam().step > 1e-5) {
    EXPECT_GT(one.builds, 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Threads,
                         ::testing::Values(SchemeStep{"explicit", 5e-6}, SchemeStep{"semi-implicit", 3e-4},
                                           SchemeStep{"inertialess", 3e-4}));

}  // namespace
}  // namespace stresslet
