#pragma once
/// Verlet list: every pair that can come within its interaction range before the list is rebuilt.
///
/// A pair interacts while its gap is below range(a1, a2) = outer d_eff (0 for contacts alone). The list holds the pairs
/// with gap < range + skin, as a half list (i < j in index order), sorted by i and then j. It stays valid while
///   2 max |non-affine displacement| + shear strain since the build x largest centre distance <= skin,
/// so the mean shear, which only turns pairs about each other, is not mistaken for a particle's own motion.
#include <cstdint>
#include <vector>

#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/particles/box.hpp"
#include "stresslet/particles/cell_grid.hpp"
#include "stresslet/particles/state.hpp"

namespace stresslet {

struct InteractionRange {
  double outer_cutoff = 0;  ///< in d_eff = 2 a1 a2/(a1 + a2)
  double operator()(double a1, double a2) const { return outer_cutoff * 2 * a1 * a2 / (a1 + a2); }
};

class VerletList {
 public:
  VerletList() = default;
  VerletList(InteractionRange range, double skin) : range_(range), skin_(skin) {}

  /// Finds all pairs anew.
  void build(ThreadTeam& team, const ParticleState& state, const Box& box);

  /// `displacement` is the largest distance that a particle moved against the mean flow since the last build,
  /// `strain` the shear since then.
  bool valid(double displacement, double strain) const {
    return 2 * displacement + strain * largest_distance_ <= skin_;
  }

  /// Order of the particles along a space-filling curve, as of the last build.
  std::vector<std::int32_t> spatial_order() const { return grid_.spatial_order(); }

  std::size_t size() const { return i.size(); }
  InteractionRange range() const { return range_; }
  double skin() const { return skin_; }

  std::vector<std::int32_t> i, j;

  /// Longest centre distance in the list; boxes must be at least twice as long in every periodic direction.
  double largest_distance() const { return largest_distance_; }
  /// Needed when `i` and `j` are restored from a file instead of built.
  void set_largest_distance(const ParticleState& state);

 private:
  InteractionRange range_;
  double skin_ = 0;
  double largest_distance_ = 0;
  CellGrid grid_;
};

}  // namespace stresslet
