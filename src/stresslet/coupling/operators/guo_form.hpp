#pragma once
/// Superposition as a force: the momentum B rho (us - u*) joins the body force in Guo's form (lattice/forcing/guo.hpp),
/// whatever the forcing law of the fluid. Equals `superposition` to first order in us - u*; the rest is of second
/// order. Writing the force with the mean velocity u instead of u* would only replace B by B/(1 + B/2).
#include <string_view>

#include "stresslet/coupling/covered_cell.hpp"
#include "stresslet/lattice/collide.hpp"
#include "stresslet/lattice/forcing/guo.hpp"

namespace stresslet {

struct GuoForm {
  static constexpr std::string_view name = "guo-form";
  static constexpr std::string_view summary = "the momentum exchange as a body force of Guo's form";
  static constexpr double exchange = 1;
  static constexpr double kinetic_stress_factor = 0;
  static constexpr double largest_weight = 2;
  static constexpr double core_weight = largest_weight;

  template <class Collision, class Forcing, class Populations, class R>
  [[gnu::always_inline]] static Vec3<R> collide(
      Populations& f, typename Collision::template Cell<typename Populations::Stencil, R>& rates,
      const BodyForce<R>& force, const CoveredCell<R>& solid) {
    const Moments<R> m = moments_of(f);
    const Vec3<R> given = solid.weight * (m.density() * solid.velocity - m.momentum - as<R>(0.5) * force.density);
    stresslet::collide<Collision, Guo>(f, rates, BodyForce<R>{force.density + given, force.odd_rate});
    return given;
  }
};

}  // namespace stresslet
