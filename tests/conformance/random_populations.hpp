#pragma once
/// Random populations of one cell and its collision, for tests of laws without a lattice.
#include <gtest/gtest.h>

#include <random>

#include "stresslet/lattice/collide.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet::testing {

template <class List>
struct GTestTypes;
template <class... Laws>
struct GTestTypes<TypeList<Laws...>> {
  using type = ::testing::Types<Laws...>;
};

/// Deviations of a few percent of the weights.
template <class Stencil>
std::array<double, Stencil::size> random_populations(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(-0.05, 0.05);
  std::array<double, Stencil::size> f;
  for (int i = 0; i < Stencil::size; ++i) f[std::size_t(i)] = Stencil::weight[std::size_t(i)] * uniform(engine);
  return f;
}

template <class Stencil>
CellPopulations<Stencil, double> in_pairs(const std::array<double, Stencil::size>& f) {
  CellPopulations<Stencil, double> pairs;
  pairs.rest = f[0];
  for (int k = 0; k < Stencil::pairs; ++k) {
    const std::size_t i = std::size_t(first_of_pair(k));
    pairs.pair[std::size_t(k)] = {f[i] + f[i + 1], f[i] - f[i + 1]};
  }
  return pairs;
}

template <class Stencil>
std::array<double, Stencil::size> out_of_pairs(const CellPopulations<Stencil, double>& pairs) {
  std::array<double, Stencil::size> f;
  f[0] = pairs.rest;
  for (int k = 0; k < Stencil::pairs; ++k) {
    const std::size_t i = std::size_t(first_of_pair(k));
    const auto& [even, odd] = pairs.pair[std::size_t(k)];
    f[i] = 0.5 * (even + odd);
    f[i + 1] = 0.5 * (even - odd);
  }
  return f;
}

template <class Collision, class Forcing, class Stencil>
std::array<double, Stencil::size> collided(const std::array<double, Stencil::size>& f, const CollisionInput& input,
                                           const Vec3<double>& force = {}) {
  const RelaxationRates rates = Collision::rates(input);
  typename Collision::template Cell<Stencil, double> collision(rates);
  CellPopulations<Stencil, double> pairs = in_pairs<Stencil>(f);
  collide<Collision, Forcing>(pairs, collision, BodyForce<double>{force, rates.odd});
  return out_of_pairs<Stencil>(pairs);
}

template <class Stencil>
double mass(const std::array<double, Stencil::size>& f) {
  double sum = 0;
  for (const double value : f) sum += value;
  return sum;
}

template <class Stencil>
Vec3<double> momentum(const std::array<double, Stencil::size>& f) {
  Vec3<double> sum{};
  for (std::size_t i = 0; i < Stencil::size; ++i) {
    const auto& c = Stencil::velocity[i];
    sum += f[i] * Vec3<double>{double(c[0]), double(c[1]), double(c[2])};
  }
  return sum;
}

inline const std::vector<double> relaxation_times{0.51, 0.6, 1, 3};

}  // namespace stresslet::testing
