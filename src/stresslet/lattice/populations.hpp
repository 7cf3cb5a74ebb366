#pragma once
/// The populations of one block, one copy, streamed in place by the AA pattern of Bailey, Myre, Walsh, Lilja & Saar,
/// Proc. ICPP (2009) 550. Two arrangements alternate:
///
///   arrived   slot i of cell x holds what has streamed into x along c_i;
///   departing slot i of cell x holds its outgoing population opposite(i), collided and not yet moved.
///
/// A step reads the incoming population i of a cell from `source(i)` and writes the outgoing one i where `source` of
/// the opposite population lies, so that every memory place belongs to exactly one cell per step: steps are in place,
/// in any order of cells, on any number of threads, and places in the halo are those that neighbours must exchange.
#include <cstdint>

#include "stresslet/exec/huge_array.hpp"
#include "stresslet/lattice/layout.hpp"
#include "stresslet/lattice/stencil/velocity_set.hpp"

namespace stresslet {

enum class Arrangement { arrived, departing };

constexpr Arrangement other(Arrangement a) {
  return a == Arrangement::arrived ? Arrangement::departing : Arrangement::arrived;
}

template <class Stencil, class T>
class Populations {
 public:
  using Value = T;
  static constexpr int halo_in_z = Stencil::dimensions == 3;

  explicit Populations(const Cells& size)
      : layout_(size, halo_in_z, sizeof(T)), memory_(layout_.stride() * Stencil::size) {}

  const BlockLayout& layout() const { return layout_; }
  std::size_t bytes() const { return memory_.size() * sizeof(T); }

  T* slot(int i) const { return memory_.data() + layout_.stride() * std::size_t(i); }

  /// Array whose element at index(x) is the place that cell x reads its incoming population `i` from in the step that
  /// starts from `arrangement`, and writes its outgoing population opposite(i) to.
  T* source(int i, Arrangement arrangement) const {
    if (arrangement == Arrangement::arrived) return slot(i);
    return slot(opposite(i)) - layout_.offset(Stencil::velocity[i]);
  }

 private:
  BlockLayout layout_;
  HugeArray<T> memory_;
};

}  // namespace stresslet
