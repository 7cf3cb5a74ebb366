#pragma once
/// What the grid does not resolve of the film between two spheres, or a sphere and a wall, in the dissipative form of
/// lubrication/pair_law.hpp, per unit viscosity. With F the coefficients of lubrication/complete.hpp (wall.hpp), h the
/// gap in cells, not below the inner gap, and h'(l) the resolved gap of the law:
///   X = F_X(h) - F_X(h'(l_normal)),
///   Y = Y_1 D(l_sliding),  C = C_1 D(l_spin),  B = B_1 sqrt(D(l_sliding) D(l_spin)),     D(l) = ln(h'(l)/h),
/// Y_1, B_1, C_1 the factors of the logarithm; of each X and D, what it is at the end of the range is taken off, so
/// that it goes to zero there without a jump. The mean in B keeps Y C >= B^2 whatever the lengths, so the correction
/// never drives a pair; forces and torques balance and rigid motion feels nothing whatever the coefficients.
///
/// The thesis (ch. 4) corrects five quantities each by its own length: normal force (here l_normal), force of sliding
/// (l_sliding), torque of sliding, force of rotation, torque of rotation (l_spin). Balance leaves three free: of equal
/// spheres the torque of sliding, and force and torque of equal rotation, follow from the force of sliding by the lever
/// R/2, and only opposite rotation has a torque of its own. The force of opposite rotation, and the couple of sliding
/// (B, unequal spheres alone), take the mean.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "stresslet/base/value.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/lubrication/complete.hpp"
#include "stresslet/lubrication/cutoffs.hpp"
#include "stresslet/lubrication/wall.hpp"

namespace stresslet {

/// In cells; 0 leaves a mode without correction.
struct SubgridLengths {
  double normal = 0, sliding = 0, spin = 0;
  friend bool operator==(const SubgridLengths&, const SubgridLengths&) = default;
};

struct SubgridRange {
  double inner = 0.001;  ///< in units of d_eff: below it the correction is constant
  double outer = 3;      ///< cells: zero beyond
};

/// `at(gap)` gives the coefficients of the film, `unit_logarithm` the gap at which its logarithm is 1, `inner_gap` in
/// cells. No branch: beyond the outer gap the coefficients are evaluated and dropped.
template <class Law, class R, class Film>
PairResistance<R> film_correction(const R& gap, const R& unit_logarithm, const R& inner_gap, const R& outer_gap,
                                  const SubgridLengths& lengths, Film&& at) {
  using std::max;
  using std::sqrt;
  const R h = max(gap, inner_gap), zero = as<R>(0);
  const auto missing_normal = [&](const R& g) { return at(g).X - at(Law::resolved_gap(g, R(lengths.normal))).X; };
  const auto missing_logarithm = [&](const R& g, double length) {
    return natural_log(R(Law::resolved_gap(g, R(length)) / g));
  };
  const auto logarithm = [&](double length) {
    return R(max(zero, missing_logarithm(h, length) - missing_logarithm(outer_gap, length)));
  };
  const R sliding = logarithm(lengths.sliding), spin = logarithm(lengths.spin);
  const PairResistance<R> unit = at(unit_logarithm);
  const R normal = max(zero, missing_normal(h) - missing_normal(outer_gap));
  const auto within = gap < outer_gap;
  return {select(within, normal, zero), select(within, unit.Y * sliding, zero),
          select(within, unit.B * sqrt(sliding * spin), zero), select(within, unit.C * spin, zero)};
}

template <class Law, class R>
PairResistance<R> subgrid_resistance(const R& a1, const R& a2, const R& gap, const SubgridLengths& lengths,
                                     const SubgridRange& range) {
  return film_correction<Law>(gap, R(0.5) * (a1 + a2) / R(std::numbers::e), R(range.inner) * effective_diameter(a1, a2),
                              R(range.outer), lengths, [&](const R& h) { return Complete::resistance(a1, a2, h); });
}

template <class Law, class R>
PairResistance<R> subgrid_wall_resistance(const R& a, const R& gap, const SubgridLengths& lengths,
                                          const SubgridRange& range) {
  return film_correction<Law>(gap, a / R(std::numbers::e), R(range.inner) * R(2) * a, R(range.outer), lengths,
                              [&](const R& h) { return wall_resistance(a, h); });
}

}  // namespace stresslet
