#pragma once
/// Sets of discrete velocities, made from one rule: of all vectors with components -1, 0, 1 keep those of squared
/// length
/// <= `longest`, weighted by their squared length. Population 0 rests; the others stand in pairs of opposite
/// velocities, (1, 2), (3, 4), ..., the first of each pair with a positive leading component.
///
/// Lattice units: cell 1, time step 1, speed of sound squared 1/3. Weights: Qian, d'Humieres & Lallemand, Europhys.
/// Lett. 17 (1992) 479; the static assertions hold their isotropy conditions up to fourth order.
#include <array>

namespace stresslet {

inline constexpr double speed_of_sound_squared = 1.0 / 3.0;

/// The population that moves against population `i`.
constexpr int opposite(int i) { return i == 0 ? 0 : ((i - 1) ^ 1) + 1; }

/// `weight_of[n]` is the weight of velocities of squared length n.
template <int dimensions_, int longest, int size_>
class VelocitySet {
 public:
  static constexpr int dimensions = dimensions_;
  static constexpr int size = size_;
  static constexpr int pairs = (size - 1) / 2;
  using Velocity = std::array<int, 3>;

  static constexpr std::array<Velocity, size> velocities() {
    std::array<Velocity, size> set{};
    int count = 1;
    for (int length = 1; length <= longest; ++length)
      for (int code = 26; code > 13;
           --code) {  // base-3 digits minus one; 13 is the rest, above it the leading one is 1
        const Velocity c{code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1};
        if (squared_length(c) != length || (dimensions == 2 && c[2] != 0)) continue;
        set[count++] = c;
        set[count++] = {-c[0], -c[1], -c[2]};
      }
    return set;
  }

  static constexpr int squared_length(const Velocity& c) { return c[0] * c[0] + c[1] * c[1] + c[2] * c[2]; }
};

/// Whether the weights of `Stencil` sum to 1, and its second and fourth moments are those of the Maxwell distribution
/// (the fourth up to the component that no velocity of length <= 1 per axis can tell from the second: c^4 = c^2).
template <class Stencil>
constexpr bool is_isotropic() {
  const auto close = [](double a, double b) { return (a > b ? a - b : b - a) < 1e-15; };
  double sum = 0;
  for (int i = 0; i < Stencil::size; ++i) sum += Stencil::weight[i];
  if (!close(sum, 1)) return false;
  for (int a = 0; a < Stencil::dimensions; ++a)
    for (int b = 0; b < Stencil::dimensions; ++b) {
      double second = 0, fourth = 0;
      for (int i = 0; i < Stencil::size; ++i) {
        const auto& c = Stencil::velocity[i];
        second += Stencil::weight[i] * c[a] * c[b];
        fourth += Stencil::weight[i] * c[a] * c[a] * c[b] * c[b];
      }
      if (!close(second, a == b ? 1.0 / 3 : 0) || !close(fourth, a == b ? 1.0 / 3 : 1.0 / 9)) return false;
    }
  return true;
}

}  // namespace stresslet
