#pragma once
/// Exchange across faces in x, row by row. One value a row lies at each face, in a cache line of its own: copied before
/// and after a sweep, both ends are fetched from memory each time, which cost 6 % of a step at 200 cubed and 13 % in
/// eight blocks. Copied around the sweep of the row whose cells own the places, the lines are in cache anyway. No other
/// cell and no other boundary touches a place and its partner (links.hpp), so the order of rows is free.
#include <array>
#include <vector>

#include "stresslet/lattice/boundary/links.hpp"

namespace stresslet {

template <class Stencil, class T>
class RowExchange {
 public:
  RowExchange() = default;
  /// Takes the links across x faces alone out of `links`. `lattice` must stay where it is.
  RowExchange(std::vector<LinkBox>& links, const Lattice<Stencil, T>& lattice) : of_block_(lattice.blocks.size()) {
    std::erase_if(links, [&](const LinkBox& box) {
      const bool across_x = box.crossed[0] != 0 && box.crossed[1] == 0 && box.crossed[2] == 0;
      if (across_x) of_block_[std::size_t(box.block)].push_back(link_of(box, lattice));
      return across_x;
    });
  }

  /// Before the sweep of row (y, z) in the arrangement `departing`: what comes in. Lines of later rows are asked for.
  void bring_in(int block, int y, int z) const {
    for (const Link& link : of_block_[std::size_t(block)]) {
      T *const halo = link.halo.at(y, z), *const partner = link.partner.at(y, z);
      __builtin_prefetch(partner + rows_ahead * link.partner.pitch, 1);
      __builtin_prefetch(halo + rows_ahead * link.halo.pitch, 1);
      if (link.has(y, z)) *halo = *partner;
    }
  }
  /// After it: what has gone out.
  void bring_out(int block, int y, int z) const {
    for (const Link& link : of_block_[std::size_t(block)])
      if (link.has(y, z)) *link.partner.at(y, z) = *link.halo.at(y, z);
  }

 private:
  static constexpr int rows_ahead = 4;

  /// Places that the cells of row (y, z) own, for y and z in [first, last].
  struct Link {
    PlacesOfSlot<T> halo, partner;
    std::array<int, 2> first, last;
    bool has(int y, int z) const { return y >= first[0] && y <= last[0] && z >= first[1] && z <= last[1]; }
  };

  static Link link_of(const LinkBox& box, const Lattice<Stencil, T>& lattice) {
    // The cell that owns a place lies at the place minus c of its slot.
    const auto& c = Stencil::velocity[box.slot];
    const Cells &first = box.first, &last = box.last, owned_by_first_row{first[0], c[1], c[2]};
    return {halo_places(lattice, box, owned_by_first_row),
            partner_places(lattice, box, owned_by_first_row),
            {first[1] - c[1], first[2] - c[2]},
            {last[1] - c[1], last[2] - c[2]}};
  }

  std::vector<std::vector<Link>> of_block_;
};

}  // namespace stresslet
