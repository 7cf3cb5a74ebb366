#pragma once
/// The grand-resistance sums of `grand_resistance.hpp`, term by term and for one particle at a time: the slow
/// reference that judges the kernel's form.
#include "stresslet/base/constants.hpp"
#include "stresslet/base/vec3.hpp"
#include "stresslet/lubrication/resistance_functions.hpp"

namespace stresslet {

/// Background flow and motion of a pair; e points from sphere 1 to sphere 2, index 0 is sphere 1.
struct PairInFlow {
  Vec3<double> e;
  double radius[2];
  double gap;
  Vec3<double> fluid_minus_velocity[2];  ///< V_b
  Vec3<double> fluid_minus_rotation[2];  ///< W_b
  SymTensor3<double> strain_rate;        ///< E
};

/// Force and torque per unit viscosity on one sphere, by origin: squeezing, sliding, spin and strain of the fluid.
struct GrandResistanceTerms {
  Vec3<double> force_normal, force_tangential, force_rotational, force_strain, torque, torque_strain;
  Vec3<double> force() const { return force_normal + force_tangential + force_rotational + force_strain; }
  Vec3<double> total_torque() const { return torque + torque_strain; }
};

/// Dimensional singular functions f_ab per unit viscosity; a, b in {0, 1}.
class DimensionalResistance {
 public:
  DimensionalResistance(double a1, double a2, double gap) : a_{a1, a2}, xi_(2 * gap / (a1 + a2)) {}

  double XA(int a, int b) const { return force_like(a, b, resistance::XA11<double>, resistance::XA12<double>); }
  double YA(int a, int b) const { return force_like(a, b, resistance::YA11<double>, resistance::YA12<double>); }
  double YB(int a, int b) const { return torque_like(a, b, resistance::YB11<double>, resistance::YB12<double>); }
  double XG(int a, int b) const { return torque_like(a, b, resistance::XG11<double>, resistance::XG12<double>); }
  double YG(int a, int b) const { return torque_like(a, b, resistance::YG11<double>, resistance::YG12<double>); }
  double YC(int a, int b) const { return spin_like(a, b, resistance::YC11<double>, resistance::YC12<double>); }
  double YH(int a, int b) const { return spin_like(a, b, resistance::YH11<double>, resistance::YH12<double>); }

 private:
  using Function = double (*)(const double&, const resistance::Singular<double>&);
  double lambda(int a) const { return a_[1 - a] / a_[a]; }
  double value(int a, int b, Function self, Function other) const {
    const auto s = resistance::singular(xi_);
    return a == b ? self(lambda(a), s) : other(lambda(a), s);
  }
  double force_like(int a, int b, Function self, Function other) const {
    return (a == b ? 6 * pi * a_[a] : 3 * pi * (a_[0] + a_[1])) * value(a, b, self, other);
  }
  /// Odd under exchange of the spheres, because e keeps pointing from 1 to 2.
  double torque_like(int a, int b, Function self, Function other) const {
    const double sum = a_[0] + a_[1];
    return (a == 0 ? 1 : -1) * (a == b ? 4 * pi * a_[a] * a_[a] : pi * sum * sum) * value(a, b, self, other);
  }
  double spin_like(int a, int b, Function self, Function other) const {
    const double sum = a_[0] + a_[1];
    return (a == b ? 8 * pi * a_[a] * a_[a] * a_[a] : pi * sum * sum * sum) * value(a, b, self, other);
  }

  double a_[2];
  double xi_;
};

inline GrandResistanceTerms grand_resistance_terms(const PairInFlow& p, int a) {
  const DimensionalResistance f(p.radius[0], p.radius[1], p.gap);
  const Vec3<double> strain_e = p.strain_rate * p.e;
  const double strain_nn = dot(strain_e, p.e);
  GrandResistanceTerms t{};
  for (int b : {0, 1}) {
    const Vec3<double>& V = p.fluid_minus_velocity[b];
    const Vec3<double>& W = p.fluid_minus_rotation[b];
    t.force_normal += f.XA(a, b) * dot(p.e, V) * p.e;
    t.force_tangential += f.YA(a, b) * tangential_part(V, p.e);
    t.force_rotational += f.YB(b, a) * cross(p.e, W);
    t.force_strain += f.XG(b, a) * strain_nn * p.e + 2 * f.YG(b, a) * (strain_e - strain_nn * p.e);
    t.torque += f.YB(a, b) * cross(V, p.e) + f.YC(a, b) * tangential_part(W, p.e);
    t.torque_strain -= 2 * f.YH(b, a) * cross(strain_e, p.e);
  }
  return t;
}

}  // namespace stresslet
