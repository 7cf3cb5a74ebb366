#pragma once
/// The flows that a fluid can start with, as laws: closed forms of velocity, pressure and velocity gradient.
///
/// | state       | velocity                                                        | pressure over density        |
/// |-------------|-----------------------------------------------------------------|------------------------------|
/// | rest        | 0                                                               | 0                            |
/// | linear      | between the velocities of the faces y_low and y_high, or the mean flow of the sheared box | 0  |
/// | shear-wave  | A t sin(k.x), t = (ky, -kx, 0)/|(kx, ky)|, or along x if both are 0 | 0                        |
/// | taylor-green| A (-cos kx x sin ky y, (kx/ky) sin kx x cos ky y, 0)            | -A^2/4 (cos 2 kx x + (kx/ky)^2 cos
/// 2 ky y) |
///
/// k = 2 pi waves / box length. Taylor & Green, Proc. R. Soc. A 158 (1937) 499, in two dimensions.
#include <cmath>
#include <string_view>

#include "stresslet/base/type_list.hpp"
#include "stresslet/base/vec3.hpp"

namespace stresslet {

struct InitialFlow {
  Vec3<double> velocity{};
  double pressure = 0;
  SymTensor3<double> strain_rate{};
};

/// What the laws read; any consistent units, pressure per density.
struct InitialParameters {
  double amplitude = 0;
  Vec3<double> wave_vector{};
  Vec3<double> low_velocity{}, high_velocity{};  ///< at y = 0 and y = height
  double height = 1;
};

struct Rest {
  static constexpr std::string_view name = "rest";
  static constexpr std::string_view summary = "no motion";
  static constexpr bool is_disturbance = false;  ///< added to the mean flow of a sheared box
  static InitialFlow at(const Vec3<double>&, const InitialParameters&) { return {}; }
};

struct Linear {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view summary = "linear between the faces across y, or the mean flow of the sheared box";
  static constexpr bool is_disturbance = false;
  static InitialFlow at(const Vec3<double>& x, const InitialParameters& p) {
    const Vec3<double> slope = (1 / p.height) * (p.high_velocity - p.low_velocity);
    InitialFlow flow;
    flow.velocity = p.low_velocity + x.y * slope;
    flow.strain_rate = {0, slope.y, 0, 0.5 * slope.x, 0, 0.5 * slope.z};
    return flow;
  }
};

struct ShearWave {
  static constexpr std::string_view name = "shear-wave";
  static constexpr std::string_view summary = "a transverse wave";
  static constexpr bool is_disturbance = true;
  static InitialFlow at(const Vec3<double>& x, const InitialParameters& p) {
    const Vec3<double>& k = p.wave_vector;
    const double across = std::hypot(k.x, k.y);
    const Vec3<double> t = across > 0 ? Vec3<double>{k.y / across, -k.x / across, 0} : Vec3<double>{1, 0, 0};
    InitialFlow flow;
    flow.velocity = p.amplitude * std::sin(dot(k, x)) * t;
    flow.strain_rate = p.amplitude * std::cos(dot(k, x)) * symmetric_product(k, t);
    return flow;
  }
};

struct TaylorGreen {
  static constexpr std::string_view name = "taylor-green";
  static constexpr std::string_view summary = "decaying vortices in the plane of x and y";
  static constexpr bool is_disturbance = true;
  static InitialFlow at(const Vec3<double>& x, const InitialParameters& p) {
    const double kx = p.wave_vector.x, ky = p.wave_vector.y, a = p.amplitude, ratio = kx / ky;
    const double cx = std::cos(kx * x.x), sx = std::sin(kx * x.x), cy = std::cos(ky * x.y), sy = std::sin(ky * x.y);
    InitialFlow flow;
    flow.velocity = {-a * cx * sy, a * ratio * sx * cy, 0};
    flow.pressure = -a * a / 4 * (std::cos(2 * kx * x.x) + ratio * ratio * std::cos(2 * ky * x.y));
    flow.strain_rate.xx = a * kx * sx * sy;
    flow.strain_rate.yy = -flow.strain_rate.xx;
    flow.strain_rate.xy = 0.5 * a * (kx * ratio - ky) * cx * cy;
    return flow;
  }
};

using InitialFields = TypeList<Rest, Linear, ShearWave, TaylorGreen>;

}  // namespace stresslet
