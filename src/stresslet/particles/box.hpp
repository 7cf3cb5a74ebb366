#pragma once
/// The box: periodic in x and z, and across y periodic, sheared periodic (Lees-Edwards) or closed by flat walls.
///
/// Positions lie in [0, length). Mean flow u_x = shear_rate (y - length.y / 2). In the sheared box the image above is
/// displaced by `offset` = shear_rate length.y t mod length.x and moves by `shear_rate length.y` faster
/// (Lees & Edwards 1972). Flat walls at y = 0 and y = length.y move with the mean flow there.
#include <cmath>
#include <string_view>

#include "stresslet/base/vec3.hpp"

namespace stresslet {

enum class BoxKind { lees_edwards, periodic, walls };

/// Separation of two particles by the nearest image, and how many boxes up in y that image lies.
template <class R>
struct Separation {
  Vec3<R> r;
  R images_up;
};

struct Box {
  BoxKind kind = BoxKind::lees_edwards;
  Vec3<double> length{1, 1, 1};
  double shear_rate = 0;
  double offset = 0;
  double offset_rest = 0;  ///< what rounding has kept out of `offset`; equal steps would add up its error

  double volume() const { return length.x * length.y * length.z; }
  bool periodic_in_y() const { return kind != BoxKind::walls; }
  /// Velocity jump of the image above, zero unless sheared.
  double velocity_jump() const { return kind == BoxKind::lees_edwards ? shear_rate * length.y : 0.0; }
  double mean_flow(double y) const { return kind == BoxKind::periodic ? 0.0 : shear_rate * (y - 0.5 * length.y); }
  /// du_x/dy of the mean flow.
  double mean_gradient() const { return kind == BoxKind::periodic ? 0.0 : shear_rate; }

  /// Nearest image of `d` = position of j - position of i. The relative velocity u_j - u_i of that image is
  /// (U_j - U_i) - images_up velocity_jump in x. Exact while cut-offs stay below half the shortest box length.
  template <class R>
  Separation<R> nearest_image(Vec3<R> d) const {
    using std::nearbyint;
    const R n = periodic_in_y() ? R(nearbyint(d.y * R(1 / length.y))) : R(0);
    d.y = d.y - n * R(length.y);
    d.x = d.x - n * R(offset);
    d.x = d.x - R(length.x) * nearbyint(d.x * R(1 / length.x));
    d.z = d.z - R(length.z) * nearbyint(d.z * R(1 / length.z));
    return {d, n};
  }

  /// Brings a particle back into the box; its velocity changes with the image it leaves through.
  void wrap(Vec3<double>& position, double& velocity_x) const {
    if (periodic_in_y()) {
      const double n = std::floor(position.y / length.y);
      if (n != 0) {
        position.y -= n * length.y;
        position.x -= n * offset;
        velocity_x -= n * velocity_jump();
      }
    }
    position.x = into_period(position.x, length.x);
    position.y = periodic_in_y() ? into_period(position.y, length.y) : position.y;
    position.z = into_period(position.z, length.z);
  }

  /// Advances the offset by `time`, by compensated summation (Kahan 1965).
  void advance(double time) {
    if (kind != BoxKind::lees_edwards) return;
    const double change = velocity_jump() * time + offset_rest, sum = offset + change;
    offset_rest = change - (sum - offset);
    offset = into_period(sum, length.x);
  }

 private:
  /// v modulo period, in [0, period) also where rounding would give `period` itself.
  static double into_period(double v, double period) {
    v -= period * std::floor(v / period);
    return v < period ? v : 0.0;
  }
};

}  // namespace stresslet
