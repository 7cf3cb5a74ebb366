#pragma once
/// One relaxation time: Bhatnagar, Gross & Krook; Qian, d'Humieres & Lallemand, Europhys. Lett. 17 (1992) 479.
///   f' = f - (f - feq)/tau,   kinematic viscosity (tau - 1/2)/3,   bulk viscosity 2/3 of it (in three dimensions).
/// The place of a half-way wall depends on tau: exact for Poiseuille flow only at tau = 1/2 + sqrt(3)/4.
///
/// A collision law turns rates and the departures g = f - target of all populations into what is taken from them,
/// `rest(g)` and `pair<i>(g)`. `whole_cell` says that it looks at all departures first (`prepare`).
#include <string_view>

#include "stresslet/lattice/collision/rates.hpp"
#include "stresslet/lattice/moments.hpp"

namespace stresslet {

struct Bgk {
  static constexpr std::string_view name = "BGK";
  static constexpr std::string_view summary = "one relaxation time";

  static RelaxationRates rates(const CollisionInput& input) {
    const double rate = 1 / input.relaxation_time;
    return {rate, rate, rate, rate};
  }

  template <class Stencil, class R>
  struct Cell {
    static constexpr bool whole_cell = false;
    R rate;
    explicit Cell(const RelaxationRates& r) : rate(as<R>(r.shear)) {}
    [[gnu::always_inline]] R rest(const R& g) const { return rate * g; }
    template <int i>
    [[gnu::always_inline]] EvenOdd<R> pair(const EvenOdd<R>& g) const {
      return {rate * g.even, rate * g.odd};
    }
  };
};

}  // namespace stresslet
