#pragma once
/// Spheres while they are being packed. All radii are multiplied by one `inflation` that the packing steps pass along.
#include <vector>

#include "stresslet/base/constants.hpp"
#include "stresslet/particles/box.hpp"

namespace stresslet {

struct Spheres {
  Box box;
  std::vector<double> x, y, z, radius;

  std::size_t size() const { return x.size(); }
  Vec3<double> position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vec3<double> separation(std::size_t i, std::size_t j) const { return box.nearest_image(position(j) - position(i)).r; }

  void set_position(std::size_t i, const Vec3<double>& p) { x[i] = p.x, y[i] = p.y, z[i] = p.z; }

  void move_to(std::size_t i, Vec3<double> p) {
    double velocity = 0;
    box.wrap(p, velocity);
    set_position(i, p);
  }

  double mean_diameter() const {
    double sum = 0;
    for (const double a : radius) sum += 2 * a;
    return sum / double(radius.size());
  }

  double solid_volume() const {
    double sum = 0;
    for (const double a : radius) sum += 4.0 / 3.0 * pi * a * a * a;
    return sum;
  }
};

}  // namespace stresslet
