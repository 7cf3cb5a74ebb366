#pragma once
/// Lubrication between two spheres in its dissipative (Rayleigh) form.
///
/// Dissipation function of a pair, per unit viscosity:
///   Phi = 1/2 [ X u_n^2 + Y |v_t|^2 + 2 B v_t . (w_d x e) + C |w_d,t|^2 ]
/// with e from sphere 1 to sphere 2, u = u_2 - u_1, v_t = (1 - ee).u - arm w_s x e, w_s = (w_1 + w_2)/2,
/// w_d = (w_1 - w_2)/2. With arm = centre distance, forces and torques balance exactly, a pair in rigid motion
/// feels nothing, and the power is never positive (Y C > B^2). Derived from the singular resistance functions by
/// inserting a linear flow and dropping terms of relative order xi; see docs/theory.md.
#include "stresslet/base/constants.hpp"
#include "stresslet/base/vec3.hpp"
#include "stresslet/exec/simd.hpp"

namespace stresslet {

/// Coefficients of the dissipation function per unit viscosity: X, Y [length], B [length^2], C [length^3].
template <class R>
struct PairResistance {
  R X{}, Y{}, B{}, C{};
};

/// Relative motion of a pair: `u` = velocity of the image of sphere 2 minus that of sphere 1.
template <class R>
struct PairMotion {
  Vec3<R> u, w1, w2;
};

/// What sphere 1 receives is force, T1 = half_sum - half_difference; sphere 2: -force, T2 = half_sum + half_difference.
template <class R>
struct PairWrench {
  Vec3<R> force, half_sum, half_difference;
};

/// The parts of the motion that the resistance acts on.
template <class R>
struct LubricatedMotion {
  R normal;              ///< u . e
  Vec3<R> sliding;       ///< v_t
  Vec3<R> counter_spin;  ///< w_d x e
};

template <class R>
[[gnu::always_inline]] inline LubricatedMotion<R> lubricated_motion(const Vec3<R>& e, const R& arm,
                                                                    const PairMotion<R>& m) {
  const R half(0.5);
  const R normal = dot(m.u, e);
  const Vec3<R> mean_spin = half * (m.w1 + m.w2);
  return {normal, m.u - normal * e - arm * cross(mean_spin, e), cross(half * (m.w1 - m.w2), e)};
}

/// Force and torques per unit viscosity. Rotating w_d x e back by e x gives the tangential part of w_d.
template <class R>
[[gnu::always_inline]] inline PairWrench<R> pair_wrench(const Vec3<R>& e, const R& arm, const PairResistance<R>& k,
                                                        const PairMotion<R>& motion) {
  const LubricatedMotion<R> m = lubricated_motion(e, arm, motion);
  const R half(0.5);
  const Vec3<R> tangential = k.Y * m.sliding + k.B * m.counter_spin;
  const Vec3<R> couple = k.B * m.sliding + k.C * m.counter_spin;
  return {k.X * m.normal * e + tangential, half * arm * cross(e, tangential), half * cross(e, couple)};
}

/// Rate of dissipation per unit viscosity, 2 Phi.
template <class R>
R pair_dissipation(const PairResistance<R>& k, const LubricatedMotion<R>& m) {
  return k.X * m.normal * m.normal + k.Y * dot(m.sliding, m.sliding) + R(2) * k.B * dot(m.sliding, m.counter_spin) +
         k.C * dot(m.counter_spin, m.counter_spin);
}

}  // namespace stresslet
