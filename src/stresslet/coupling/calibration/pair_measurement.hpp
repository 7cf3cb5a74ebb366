#pragma once
/// Resistance of two resolved spheres as the grid gives it, without any sub-grid correction, beside the exact one.
///
/// The spheres move at prescribed velocities without displacement in a periodic cube until the flow is steady. Motions
/// (e from sphere 1 to 2, t across, b = e x t):
///   squeeze   u = U2 - U1 along e
///   slide     u along t
///   roll      w1 = w2 along b
///   spin      w1 = -w2 along b
/// each with the translation of both at which the exact forces add up to zero: the flow of such a motion decays as
/// 1/r^2 and the images matter as (d/L)^3. That share is taken off by periodic_images.hpp from the measured first
/// moments; what the exact force balance leaves (mean flow, net force) is taken into the exact side.
///
/// The resistance matrix P_ab = -sum (F_b . U_a + T_b . w_a), forces and torques of motion b, velocities of motion a,
/// is symmetric; its entries are what corrections add to.
#include <array>
#include <string>
#include <vector>

#include "stresslet/coupling/resolved_fluid.hpp"

namespace stresslet {

/// What fixes the errors of the grid, and so the correction.
struct PairScheme {
  std::string coupling_operator = "superposition", solid_fraction = "plane-cut", weight = "viscosity-scaled",
              collision = "TRT";
  double relaxation_time = 1, magic_parameter = 1.0 / 12;
};

struct PairPlacement {
  double radius1 = 5, radius2 = 5, gap = 1;  ///< cells
  Vec3<double> direction{1, 0, 0};           ///< from 1 to 2; any length
  Vec3<double> across{0, 1, 0};              ///< of sliding; its part along `direction` is taken off
  Vec3<double> offset{};                     ///< of the middle of the gap from the centre of a cell
  int edge = 50;                             ///< of the periodic cube
};

enum class PairMotionKind { squeeze, slide, roll, spin };
inline constexpr std::array<const char*, 4> pair_motion_names{"squeeze", "slide", "roll", "spin"};

struct PairMeasurement {
  PairPlacement placement;
  double viscosity = 0;                 ///< of the lattice
  Eigen::Matrix<double, 12, 4> motion;  ///< velocities (U1, w1, U2, w2) of each kind, for law corrections
  Eigen::Matrix4d measured, exact;      ///< P, images taken off; only rows and columns of `kinds` are set
  Eigen::Matrix4d images;               ///< what was taken off
  std::array<int, 4> steps{};           ///< until steady
};

/// `tolerance`: relative change of P_aa over an eighth of the time L^2/(4 pi^2 nu) at which the run ends.
PairMeasurement measure_pair(const PairScheme& scheme, const PairPlacement& placement,
                             const std::vector<PairMotionKind>& kinds, ThreadTeam& team, double tolerance = 2e-4);

}  // namespace stresslet
