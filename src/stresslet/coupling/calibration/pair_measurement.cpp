#include "stresslet/coupling/calibration/pair_measurement.hpp"

#include <cmath>

#include "stresslet/coupling/calibration/periodic_images.hpp"
#include "stresslet/lattice/collision/rates.hpp"
#include "stresslet/lubrication/two_spheres_exact.hpp"

namespace stresslet {
namespace {

constexpr double speed = 1e-5;  ///< small enough for inertia and compressibility not to show
constexpr int most_steps = 20000;

Vector12 joined(const std::array<Vec3<double>, 4>& parts) {
  Vector12 v;
  for (std::size_t i = 0; i < 4; ++i) {
    v(Eigen::Index(3 * i)) = parts[i].x;
    v(Eigen::Index(3 * i + 1)) = parts[i].y;
    v(Eigen::Index(3 * i + 2)) = parts[i].z;
  }
  return v;
}
Vec3<double> part(const Vector12& v, Eigen::Index i) { return {v(3 * i), v(3 * i + 1), v(3 * i + 2)}; }

/// a b, row from a.
Eigen::Matrix3d product(const Vec3<double>& a, const Vec3<double>& b) {
  Eigen::Matrix3d m;
  m << a.x * b.x, a.x * b.y, a.x * b.z, a.y * b.x, a.y * b.y, a.y * b.z, a.z * b.x, a.z * b.y, a.z * b.z;
  return m;
}

struct Frame {
  Vec3<double> e, t, b;
};

Frame frame_of(const PairPlacement& p) {
  Frame f;
  f.e = p.direction / norm(p.direction);
  const Vec3<double> across = tangential_part(p.across, f.e);
  f.t = across / norm(across);
  f.b = cross(f.e, f.t);
  return f;
}

/// The four motions at unit speed, each in the frame in which `resistance` gives no net force.
Eigen::Matrix<double, 12, 4> balanced_motions(const Matrix12& resistance, const Frame& frame, double mean_radius) {
  const Vec3<double> e = 0.5 * frame.e, t = 0.5 * frame.t, b = frame.b / mean_radius, none{};
  Eigen::Matrix<double, 12, 4> m;
  m.col(0) = joined({-e, none, e, none});
  m.col(1) = joined({-t, none, t, none});
  m.col(2) = joined({none, b, none, b});
  m.col(3) = joined({none, b, none, -b});
  Eigen::Matrix<double, 12, 3> together;
  together << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Identity(),
      Eigen::Matrix3d::Zero();
  const Eigen::Matrix3d drag = together.transpose() * resistance * together;
  return m - together * drag.inverse() * (together.transpose() * resistance * m);
}

struct Load {
  Vector12 wrench;         ///< force and torque on both, friction in shared cells included
  Eigen::Matrix3d moment;  ///< sum of f_i x_j, f the force on the fluid, x from the middle of the pair
};

Load load_of(const ResolvedFluid& fluid, const std::vector<ResolvedSphere>& spheres, const Vec3<double>& middle) {
  Load load;
  load.moment.setZero();
  std::array<HydrodynamicLoad, 2> on;
  for (std::size_t k = 0; k < 2; ++k) {
    on[k] = load_on_sphere(fluid.exchange(k), spheres[k].velocity, spheres[k].angular_velocity);
    const SymTensor3<double> s = on[k].complete_stresslet();
    Eigen::Matrix3d own;
    own << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    own += 0.5 * cross_matrix(on[k].torque);  // F_i r_j - F_j r_i = -eps_ijk T_k
    load.moment -= own + product(on[k].force, spheres[k].centre - middle);
  }
  load.wrench = joined({on[0].force, on[0].torque, on[1].force, on[1].torque});
  const Vector12 v =
      joined({spheres[0].velocity, spheres[0].angular_velocity, spheres[1].velocity, spheres[1].angular_velocity});
  for (const PointFriction& friction : fluid.friction()) load.wrench -= link_of(friction).resistance * v;
  return load;
}

struct Steady {
  Load load;
  Vec3<double> mean_velocity;
  int steps;
};

Steady steady_load(const PairScheme& scheme, int edge, const std::vector<ResolvedSphere>& spheres,
                   const Vec3<double>& middle, const Vector12& motion, ThreadTeam& team, double tolerance) {
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.collision = scheme.collision;
  setup.rates.relaxation_time = scheme.relaxation_time;
  setup.rates.magic_parameter = scheme.magic_parameter;
  CouplingSetup coupling;
  coupling.coupling_operator = scheme.coupling_operator;
  coupling.solid = {scheme.solid_fraction, scheme.weight, scheme.relaxation_time};
  ResolvedFluidOf<double> fluid(setup, coupling);
  fluid.initialise(team, [](const Cells&) { return CellState{}; });
  const double viscosity = kinematic_viscosity_lu(scheme.relaxation_time);
  const int chunk = std::max(20, int(edge * edge / (4 * pi * pi * viscosity) / 8));
  double before = 0;
  Steady result{};
  for (int steps = 0; steps < most_steps; steps += chunk) {
    team.run([&](Member& member) {
      for (int n = 0; n < chunk; ++n) {
        fluid.prepare(member, spheres);
        if (n + 1 < chunk) fluid.sweep(member, spheres);
      }
    });
    result.load = load_of(fluid, spheres, middle);
    result.steps = steps + chunk;
    const double power = -result.load.wrench.dot(motion);
    if (std::abs(power - before) < tolerance * std::abs(power)) break;
    before = power;
    team.run([&](Member& member) { fluid.sweep(member, spheres); });
  }
  result.mean_velocity = fluid.totals(team).momentum / (double(edge) * edge * edge);
  return result;
}

}  // namespace

PairMeasurement measure_pair(const PairScheme& scheme, const PairPlacement& placement,
                             const std::vector<PairMotionKind>& kinds, ThreadTeam& team, double tolerance) {
  const Frame frame = frame_of(placement);
  const double viscosity = kinematic_viscosity_lu(scheme.relaxation_time);
  PairMeasurement result;
  result.placement = placement;
  result.viscosity = viscosity;
  result.measured.setZero();
  result.exact.setZero();
  result.images.setZero();
  const Matrix12 resistance =
      viscosity *
      resistance_matrix(exact_two_spheres(placement.radius1, placement.radius2, placement.gap, 1e-5), frame.e);
  result.motion = balanced_motions(resistance, frame, 0.5 * (placement.radius1 + placement.radius2));

  const double half = 0.5 * placement.edge;
  const Vec3<double> gap_middle = Vec3<double>{std::floor(half), std::floor(half), std::floor(half)} + placement.offset;
  std::vector<ResolvedSphere> spheres(2);
  spheres[0].radius = placement.radius1;
  spheres[1].radius = placement.radius2;
  spheres[0].centre = gap_middle - (placement.radius1 + 0.5 * placement.gap) * frame.e;
  spheres[1].centre = gap_middle + (placement.radius2 + 0.5 * placement.gap) * frame.e;
  const Vec3<double> middle = 0.5 * (spheres[0].centre + spheres[1].centre);

  std::array<Eigen::Matrix3d, 4> moments;
  for (const PairMotionKind kind : kinds) {
    const Eigen::Index b = Eigen::Index(kind);
    const Vector12 motion = result.motion.col(b);
    for (std::size_t k = 0; k < 2; ++k) {
      spheres[k].velocity = speed * part(motion, Eigen::Index(2 * k));
      spheres[k].angular_velocity = speed * part(motion, Eigen::Index(2 * k + 1));
    }
    const Steady steady = steady_load(scheme, placement.edge, spheres, middle, motion, team, tolerance);
    result.steps[std::size_t(b)] = steady.steps;
    moments[std::size_t(b)] = steady.load.moment / speed;
    const Vector12 wrench = steady.load.wrench / speed;
    const Vec3<double> on_fluid = -(part(wrench, 0) + part(wrench, 2));
    const Vec3<double> ambient =
        steady.mean_velocity / speed + net_force_mobility(viscosity, placement.edge) * on_fluid;
    const Vector12 relative =
        joined({part(motion, 0) - ambient, part(motion, 1), part(motion, 2) - ambient, part(motion, 3)});
    result.measured.col(b) = -result.motion.transpose() * wrench;
    result.exact.col(b) = result.motion.transpose() * (resistance * relative);
  }
  for (const PairMotionKind one : kinds)
    for (const PairMotionKind other : kinds) {
      const std::size_t a = std::size_t(one), b = std::size_t(other);
      result.images(Eigen::Index(a), Eigen::Index(b)) = image_power(moments[a], moments[b], viscosity, placement.edge);
    }
  result.measured -= result.images;
  return result;
}

}  // namespace stresslet
