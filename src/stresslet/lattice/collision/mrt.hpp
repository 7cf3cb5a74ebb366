#pragma once
/// Multiple relaxation times in the Hermite basis (orthogonal under the weights w_i), as in Adhikari & Succi, Phys.
/// Rev. E 78 (2008) 066701. D is the number of dimensions, Pi_ab = sum_i g_i (c_a c_b - delta_ab/3) of g = f - target:
///
///   deviatoric stress   9/2 w_i (c_a c_b - delta_ab |c|^2/D) Pi_ab    1/tau, kinematic viscosity (tau - 1/2)/3
///   trace of stress     9/(2 D) w_i (|c|^2 - D/3) Pi_aa               bulk rate, viscosity (2/D)(1/rate - 1/2)/3
///   other even moments  the rest of the even populations              higher even rate: no hydrodynamic effect
///   odd moments         odd populations                               from the magic parameter, as in TRT
/// Equal even rates make it TRT.
#include "stresslet/lattice/collision/bgk.hpp"

namespace stresslet {

struct Mrt {
  static constexpr std::string_view name = "MRT";
  static constexpr std::string_view summary = "rates of their own for shear, bulk, higher even and odd moments";

  static RelaxationRates rates(const CollisionInput& input) {
    const double shear = 1 / input.relaxation_time;
    return {shear, input.bulk_rate.value_or(shear), input.higher_even_rate.value_or(shear),
            odd_rate(input.relaxation_time, input.magic_parameter)};
  }

  template <class Stencil, class R>
  class Cell {
   public:
    static constexpr bool whole_cell = true;
    explicit Cell(const RelaxationRates& r)
        : higher_(as<R>(r.higher_even)),
          odd_(as<R>(r.odd)),
          deviatoric_weight_(as<R>(4.5 * (r.shear - r.higher_even))),
          trace_weight_(as<R>(4.5 / Stencil::dimensions * (r.bulk - r.higher_even))) {}

    [[gnu::always_inline]] void prepare(const CellPopulations<Stencil, R>& g) {
      R sum = g.rest;
      for (const EvenOdd<R>& pair : g.pair) sum += pair.even;
      stress_ = second_moment(g);
      // The trace over the stencil's dimensions; c.c - D/3 has no part along the density.
      trace_ = stress_.xx + stress_.yy + stress_.zz - as<R>(Stencil::dimensions / 3.0) * sum;
      mean_ = (stress_.xx + stress_.yy + stress_.zz) * as<R>(1.0 / Stencil::dimensions);
    }

    [[gnu::always_inline]] R rest(const R& g) const {
      return higher_ * g + as<R>(Stencil::weight[0]) * trace_part<0>();
    }

    template <int i>
    [[gnu::always_inline]] EvenOdd<R> pair(const EvenOdd<R>& g) const {
      constexpr auto c = Stencil::velocity[i];
      R along_c = as<R>(0);  // c.(Pi - mean).c
      if constexpr (c[0] != 0) along_c += stress_.xx - mean_;
      if constexpr (c[1] != 0) along_c += stress_.yy - mean_;
      if constexpr (c[2] != 0) along_c += stress_.zz - mean_;
      if constexpr (c[0] * c[1] != 0) along_c += as<R>(2 * c[0] * c[1]) * stress_.xy;
      if constexpr (c[0] * c[2] != 0) along_c += as<R>(2 * c[0] * c[2]) * stress_.xz;
      if constexpr (c[1] * c[2] != 0) along_c += as<R>(2 * c[1] * c[2]) * stress_.yz;
      const R stress_part = deviatoric_weight_ * along_c + trace_part<i>();
      return {higher_ * g.even + as<R>(2 * Stencil::weight[i]) * stress_part, odd_ * g.odd};
    }

   private:
    template <int i>
    [[gnu::always_inline]] R trace_part() const {
      constexpr double length = Stencil::squared_length(Stencil::velocity[i]);
      return as<R>(length - Stencil::dimensions / 3.0) * trace_weight_ * trace_;
    }

    R higher_, odd_, deviatoric_weight_, trace_weight_;
    SymTensor3<R> stress_;  // sum g c c
    R trace_, mean_;
  };
};

}  // namespace stresslet
