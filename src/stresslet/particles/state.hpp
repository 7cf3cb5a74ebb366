#pragma once
/// State of N spheres, structure of arrays. Lengths in units of the chosen diameter, times in 1/shear rate (see
/// docs/user-guide.md); index order is spatial and changes with sorting, `id` never does.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/vec3.hpp"
#include "stresslet/exec/aligned.hpp"

namespace stresslet {

struct ParticleState {
  AlignedVector<double> x, y, z;     ///< centre, in the box
  AlignedVector<double> ux, uy, uz;  ///< velocity in the frame of the box
  AlignedVector<double> wx, wy, wz;  ///< angular velocity
  AlignedVector<double> radius, density;
  std::vector<std::int32_t> species;  ///< index into the size classes of the input
  std::vector<std::int32_t> id;       ///< permanent name, 0 ... N-1
  double fluid_density = 0;           ///< of the fluid that a lattice holds inside the particles; 0 without one

  std::size_t size() const { return x.size(); }

  /// Calls `visit(name, array)` for every array: the one list used by resize, sort, checkpoint and output.
  template <class Visit>
  void for_each_array(Visit&& visit) {
    visit("x", x), visit("y", y), visit("z", z);
    visit("ux", ux), visit("uy", uy), visit("uz", uz);
    visit("wx", wx), visit("wy", wy), visit("wz", wz);
    visit("radius", radius), visit("density", density);
    visit("species", species), visit("id", id);
  }

  void resize(std::size_t n) {
    for_each_array([n](const char*, auto& a) { a.resize(n); });
  }

  Vec3<double> position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vec3<double> velocity(std::size_t i) const { return {ux[i], uy[i], uz[i]}; }
  Vec3<double> angular_velocity(std::size_t i) const { return {wx[i], wy[i], wz[i]}; }
  double volume(std::size_t i) const { return 4.0 / 3.0 * pi * radius[i] * radius[i] * radius[i]; }
  double mass(std::size_t i) const { return density[i] * volume(i); }
  /// Moment of inertia of a solid sphere, 2 m a^2 / 5.
  double inertia(std::size_t i) const { return 0.4 * mass(i) * radius[i] * radius[i]; }
  /// What a particle adds to the momentum that is there without it: the fluid inside it moves with it and has its share
  /// already. Never negative, so that a particle lighter than the fluid has the inertia of the fluid.
  double own_mass(std::size_t i) const { return std::max(density[i] - fluid_density, 0.0) * volume(i); }
  double own_inertia(std::size_t i) const { return 0.4 * own_mass(i) * radius[i] * radius[i]; }

  void set_position(std::size_t i, const Vec3<double>& p) { x[i] = p.x, y[i] = p.y, z[i] = p.z; }
  void set_velocity(std::size_t i, const Vec3<double>& u) { ux[i] = u.x, uy[i] = u.y, uz[i] = u.z; }
  void set_angular_velocity(std::size_t i, const Vec3<double>& w) { wx[i] = w.x, wy[i] = w.y, wz[i] = w.z; }
};

}  // namespace stresslet
