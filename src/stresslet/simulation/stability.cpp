#include "stresslet/simulation/stability.hpp"

#include <cmath>
#include <random>

#include "stresslet/exec/chunk_sum.hpp"

namespace stresslet {

double explicit_step_number(Suspension& s, ThreadTeam& team) {
  constexpr int iterations = 30;
  const std::size_t n = s.state.size();
  TwistVector mode;
  mode.resize(n);
  std::mt19937_64 generator;
  const auto random = [&generator] { return double(generator() >> 11) * 0x1p-53 - 0.5; };
  for (std::size_t i = 0; i < n; ++i) mode.set(i, {random(), random(), random()}, {random(), random(), random()});

  ChunkSum<double> norm_sum;
  norm_sum.resize(n);
  double eigenvalue = 0;
  team.run([&](Member& member) {
    const Range mine = member.share(n, sum_chunk);
    for (int iteration = 0; iteration < iterations; ++iteration) {
      s.lubrication.apply<false>(member, s.pairs, mode);
      const double square = norm_sum(member, n, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
          Twist<double> w{};
          s.lubrication.add_to(i, s.pairs, w);
          s.walls.add_to<false>(i, mode.get(i), w);
          const Twist<double> rate{w.linear / s.state.mass(i), w.angular / s.state.inertia(i)};
          s.residual.set(i, rate);
          sum += s.state.mass(i) * dot(rate.linear, rate.linear) + s.state.inertia(i) * dot(rate.angular, rate.angular);
        }
        return sum;
      });
      const double size = std::sqrt(square);
      if (member.rank() == 0) eigenvalue = size;
      for (std::size_t k = twist_stride * mine.begin; k < twist_stride * mine.end; ++k)
        mode.data()[k] = size > 0 ? s.residual.data()[k] / size : 0.0;
      member.barrier();
    }
  });
  return s.time.step * eigenvalue;
}

}  // namespace stresslet
