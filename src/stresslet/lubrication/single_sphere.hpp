#pragma once
/// An isolated sphere in a linear flow, Stokes limit: drag 6 pi eta a, torque 8 pi eta a^3 (Stokes 1851; Kirchhoff
/// 1876) and stresslet 20/3 pi eta a^3 E (Einstein 1906; Batchelor 1970), which adds 5 phi eta E to the stress.
#include "stresslet/base/constants.hpp"

namespace stresslet {

/// Drag force per unit viscosity and velocity.
template <class R>
R translational_drag(const R& a) {
  return R(6 * pi) * a;
}

/// Drag torque per unit viscosity and angular velocity.
template <class R>
R rotational_drag(const R& a) {
  return R(8 * pi) * a * a * a;
}

/// Stresslet per unit viscosity and rate of strain, tension positive.
template <class R>
R stresslet_coefficient(const R& a) {
  return R(20 * pi / 3) * a * a * a;
}

}  // namespace stresslet
