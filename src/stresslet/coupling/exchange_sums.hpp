#pragma once
/// What a sphere needs to know of the fluid in its cells: with m = B_k rho of every covered cell, u* the fluid's
/// velocity before the exchange and r the arm from the centre, the momentum that the fluid takes from the sphere in a
/// step is
///   sum m (U + w x r - u*),   its moment about the centre  sum r x m (U + w x r - u*),
/// linear in the sphere's velocities: these sums let the particle update solve for them (theory: partially saturated
/// cells). The sums are those of the sphere's own frame: u* of an image has the image's velocity jump taken off.
#include <array>
#include <vector>

#include "stresslet/base/vec3.hpp"
#include "stresslet/exec/huge_array.hpp"

namespace stresslet {

struct ExchangeSums {
  double mass = 0;                             ///< sum m
  Vec3<double> first{};                        ///< sum m r
  SymTensor3<double> second{};                 ///< sum m r r
  Vec3<double> momentum{};                     ///< sum m u*
  std::array<Vec3<double>, 3> momentum_arm{};  ///< [a]: sum m u*_a r
  SymTensor3<double> kinetic{};                ///< sum of the kinetic stress (operators/kinetic_stress.hpp)

  /// sum m (r.r - r r), the resistance to rotation.
  SymTensor3<double> rotational() const { return trace(second) * identity3<double>() - second; }
  /// sum r x m u*.
  Vec3<double> angular_momentum() const {
    const auto& m = momentum_arm;
    return {m[2].y - m[1].z, m[0].z - m[2].x, m[1].x - m[0].y};
  }
};

/// The part of one run of cells along x, where the arm's y and z are the same all along.
template <class R>
struct RunSums {
  R mass{}, along{}, along_along{};      ///< sum m, sum m x, sum m x x, with x of the arm
  Vec3<R> momentum{}, momentum_along{};  ///< sum m u*, sum m u* x

  /// A cell with m and m u*, at `x`.
  [[gnu::always_inline]] void add(const R& m, const Vec3<R>& mu, const R& x) {
    const R mx = m * x;
    mass += m;
    along += mx;
    along_along += mx * x;
    momentum += mu;
    momentum_along += x * mu;
  }
  /// To the frame that moves with `velocity` along x.
  void change_frame(const R& velocity) {
    momentum.x -= velocity * mass;
    momentum_along.x -= velocity * along;
  }
  friend RunSums operator*(const R& factor, const RunSums& s) {
    return {factor * s.mass, factor * s.along, factor * s.along_along, factor * s.momentum, factor * s.momentum_along};
  }
};

/// A run with its arm across.
struct RunExchange {
  RunSums<double> sums;
  double y, z;

  void add_to(ExchangeSums& s) const {
    const RunSums<double>& r = sums;
    s.mass += r.mass;
    s.first += Vec3<double>{r.along, y * r.mass, z * r.mass};
    s.second +=
        SymTensor3<double>{r.along_along, y * y * r.mass, z * z * r.mass, y * r.along, z * r.along, y * z * r.mass};
    s.momentum += r.momentum;
    s.momentum_arm[0] += Vec3<double>{r.momentum_along.x, y * r.momentum.x, z * r.momentum.x};
    s.momentum_arm[1] += Vec3<double>{r.momentum_along.y, y * r.momentum.y, z * r.momentum.y};
    s.momentum_arm[2] += Vec3<double>{r.momentum_along.z, y * r.momentum.z, z * r.momentum.z};
  }
};

/// What all runs have, by slot (covered_runs.hpp).
struct SlotSums {
  HugeArray<RunExchange> exchange;
  std::vector<SymTensor3<double>> kinetic;  ///< empty where the operator has none

  void resize(std::size_t slots, bool with_kinetic) {
    make_room(exchange, slots);
    kinetic.resize(with_kinetic ? slots : 0);
  }
  /// Asks for the line of a slot that will be written: neighbours in a row lie far apart.
  void ask_for(std::size_t slot) const {
    const char* const at = reinterpret_cast<const char*>(exchange.data() + slot);
    __builtin_prefetch(at, 1);
    __builtin_prefetch(at + sizeof(RunExchange) - 1, 1);
  }
  void add_to(ExchangeSums& sum, std::size_t begin, std::size_t end) const {
    for (std::size_t slot = begin; slot < end; ++slot) exchange.data()[slot].add_to(sum);
    if (!kinetic.empty())
      for (std::size_t slot = begin; slot < end; ++slot) sum.kinetic += kinetic[slot];
  }
};

/// Force, torque and first moment of the fluid's force on a sphere that moves with `velocity` and `angular_velocity`.
struct HydrodynamicLoad {
  Vec3<double> force{}, torque{};
  SymTensor3<double> stresslet{};  ///< symmetric first moment sum sym(F r), usual sum; trace included
  SymTensor3<double> kinetic{};    ///< what the kinetic stress of its cells adds

  SymTensor3<double> complete_stresslet() const { return stresslet + kinetic; }
};

inline HydrodynamicLoad load_on_sphere(const ExchangeSums& s, const Vec3<double>& velocity,
                                       const Vec3<double>& angular_velocity) {
  // Row a of the first moment of the momentum given to the fluid: sum m (U + w x r - u*)_a r.
  const Vec3<double> second_x{s.second.xx, s.second.xy, s.second.xz}, second_y{s.second.xy, s.second.yy, s.second.yz},
      second_z{s.second.xz, s.second.yz, s.second.zz};
  const Vec3<double>& w = angular_velocity;
  const Vec3<double> row_x = velocity.x * s.first + w.y * second_z - w.z * second_y - s.momentum_arm[0];
  const Vec3<double> row_y = velocity.y * s.first + w.z * second_x - w.x * second_z - s.momentum_arm[1];
  const Vec3<double> row_z = velocity.z * s.first + w.x * second_y - w.y * second_x - s.momentum_arm[2];
  HydrodynamicLoad load;
  load.force = s.momentum - s.mass * velocity - cross(w, s.first);
  load.torque = {row_y.z - row_z.y, row_z.x - row_x.z, row_x.y - row_y.x};
  load.stresslet = {
      -row_x.x, -row_y.y, -row_z.z, -0.5 * (row_x.y + row_y.x), -0.5 * (row_x.z + row_z.x), -0.5 * (row_y.z + row_z.y)};
  load.kinetic = s.kinetic;
  return load;
}

}  // namespace stresslet
