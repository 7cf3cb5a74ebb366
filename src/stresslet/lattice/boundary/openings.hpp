#pragma once
/// What an opening prescribes on the last layer of cells of a face (the boundary lies on their centres). Known are the
/// populations that move outwards or along the face; with `arrived` = sum along + 2 sum outwards (deviations from
/// rest), mass and normal momentum (inwards) give   momentum_n = density_deviation - arrived,   and one of the two is
/// prescribed (Zou & He, Phys. Fluids 9 (1997) 1591, eqs. 13-17 and 20-24). `momentum` is sum f c, half a body force
/// short of rho u.
#include <string_view>

#include "stresslet/lattice/fluid.hpp"

namespace stresslet {

struct OpeningState {
  double density_deviation;
  Vec3<double> momentum;
};

struct VelocityOpening {
  static constexpr std::string_view name = "velocity";
  static constexpr std::string_view summary = "Zou & He 1997: velocity given, density follows";
  static constexpr bool is_wall = false, regularised = false;

  static OpeningState state(double arrived, const Vec3<double>& inward, const FaceSetup& face,
                            const Vec3<double>& force_density) {
    const double normal_velocity = dot(face.velocity_lu, inward);
    const double deviation = (arrived + normal_velocity - 0.5 * dot(force_density, inward)) / (1 - normal_velocity);
    return {deviation, (1 + deviation) * face.velocity_lu - 0.5 * force_density};
  }
};

struct PressureOpening {
  static constexpr std::string_view name = "pressure";
  static constexpr std::string_view summary = "Zou & He 1997: density and velocity along the face given";
  static constexpr bool is_wall = false, regularised = false;

  static OpeningState state(double arrived, const Vec3<double>& inward, const FaceSetup& face,
                            const Vec3<double>& force_density) {
    const double deviation = face.density_lu - 1;
    const Vec3<double> along = face.density_lu * face.velocity_lu - 0.5 * force_density;
    return {deviation, tangential_part(along, inward) + (deviation - arrived) * inward};
  }
};

struct RegularisedVelocity : VelocityOpening {
  static constexpr std::string_view name = "regularised-velocity";
  static constexpr std::string_view summary = "Latt et al. 2008: as velocity, stable at small relaxation times";
  static constexpr bool regularised = true;
};

struct RegularisedPressure : PressureOpening {
  static constexpr std::string_view name = "regularised-pressure";
  static constexpr std::string_view summary = "Latt et al. 2008: as pressure, stable at small relaxation times";
  static constexpr bool regularised = true;
};

}  // namespace stresslet
