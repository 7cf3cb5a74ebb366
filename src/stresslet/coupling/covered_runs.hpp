#pragma once
/// Which cells the spheres cover, as runs: the part of one row of cells that one image covers, cut at multiples of
/// `run_length` cells. Runs are numbered image by image in a fixed order, so that sums over a sphere's runs have the
/// same bits for any number of threads and blocks (blocks begin at multiples of `run_length` along x); each row has a
/// list of its runs for the sweep.
///
/// `map` costs, per covered pack of cells at the surface, one evaluation of the solid-fraction law in registers (some
/// 60 operations for plane-cut) and one store; packs inside are filled.
#include <cstdint>
#include <string>
#include <vector>

#include "stresslet/coupling/spans.hpp"
#include "stresslet/coupling/sphere_images.hpp"
#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

inline constexpr int run_length = 16;

struct CoveredRun {
  std::int32_t image, block, row;  ///< row = y + ny z within the block
  std::int32_t x, packs;           ///< block coordinate of the first cell, a multiple of the pack width
  Cells global;                    ///< of the first cell
  CellRange cells;                 ///< global
  CellRange full;                  ///< cells entirely inside the sphere, global
  std::size_t first_pack;          ///< where its solid drags begin
};

struct SolidLaws {
  std::string fraction = "plane-cut", weight = "viscosity-scaled";
  double relaxation_time = 1;
};

class CoveredRuns {
 public:
  explicit CoveredRuns(const Grid& grid);

  /// Finds all images and runs of `spheres` and the solid drag of every covered cell. All members of the team call it;
  /// ends with a barrier.
  void map(Member& member, const SolidLaws& laws, const std::vector<ResolvedSphere>& spheres, double shear_offset,
           double shear_velocity);

  const std::vector<SphereImage>& images() const { return images_; }
  const std::vector<CoveredRun>& runs() const { return runs_; }
  /// Runs [begin, end) of image `k`.
  Range runs_of_image(std::size_t k) const { return {first_run_[k], first_run_[k + 1]}; }
  /// Images [begin, end) of sphere `k`.
  Range images_of_sphere(std::size_t k) const { return {first_image_[k], first_image_[k + 1]}; }
  /// Numbers of the runs in a row of a block, in ascending order.
  std::pair<const std::int32_t*, const std::int32_t*> runs_of_row(int block, std::size_t row) const {
    const auto& b = buckets_[std::size_t(block)];
    return {b.runs.data() + b.first[row], b.runs.data() + b.first[row + 1]};
  }
  double* drag(const CoveredRun& run) { return drag_.data() + run.first_pack * pack_width; }
  const double* drag(const CoveredRun& run) const { return drag_.data() + run.first_pack * pack_width; }

 private:
  struct Buckets {
    std::vector<std::int32_t> first, runs, next;
  };
  void find_images(const SolidLaws& laws, const std::vector<ResolvedSphere>& spheres, double offset, double velocity);
  void find_runs();
  void sort_into_rows();

  Grid grid_;
  std::vector<BlockBox> boxes_;
  std::array<std::vector<std::pair<int, int>>, 3>
      places_;  // per axis and cell: contribution to the block's number, place
  std::vector<SphereImage> images_;
  std::vector<std::size_t> first_image_, first_run_;
  std::vector<CoveredRun> runs_;
  std::vector<Buckets> buckets_;
  AlignedVector<double> drag_;
  double (*touch_radius_)(double) = nullptr;
  double (*full_radius_)(double) = nullptr;
};

}  // namespace stresslet
