#pragma once
/// Two relaxation times: Ginzburg, Verhaeghe & d'Humieres, Commun. Comput. Phys. 3 (2008) 427. Even populations relax
/// with 1/tau, which sets the viscosity (tau - 1/2)/3; odd ones with the rate that makes
///   Lambda = (tau - 1/2)(tau_odd - 1/2)
/// the chosen magic parameter. Steady Stokes flow then depends on tau through the viscosity alone. 3/16 puts a half-way
/// wall exactly half-way for Poiseuille flow; 1/12 cancels the third-order error of advection and serves partially
/// saturated cells best; 1/4 is the most stable. Bulk viscosity 2/3 of the shear viscosity (in three dimensions).
#include "stresslet/lattice/collision/bgk.hpp"

namespace stresslet {

struct Trt {
  static constexpr std::string_view name = "TRT";
  static constexpr std::string_view summary = "two relaxation times, walls where they belong at any viscosity";

  static RelaxationRates rates(const CollisionInput& input) {
    const double even = 1 / input.relaxation_time;
    return {even, even, even, odd_rate(input.relaxation_time, input.magic_parameter)};
  }

  template <class Stencil, class R>
  struct Cell {
    static constexpr bool whole_cell = false;
    R even, odd;
    explicit Cell(const RelaxationRates& r) : even(as<R>(r.shear)), odd(as<R>(r.odd)) {}
    [[gnu::always_inline]] R rest(const R& g) const { return even * g; }
    template <int i>
    [[gnu::always_inline]] EvenOdd<R> pair(const EvenOdd<R>& g) const {
      return {even * g.even, odd * g.odd};
    }
  };
};

}  // namespace stresslet
