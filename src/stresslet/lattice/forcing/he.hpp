#pragma once
/// He, Shan & Doolen, Phys. Rev. E 57 (1998) R13, with the half-force velocity of He, Chen & Doolen, J. Comput. Phys.
/// 146 (1998) 282:  Phi_i = 3 F.(c - u) feq_i(u) / rho,   f' = f - Lambda (f - feq(u)) + (1 - Lambda/2) Phi.
/// Guo's up to third order: momentum flux off by -3 (tau - 1/2)(u.F) u u, which shows in fast flow only.
#include "stresslet/lattice/forcing/no_force.hpp"

namespace stresslet {

template <class Stencil, class R>
class HeCell {
 public:
  static constexpr bool adds = true;
  HeCell(const Moments<R>& m, const BodyForce<R>& force)
      : equilibrium_(m.density_deviation, (m.momentum + as<R>(0.5) * force.density) / m.density()),
        acceleration_(as<R>(3) * force.density / m.density()),
        acceleration_velocity_(dot(acceleration_, equilibrium_.velocity())) {}

  [[gnu::always_inline]] R rest_added() const {
    return -acceleration_velocity_ * (as<R>(Stencil::weight[0]) + equilibrium_.rest());
  }
  [[gnu::always_inline]] R rest_target() const { return equilibrium_.rest() - as<R>(0.5) * rest_added(); }

  template <int i>
  [[gnu::always_inline]] EvenOdd<R> added() const {
    return source<i>(equilibrium_.template pair<i>());
  }
  template <int i>
  [[gnu::always_inline]] EvenOdd<R> target() const {
    const auto eq = equilibrium_.template pair<i>();
    const auto phi = source<i>(eq);
    return {eq.even - as<R>(0.5) * phi.even, eq.odd - as<R>(0.5) * phi.odd};
  }

 private:
  template <int i>
  EvenOdd<R> source(const EvenOdd<R>& equilibrium_deviation) const {
    const R even = equilibrium_deviation.even + as<R>(2 * Stencil::weight[i]), odd = equilibrium_deviation.odd;
    const R ca = along<Stencil, i>(acceleration_);
    return {ca * odd - acceleration_velocity_ * even, ca * even - acceleration_velocity_ * odd};
  }

  Equilibrium<Stencil, R> equilibrium_;
  Vec3<R> acceleration_;
  R acceleration_velocity_;
};

struct He {
  static constexpr std::string_view name = "he";
  static constexpr std::string_view summary = "He, Shan & Doolen 1998: force along the equilibrium";
  template <class Stencil, class R>
  using Cell = HeCell<Stencil, R>;
};

}  // namespace stresslet
