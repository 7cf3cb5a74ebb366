#pragma once
/// One sphere of radius a and a plane wall in Stokes flow, centre at h above the wall.
#include <cmath>

namespace stresslet::validation {

/// F/(6 pi eta a U) of a sphere that moves towards the wall, its gap over a: the series of Brenner, Chem. Eng. Sci. 16
/// (1961) 242.
inline double exact_approach(double gap_over_radius) {
  const double alpha = std::acosh(1 + gap_over_radius);
  double sum = 0;
  for (int n = 1; n < 2000; ++n) {
    const double k = 2 * n + 1, half = std::sinh(0.5 * k * alpha);
    if (k * alpha > 600) break;
    const double term = (2 * std::sinh(k * alpha) + k * std::sinh(2 * alpha)) /
                            (4 * half * half - k * k * std::sinh(alpha) * std::sinh(alpha)) -
                        1;
    sum += n * (n + 1.0) / ((2 * n - 1.0) * (2 * n + 3.0)) * term;
  }
  return 4.0 / 3 * std::sinh(alpha) * sum;
}

struct AlongWall {
  double gap_over_radius;
  double sliding;  ///< F/(6 pi eta a U) of motion along the wall
  double turning;  ///< T/(8 pi eta a^3 w) of rotation about an axis along it
};

/// Thin films, where no series is at hand (Goldman, Cox & Brenner, Chem. Eng. Sci. 22 (1967) 637, recomputed by the
/// method of fundamental solutions).
inline constexpr AlongWall exact_along_wall[] = {{0.05, 2.59896, 1.66746}, {0.1, 2.26430, 1.45485}};

}  // namespace stresslet::validation
