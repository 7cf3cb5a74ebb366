#pragma once
/// Sums whose bits do not depend on the number of threads: items are summed in chunks of fixed length, the chunk
/// sums are stored, and every thread adds all of them in order.
#include <cstddef>
#include <vector>

#include "stresslet/exec/thread_team.hpp"

namespace stresslet {

inline constexpr std::size_t sum_chunk = 256;

/// `Sum` is default-constructible to zero and has +=.
template <class Sum>
class ChunkSum {
 public:
  void resize(std::size_t items) { partial_.assign((items + sum_chunk - 1) / sum_chunk, Sum{}); }

  /// Sums `term(begin, end)`, itself the ordered sum over items [begin, end), over all chunks. All threads call
  /// this with the same `items`; the result is the same on all. Contains one barrier, and the result may be
  /// overwritten only after another.
  template <class Term>
  Sum operator()(Member& member, std::size_t items, Term&& term) {
    const Range chunks = member.share((items + sum_chunk - 1) / sum_chunk);
    for (std::size_t c = chunks.begin; c < chunks.end; ++c)
      partial_[c] = term(c * sum_chunk, std::min(items, (c + 1) * sum_chunk));
    member.barrier();
    Sum total{};
    for (const Sum& part : partial_) total += part;
    return total;
  }

 private:
  std::vector<Sum> partial_;
};

}  // namespace stresslet
