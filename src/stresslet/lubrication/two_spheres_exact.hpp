#pragma once
/// Resistance of two spheres in unbounded Stokes flow at any gap and size ratio: what lubrication laws and sub-grid
/// corrections are judged by. Slow (a dense system for each pair), for tests and calibration.
///
/// Force F and torque T by the fluid on spheres 1 and 2 that move with U, w; e from 1 to 2; per unit viscosity:
///   F_a = - sum_b [ X^A_ab ee.U_b + Y^A_ab (1-ee).U_b + Y^B_ba e x w_b ]
///   T_a = - sum_b [ Y^B_ab U_b x e + X^C_ab ee.w_b + Y^C_ab (1-ee).w_b ]
/// The functions are those of Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261, times 6 pi a1 (A_11), 3 pi (a1 + a2)
/// (A_12), 4 pi a1^2 (B_11), pi (a1 + a2)^2 (B_12), 8 pi a1^3 (C_11), pi (a1 + a2)^3 (C_12). Their recursions are the
/// expansion, in powers of a/R, of a linear system for the multipoles p_n, v_n, q_n of both spheres; the system itself
/// is solved here, with as many multipoles as the tolerance asks for, so no near-contact form enters.
#include <Eigen/Dense>

#include "stresslet/base/vec3.hpp"

namespace stresslet {

/// Index 0: 11, 1: 12, 2: 21, 3: 22; per unit viscosity.
struct TwoSphereResistance {
  std::array<double, 4> XA, YA, YB, XC, YC;
};

/// `tolerance`: relative change of the largest function of each kind when the number of multipoles grows by a half.
TwoSphereResistance exact_two_spheres(double a1, double a2, double gap, double tolerance = 1e-6);

/// R with (F1, T1, F2, T2) = -R (U1, w1, U2, w2); symmetric.
Eigen::Matrix<double, 12, 12> resistance_matrix(const TwoSphereResistance& functions, const Vec3<double>& e);

}  // namespace stresslet
