#pragma once
/// The fluid as the layers above see it: laws and precision chosen at run time, everything in lattice units (cell 1,
/// time step 1, rest density 1). One virtual call a step, none inside.
///
/// Time: `advance` takes the incoming populations of time n to those of time n + 1. Density, velocity and strain rate
/// are those of the incoming populations, with half the body force in the velocity.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stresslet/base/vec3.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/lattice/collision/rates.hpp"
#include "stresslet/lattice/density_range.hpp"
#include "stresslet/lattice/grid.hpp"

namespace stresslet {

/// A boundary law on one face of an axis that is neither periodic nor sheared.
struct FaceSetup {
  std::string law = "half-way";  ///< a name from BoundaryLaws
  Vec3<double> velocity_lu{};    ///< of the wall, or of the fluid that comes in
  double density_lu = 1;         ///< where the law sets the pressure
};

struct FluidSetup {
  std::string stencil = "D3Q19";
  bool single_precision = false;
  Grid grid;
  std::string collision = "TRT";
  CollisionInput rates;
  std::string forcing = "none";
  std::array<std::array<FaceSetup, 2>, 3> faces;  ///< [axis][0 low, 1 high]; read where the axis is open
  double shear_velocity_lu = 0;                   ///< velocity of the image above minus that of the box; sheared y only
  std::string shear_interpolation = "cubic";      ///< a name from ShearInterpolations
  std::vector<std::uint8_t> solid;  ///< one byte a cell, x fastest, 1 = solid (half-way walls); may be empty
  /// Velocity of the surface of solid cells at a place, corners of cells at whole numbers; at rest where not given.
  std::function<Vec3<double>(const Vec3<double>&)> solid_velocity_lu;
};

struct CellState {
  double density = 1;
  Vec3<double> velocity{};
  SymTensor3<double> strain_rate{};  ///< sets the viscous stress of the populations
};

class Fluid {
 public:
  /// Throws std::invalid_argument where a name is unknown or the combination is not built.
  static std::unique_ptr<Fluid> make(const FluidSetup& setup);
  virtual ~Fluid() = default;

  virtual const Grid& grid() const = 0;
  virtual std::int64_t steps() const = 0;
  virtual std::size_t bytes() const = 0;

  /// Sets every cell, global coordinates; `state` is called from all threads.
  virtual void initialise(ThreadTeam& team, const std::function<CellState(const Cells&)>& state) = 0;
  virtual void advance(ThreadTeam& team, int steps) = 0;
  virtual void set_force_density(const Vec3<double>& force_lu) = 0;
  /// Displacement of the image above in cells, at the present time; only with a sheared y axis.
  virtual void set_shear_offset(double offset_lu) = 0;
  virtual double shear_offset() const = 0;

  /// Calls `visit` for every cell of the box [first, last] (both ends included, steps of `stride`), from all threads,
  /// each row by one thread in ascending x. Solid cells are visited too.
  virtual void measure(ThreadTeam& team, const Cells& first, const Cells& last, const Cells& stride,
                       const std::function<void(const Cells&, const CellState&)>& visit) = 0;

  /// Sums over all cells that are not solid; the same bits for any number of threads and blocks.
  struct Totals : DensityRange {
    double mass_deviation = 0;  ///< sum of density - 1
    Vec3<double> momentum{};    ///< of the incoming populations, without half the body force
  };
  virtual Totals totals(ThreadTeam& team) = 0;

  /// All incoming populations, population by population, x fastest, and whatever walls keep besides: everything the
  /// next step needs except step number and offset. Independent of blocks; `restore` continues with the same bits.
  virtual std::vector<double> populations(ThreadTeam& team) = 0;
  virtual void restore(ThreadTeam& team, const std::vector<double>& populations, std::int64_t steps) = 0;
};

}  // namespace stresslet
