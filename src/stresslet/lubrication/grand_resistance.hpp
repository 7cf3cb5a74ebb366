#pragma once
/// Full grand-resistance form with its strain terms, singular functions only.
///
/// For particle a of a pair in v = v0 + Omega x x + E.x (Najuch 2018, app. B, corrected; docs/theory.md):
///   F_a = sum_b [ X^A_ab ee.V_b + Y^A_ab (1-ee).V_b + Y^B_ba e x W_b ]
///       + sum_b [ X^G_ba E_nn e + 2 Y^G_ba (E.e - E_nn e) ]
///   T_a = sum_b [ Y^B_ab V_b x e + Y^C_ab (1-ee).W_b ] - 2 sum_b Y^H_ba (E.e) x e
/// with V_b, W_b the fluid's velocity and rotation at particle b minus the particle's. By the sum rules of the
/// singular functions this equals the Rayleigh form with arm a1 + a2 acting on the relative velocity minus
/// gap (E.e + Omega x e), the velocity difference of the undisturbed fluid across the gap. The kernel uses that form;
/// tests compare it with the sums above, which `grand_resistance_reference.hpp` holds term by term.
#include <string_view>

#include "stresslet/lubrication/complete.hpp"

namespace stresslet {

struct GrandResistance {
  static constexpr std::string_view name = "grand-resistance";
  static constexpr std::string_view summary = "full pairwise grand-resistance form with strain terms";
  static constexpr bool sees_background = true;

  template <class R>
  static PairResistance<R> resistance(const R& a1, const R& a2, const R& gap) {
    return Complete::resistance(a1, a2, gap);
  }

  template <class R>
  static R arm(const R& a1, const R& a2, const R&) {
    return a1 + a2;
  }
};

}  // namespace stresslet
