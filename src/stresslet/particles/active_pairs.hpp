#pragma once
/// The pairs that interact at the present positions, filtered from the Verlet list every step.
///
/// Arrays are padded to a multiple of `pack_width`; padding repeats pair (0, 0) at a distance where no law acts.
/// Each particle knows its pairs: those in which it comes first are contiguous, those in which it comes second are
/// listed. Sums over a particle's pairs therefore run in a fixed order, whatever the number of threads.
///
/// Cost of `update`. Per candidate: reads 16 B of indices and slots, writes a slot of 4 B, gathers 64 B of positions
/// and radii (from cache), 29 flops. Per active pair: 36 B staged and read again, 84 B written, 11 flops with a root
/// and three divisions. Bound by latencies of gathers and branches, far from memory.
#include <cstdint>
#include <vector>

#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/particles/box.hpp"
#include "stresslet/particles/state.hpp"
#include "stresslet/particles/verlet_list.hpp"

namespace stresslet {

class ActivePairs {
 public:
  AlignedVector<std::int32_t> i, j;
  std::vector<std::int32_t> candidate;  ///< index into the Verlet list
  AlignedVector<double> ex, ey, ez;     ///< unit vector from i to j
  AlignedVector<double> distance, gap;
  AlignedVector<double> images_up;  ///< how many boxes up in y the nearest image of j lies
  AlignedVector<double> radius_i, radius_j;

  std::size_t size() const { return size_; }
  Vec3<double> normal(std::size_t p) const { return {ex[p], ey[p], ez[p]}; }
  Vec3<Pack> normal_pack(std::size_t p) const { return {load(&ex[p]), load(&ey[p]), load(&ez[p])}; }

  /// Whether the candidate of this index in the Verlet list overlaps.
  bool in_contact(std::size_t k) const { return slot_[k] >= 0 && gap[std::size_t(slot_[k])] < 0; }

  /// Calls `visit(pair, sign)` for the pairs of one particle in fixed order: sign +1 where it is i, -1 where it is j.
  template <class Visit>
  void for_each_pair_of(std::size_t particle, Visit&& visit) const {
    for (std::uint32_t p = first_[particle]; p < first_[particle + 1]; ++p) visit(std::size_t(p), 1.0);
    const std::uint32_t begin = second_begin_[particle];
    for (std::uint32_t k = begin; k < begin + second_count_[particle]; ++k) visit(std::size_t(second_[k]), -1.0);
  }

  /// To be called by one thread after each build of the Verlet list.
  void prepare(const VerletList& list, std::size_t particles);

  /// To be called by all threads of a team; ends with a barrier.
  void update(Member& member, const VerletList& list, const ParticleState& state, const Box& box);

 private:
  static constexpr std::size_t chunk = 64 * pack_width;

  void measure_chunk(std::size_t c, const VerletList& list, const ParticleState& state, const Box& box);
  void collect_chunk(std::size_t c, const VerletList& list, const ParticleState& state);
  void pad();
  void index_first(Range pairs);
  void index_second(Range particles);

  std::size_t size_ = 0;
  std::size_t particles_ = 0;

  /// Candidates that interact, those of chunk c at c * chunk.
  struct Staged {
    std::vector<std::int32_t> candidate;
    std::vector<double> x, y, z, images_up;
    std::vector<std::uint32_t> count, begin;  ///< per chunk: how many, and where they go
  } staged_;
  std::vector<std::int32_t> slot_;  ///< active pair of each candidate, -1 if none
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> second_begin_, second_count_, second_, second_candidates_;
};

}  // namespace stresslet
