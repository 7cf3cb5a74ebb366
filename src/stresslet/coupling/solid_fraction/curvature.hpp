#pragma once
/// The sphere seen by laws that replace its surface within a cell by a plane, or by a ramp along the normal.
///
/// Such a law gives a cell the fraction P(n.xi < R - |x|), xi a random point of the unit cube about the cell centre x,
/// n = x/|x|. Averaged over the position of the sphere relative to the grid, the fractions then add up to
///   integral of 4 pi s^2 P(n.xi < R - s) ds = 4 pi/3 <(R - n.xi)^3> = 4 pi/3 (R^3 + R/4),
/// because n.xi has variance 1/12 for every n. With R = r - 1/(12 r) this is 4 pi/3 (r^3 - 1/(1728 r^3)): the volume is
/// right, where R = r makes the sphere too large by the fraction 1/(4 r^2). Lengths in cells; radius r > sqrt(3)/2.
#include "stresslet/base/value.hpp"

namespace stresslet {

template <class R>
R curvature_corrected(const R& radius) {
  return radius - as<R>(1.0 / 12) / radius;
}

}  // namespace stresslet
