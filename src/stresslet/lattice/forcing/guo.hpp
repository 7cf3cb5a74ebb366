#pragma once
/// Guo, Zheng & Shi, Phys. Rev. E 65 (2002) 046308, eqs. 16-20, for any relaxation operator Lambda:
///   u = (sum f c + F/2)/rho,   Phi_i = w_i [3 (c - u).F + 9 (c.u)(c.F)],
///   f' = f - Lambda (f - feq(u)) + (1 - Lambda/2) Phi.
/// Second order in space and time; no error terms in the Navier-Stokes equations, for forces that vary too.
#include "stresslet/lattice/forcing/no_force.hpp"

namespace stresslet {

template <class Stencil, class R>
class GuoCell {
 public:
  static constexpr bool adds = true;
  GuoCell(const Moments<R>& m, const BodyForce<R>& force)
      : equilibrium_(m.density_deviation, (m.momentum + as<R>(0.5) * force.density) / m.density()),
        force_(force.density),
        force_velocity_(dot(force_, equilibrium_.velocity())) {}

  [[gnu::always_inline]] R rest_added() const { return as<R>(-3 * Stencil::weight[0]) * force_velocity_; }
  [[gnu::always_inline]] R rest_target() const { return equilibrium_.rest() - as<R>(0.5) * rest_added(); }

  template <int i>
  [[gnu::always_inline]] EvenOdd<R> added() const {
    constexpr double w = Stencil::weight[i];
    const R cu = along<Stencil, i>(equilibrium_.velocity()), cf = along<Stencil, i>(force_);
    return {as<R>(6 * w) * (as<R>(3) * cu * cf - force_velocity_), as<R>(6 * w) * cf};
  }
  template <int i>
  [[gnu::always_inline]] EvenOdd<R> target() const {
    const auto [even, odd] = equilibrium_.template pair<i>();
    const auto [source_even, source_odd] = added<i>();
    return {even - as<R>(0.5) * source_even, odd - as<R>(0.5) * source_odd};
  }

 private:
  Equilibrium<Stencil, R> equilibrium_;
  Vec3<R> force_;
  R force_velocity_;
};

struct Guo {
  static constexpr std::string_view name = "guo";
  static constexpr std::string_view summary = "Guo, Zheng & Shi 2002: second order, no spurious terms";
  template <class Stencil, class R>
  using Cell = GuoCell<Stencil, R>;
};

}  // namespace stresslet
