#pragma once
/// Range of the pair lubrication, in units of d_eff = d1 d2/(d1 + d2) of the pair: below `inner` the resistance keeps
/// its value at `inner` (surface roughness; also while spheres overlap), above `outer` it is zero (not shifted).

namespace stresslet {

struct LubricationCutoffs {
  double inner = 0.001;
  double outer = 0.05;
};

/// d1 d2 / (d1 + d2); equals the radius for equal spheres.
template <class R>
R effective_diameter(const R& a1, const R& a2) {
  return R(2) * a1 * a2 / (a1 + a2);
}

}  // namespace stresslet
