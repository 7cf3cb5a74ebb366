#pragma once
/// Near-contact two-sphere resistance functions in unbounded Stokes flow: the singular parts, O(1/xi) and
/// O(ln 1/xi), of the dimensionless functions of Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261 (XA ... YC) and
/// Jeffrey, Phys. Fluids A 4 (1992) 16 (XG, YG, YH).
///
///   lambda = a2 / a1,  xi = 2 gap / (a1 + a2),  L = ln(1/xi) > 0, so xi < 1 is required.
///
/// Normalisation: A by 6 pi a1, B and G by 4 pi a1^2, C and H by 8 pi a1^3 for the 11 functions; the 12 functions
/// by the same with a1 -> (a1 + a2)/2. Neglected: O(1) constants and O(xi ln xi). X^C has no singular part.
#include "stresslet/exec/simd.hpp"

namespace stresslet::resistance {

/// The two singular factors of every function.
template <class R>
struct Singular {
  R inverse_gap;  ///< 1/xi
  R logarithm;    ///< ln(1/xi)
};

template <class R>
Singular<R> singular(const R& xi) {
  return {R(1) / xi, -natural_log(xi)};
}

template <class R>
R cube(const R& v) {
  return v * v * v;
}

template <class R>
R XA11(const R& l, const Singular<R>& s) {
  return (R(2) * l * l * s.inverse_gap + R(0.2) * l * (R(1) + R(7) * l + l * l) * s.logarithm) / cube(R(1) + l);
}
template <class R>
R YA11(const R& l, const Singular<R>& s) {
  return R(4.0 / 15) * l * (R(2) + l + R(2) * l * l) / cube(R(1) + l) * s.logarithm;
}
template <class R>
R YB11(const R& l, const Singular<R>& s) {
  const R m = R(1) + l;
  return R(-0.2) * l * (R(4) + l) / (m * m) * s.logarithm;
}
template <class R>
R YC11(const R& l, const Singular<R>& s) {
  return R(0.4) * l / (R(1) + l) * s.logarithm;
}
template <class R>
R XG11(const R& l, const Singular<R>& s) {
  return (R(3) * l * l * s.inverse_gap + R(0.3) * l * (R(1) + R(12) * l - R(4) * l * l) * s.logarithm) / cube(R(1) + l);
}
template <class R>
R YG11(const R& l, const Singular<R>& s) {
  return R(0.1) * l * (R(4) - l + R(7) * l * l) / cube(R(1) + l) * s.logarithm;
}
template <class R>
R YH11(const R& l, const Singular<R>& s) {
  const R m = R(1) + l;
  return R(0.1) * l * (R(2) - l) / (m * m) * s.logarithm;
}

template <class R>
R XA12(const R& l, const Singular<R>& s) {
  return R(-2) / (R(1) + l) * XA11(l, s);
}
template <class R>
R YA12(const R& l, const Singular<R>& s) {
  return R(-2) / (R(1) + l) * YA11(l, s);
}
template <class R>
R YB12(const R& l, const Singular<R>& s) {
  const R m = R(1) + l;
  return R(-4) / (m * m) * YB11(l, s);
}
template <class R>
R YC12(const R& l, const Singular<R>& s) {
  const R m = R(1) + l;
  return R(0.8) * l * l / (m * m * m * m) * s.logarithm;
}
template <class R>
R XG12(const R& l, const Singular<R>& s) {
  const R m = R(1) + l;
  return R(-4) / (m * m) * XG11(l, s);
}
template <class R>
R YG12(const R& l, const Singular<R>& s) {
  const R m = R(1) + l;
  return R(-4) / (m * m) * YG11(l, s);
}
template <class R>
R YH12(const R& l, const Singular<R>& s) {
  const R m = R(1) + l;
  return R(0.4) * l * l * (R(1) + R(7) * l) / (m * m * m * m * m) * s.logarithm;
}

}  // namespace stresslet::resistance
