#pragma once
/// Velocity shift of Shan & Chen, Phys. Rev. E 47 (1993) 1815, eq. 9:  f' = f - Lambda (f - feq(v + tau_- F/rho)),
/// v = sum f c / rho, 1/tau_- the rate of odd populations (BGK: tau). Momentum flux off by (tau_- - tau)(u F + F u) +
/// [(tau_- - tau)^2 + (tau - 1/2)^2] F F / rho, which grows with tau. For comparison with published work.
#include "stresslet/lattice/forcing/no_force.hpp"

namespace stresslet {

template <class Stencil, class R>
class VelocityShiftCell {
 public:
  static constexpr bool adds = false;
  VelocityShiftCell(const Moments<R>& m, const BodyForce<R>& force)
      : equilibrium_(m.density_deviation, (m.momentum + force.density / force.odd_rate) / m.density()) {}

  [[gnu::always_inline]] R rest_target() const { return equilibrium_.rest(); }
  template <int i>
  [[gnu::always_inline]] EvenOdd<R> target() const {
    return equilibrium_.template pair<i>();
  }

 private:
  Equilibrium<Stencil, R> equilibrium_;
};

struct VelocityShift {
  static constexpr std::string_view name = "velocity-shift";
  static constexpr std::string_view summary = "Shan & Chen 1993: equilibrium velocity shifted by tau F / rho";
  template <class Stencil, class R>
  using Cell = VelocityShiftCell<Stencil, R>;
  /// The target is off by tau (v F + F v), which would pass for a strain rate of 3 u F in fluid that speeds up as a
  /// whole.
  template <class Stencil, class R>
  using Reading = NoForceCell<Stencil, R>;
};

}  // namespace stresslet
