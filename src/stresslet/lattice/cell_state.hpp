#pragma once
/// From populations to density, velocity and strain rate, and back.
///
/// Departures from equilibrium carry the viscous stress: with g = f - target of the forcing law, relaxed with the shear
/// and bulk rates,  sum g c_a c_b = -(2 rho/3) S_ab / rate  (deviator with the shear rate, trace with the bulk rate),
/// to second order (Chapman & Enskog; Krueger et al., The Lattice Boltzmann Method (2017), section 4.1).
#include "stresslet/lattice/fluid.hpp"
#include "stresslet/lattice/forcing/no_force.hpp"

namespace stresslet {

template <int dimensions>
SymTensor3<double> with_separate_trace(const SymTensor3<double>& s, double deviator_factor, double trace_factor) {
  const double mean = trace(s) / dimensions;
  SymTensor3<double> isotropic{mean, mean, dimensions == 3 ? mean : 0, 0, 0, 0};
  return deviator_factor * (s - isotropic) + trace_factor * isotropic;
}

/// The cell whose target the strain rate is read against: the law's own, or its `Reading`.
template <class Forcing, class Stencil>
struct ReadingCell {
  using type = typename Forcing::template Cell<Stencil, double>;
};
template <class Forcing, class Stencil>
requires requires { typename Forcing::template Reading<Stencil, double>; }
struct ReadingCell<Forcing, Stencil> {
  using type = typename Forcing::template Reading<Stencil, double>;
};

template <class Stencil, class Forcing>
CellState state_of(const CellPopulations<Stencil, double>& f, const RelaxationRates& rates,
                   const BodyForce<double>& force) {
  const Moments<double> m = moments_of(f);
  const typename ReadingCell<Forcing, Stencil>::type forcing(m, force);
  CellPopulations<Stencil, double> g;
  g.rest = f.rest - forcing.rest_target();
  unroll<Stencil::pairs>([&](auto k) {
    const EvenOdd<double> target = forcing.template target<first_of_pair(k)>();
    g.pair[k] = {f.pair[k].even - target.even, f.pair[k].odd - target.odd};
  });
  const double density = m.density();
  return {density, (m.momentum + 0.5 * force.density) / density,
          with_separate_trace<Stencil::dimensions>(second_moment(g), -1.5 * rates.shear / density,
                                                   -1.5 * rates.bulk / density)};
}

/// Populations with this density, velocity and strain rate. `velocity` counts half the body force.
template <class Stencil>
std::array<double, Stencil::size> populations_of(const CellState& state, const RelaxationRates& rates,
                                                 const BodyForce<double>& force) {
  std::array<double, Stencil::size> f;
  const Vec3<double> u = state.velocity - (0.5 / state.density) * force.density;
  const Equilibrium<Stencil, double> equilibrium(state.density - 1, u);
  const double weight = -(2.0 / 3.0) * state.density;
  const SymTensor3<double> stress =
      with_separate_trace<Stencil::dimensions>(state.strain_rate, weight / rates.shear, weight / rates.bulk);
  f[0] = equilibrium.rest() - 1.5 * Stencil::weight[0] * trace(stress);
  unroll<Stencil::pairs>([&](auto k) {
    constexpr int i = first_of_pair(k);
    constexpr auto c = Stencil::velocity[i];
    const Vec3<double> direction{double(c[0]), double(c[1]), double(c[2])};
    const double even = Stencil::weight[i] * (9 * dot(direction, stress * direction) - 3 * trace(stress));
    const EvenOdd<double> eq = equilibrium.template pair<i>();
    f[i] = 0.5 * (eq.even + even + eq.odd);
    f[i + 1] = 0.5 * (eq.even + even - eq.odd);
  });
  return f;
}

}  // namespace stresslet
