#pragma once
/// Which cells the spheres cover, as runs: the part of one row of cells that one image covers, cut where
/// blocks may begin (`grain_in_x`).
///
/// Runs lie in memory row by row, so that kernels walk through them and the lattice together. The packs of a run begin
/// at its first cell, wherever in the row that is: a fifth fewer in double precision, a third in single, than with
/// packs that begin where those of the row do. Each run has a `slot`, its place in the order of images: sums over a
/// sphere go through its slots, and have the same bits for any number of threads and blocks.
///
/// `fill_drags` costs, per covered pack of cells at the surface, one evaluation of the solid-fraction law in registers
/// (some 60 operations for plane-cut) and one store; packs inside are filled.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "stresslet/coupling/spans.hpp"
#include "stresslet/coupling/sphere_images.hpp"
#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/huge_array.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

inline constexpr int most_cells_along = 32767;  ///< an axis

/// Small, because every step writes all of them, twice, and the second time all over memory.
struct CoveredRun {
  std::int32_t image, slot;
  std::uint32_t row;                          ///< of the rows of all blocks in one list
  std::uint32_t first_pack;                   ///< where its solid drags begin
  std::int16_t global_x, global_y, global_z;  ///< of the first cell
  std::int16_t x;                             ///< of the first cell, in the block
  std::uint8_t cells;
  std::uint8_t packs;                 ///< of solid drags, zero beyond the cells
  std::uint8_t full_begin, full_end;  ///< cells entirely inside the sphere, counted from the first
  bool filled;                        ///< whether the solid drags are there

  /// From `centre` to the first cell.
  Vec3<double> arm(const Vec3<double>& centre) const {
    return {global_x - centre.x, global_y - centre.y, global_z - centre.z};
  }
};
static_assert(sizeof(CoveredRun) == 32);

/// The core of a sphere: cells more than this far, in cells, inside its surface. No flow reaches them.
inline constexpr double core_depth = 2;

struct SolidLaws {
  std::string fraction = "plane-cut", weight = "viscosity-scaled";
  double relaxation_time = 1;
  double core_weight = 2;  ///< largest solid weight in the core
};

/// `T` of the drags: that of the lattice.
template <class T>
class CoveredRuns {
 public:
  static constexpr int width = int(PackOf<T>::size());  ///< of packs

  /// Throws std::invalid_argument for a grid of more than `most_cells_along` along an axis.
  CoveredRuns(const Grid& grid, const SolidLaws& laws);

  /// Finds all images and runs of `spheres`; keeps what it has where all stay as they were. All members of the team
  /// call it; ends with a barrier.
  void place(Member& member, const std::vector<ResolvedSphere>& spheres, double shear_offset, double shear_velocity);

  /// The solid drags of the cells of these runs, once a placement.
  void fill_drags(const Range& runs) { (this->*fill_)(runs); }

  const std::vector<SphereImage>& images() const { return images_; }
  /// By row.
  std::span<const CoveredRun> runs() const { return {runs_.data(), run_count_}; }
  /// Slots [begin, end) of the runs of image `k`.
  Range slots_of_image(std::size_t k) const { return {first_slot_[k], first_slot_[k + 1]}; }
  /// Images [begin, end) of sphere `k`.
  Range images_of_sphere(std::size_t k) const { return {first_image_[k], first_image_[k + 1]}; }
  /// Runs [begin, end) in a row of a block, in the order of their slots.
  Range runs_of_row(int block, std::size_t row) const {
    const std::size_t k = first_row_[std::size_t(block)] + row;
    return {first_run_[k], first_run_[k + 1]};
  }
  T* drag(const CoveredRun& run) { return drag_.data() + std::size_t(run.first_pack) * width; }
  const T* drag(const CoveredRun& run) const { return drag_.data() + std::size_t(run.first_pack) * width; }

 private:
  /// What a member found of its share of the images. Sorted into rows by counting, in two passes: how many runs and
  /// packs every member has in every row, then where each begins. A line of its own: every run moves the end of `runs`.
  struct alignas(cache_line) Found {
    std::vector<CoveredRun> runs;                  ///< by slot, counted from 0
    std::vector<std::uint32_t> runs_in, packs_in;  ///< [row]: numbers, afterwards the place of the next one
  };

  /// Whether the images differ from those of the last placement.
  bool find_images(const std::vector<ResolvedSphere>& spheres, double offset, double velocity);
  void find_runs(Found& found, const Range& images);
  void divide_rows(std::size_t members);
  void sort_into_rows(Found& found, const Range& images, std::size_t first_slot);
  template <class Fraction, class Weight>
  void fill(const Range& runs);

  Grid grid_;
  SolidLaws laws_;
  std::vector<BlockBox> boxes_;
  std::vector<std::size_t> first_row_;  ///< [block]: number of its first row, all blocks in one list
  std::array<std::vector<std::pair<int, int>>, 3>
      places_;  // per axis and cell: contribution to the block's number, place
  std::vector<SphereImage> images_, images_before_;
  bool moved_ = true;
  std::vector<std::size_t> first_image_, first_slot_;
  std::vector<std::uint32_t> first_run_;   ///< [row]
  std::vector<Found> found_;               ///< [member]
  std::vector<std::size_t> found_before_;  ///< [member]: slots of the members before
  HugeArray<CoveredRun> runs_;
  std::size_t run_count_ = 0;
  HugeArray<T> drag_;
  double (*drawn_radius_)(double) = nullptr;
  double (*touch_radius_)(double) = nullptr;
  double (*full_radius_)(double) = nullptr;
  void (CoveredRuns::*fill_)(const Range&) = nullptr;
};

}  // namespace stresslet
