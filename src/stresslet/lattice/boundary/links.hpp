#pragma once
/// Pairs of memory places that must agree at the rim of a block.
///
/// In the arrangement `departing`, cell x reads its incoming population i at (x - c_i, slot opposite(i)), and writes
/// the outgoing one j to (x + c_j, slot j). Where x + c_j lies in the halo, the same place serves both; these places
/// are
///   { (x + c_j, slot j) : x in the block, x + c_j in its halo }.
/// Before the sweep such a place needs what comes in, afterwards it holds what goes out. Exchange between blocks,
/// periodic faces and half-way walls are pairs (halo place, partner): copied partner -> halo before, halo -> partner
/// after. For exchange the partner is the same cell and slot in the block that owns it; at a half-way wall it is slot
/// opposite(j) of the cell x itself. Nothing is to be done in the arrangement `arrived`, whose sweeps stay within their
/// cells.
#include <vector>

#include "stresslet/lattice/boundary/walls.hpp"
#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

/// A box of halo places of one slot and their partners, which lie `to_partner` further on in block `partner_block`.
struct LinkBox {
  int block, partner_block;
  int slot, partner_slot;
  Cells crossed;      ///< the faces between block and halo places: -1, 0, 1 along each axis
  Cells first, last;  ///< halo places, coordinates in `block`, both ends included
  Cells to_partner;   ///< coordinates in `partner_block` minus coordinates in `block`
  double correction;  ///< added on the way, in both directions
};

/// Calls `visit(d, j, first, last)` for every region `d` of the halo and slot `j` with places in it.
template <class Stencil, class Visit>
void for_each_halo_box(const Cells& size, Visit&& visit) {
  for (int code = 0; code < 27; ++code) {
    const Cells d{code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
    if (d == Cells{0, 0, 0}) continue;
    for (int j = 1; j < Stencil::size; ++j) {
      const auto& c = Stencil::velocity[j];
      Cells first, last;
      bool some = true;
      for (int a = 0; a < 3; ++a) {
        if (d[a] != 0) {
          some = some && c[a] == d[a];
          first[a] = last[a] = d[a] > 0 ? size[a] : -1;
        } else {
          first[a] = c[a] > 0 ? 1 : 0;
          last[a] = size[a] - (c[a] < 0 ? 2 : 1);
          some = some && first[a] <= last[a];
        }
      }
      if (some) visit(d, j, first, last);
    }
  }
}

/// Places of one slot of a block, counted in rows and planes from one of them.
template <class T>
struct PlacesOfSlot {
  T* first;
  std::ptrdiff_t pitch, plane;
  T* at(int y, int z) const { return first + y * pitch + z * plane; }
};

template <class Stencil, class T>
PlacesOfSlot<T> places_of_slot(const Populations<Stencil, T>& populations, int slot, const Cells& first) {
  const BlockLayout& layout = populations.layout();
  return {populations.slot(slot) + layout.index(first), std::ptrdiff_t(layout.pitch()), std::ptrdiff_t(layout.plane())};
}

/// Halo places of a box from `first` on, coordinates in its block, and their partners.
template <class Stencil, class T>
PlacesOfSlot<T> halo_places(const Lattice<Stencil, T>& lattice, const LinkBox& box, const Cells& first) {
  return places_of_slot(lattice.blocks[std::size_t(box.block)].populations, box.slot, first);
}
template <class Stencil, class T>
PlacesOfSlot<T> partner_places(const Lattice<Stencil, T>& lattice, const LinkBox& box, const Cells& first) {
  const Cells there{first[0] + box.to_partner[0], first[1] + box.to_partner[1], first[2] + box.to_partner[2]};
  return places_of_slot(lattice.blocks[std::size_t(box.partner_block)].populations, box.partner_slot, there);
}

/// Copies along link boxes. Reads and writes 2 values per place and sweep, once every second step.
template <class Stencil, class T>
class LinkBoundary : public Boundary<Stencil, T> {
 public:
  explicit LinkBoundary(std::vector<LinkBox> boxes) : boxes_(std::move(boxes)) {}

  bool looks_across() const override { return false; }

  void before_sweep(Lattice<Stencil, T>& lattice, Member& member) override {
    if (lattice.arrangement == Arrangement::departing)
      for (const LinkBox& box : boxes_)
        copy(partner_places(lattice, box, box.first), halo_places(lattice, box, box.first), box, member);
  }
  void after_sweep(Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) override {
    if (swept == Arrangement::departing)
      for (const LinkBox& box : boxes_)
        copy(halo_places(lattice, box, box.first), partner_places(lattice, box, box.first), box, member);
  }

 private:
  static void copy(const PlacesOfSlot<T>& from, const PlacesOfSlot<T>& to, const LinkBox& box, Member& member) {
    const T correction = T(box.correction);
    const int count = box.last[0] - box.first[0] + 1;
    const int ny = box.last[1] - box.first[1] + 1;
    const Range rows = member.share(std::size_t(ny) * std::size_t(box.last[2] - box.first[2] + 1));
    int y = int(rows.begin) % ny, z = int(rows.begin) / ny;
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
      const T* source = from.at(y, z);
      T* target = to.at(y, z);
      for (int k = 0; k < count; ++k) target[k] = source[k] + correction;
      if (++y == ny) y = 0, ++z;
    }
  }

  std::vector<LinkBox> boxes_;
};

/// Links between blocks and across periodic faces.
template <class Stencil>
std::vector<LinkBox> exchange_links(const Grid& grid) {
  const std::vector<BlockBox> boxes = block_boxes(grid);
  std::vector<LinkBox> links;
  for (int b = 0; b < int(boxes.size()); ++b)
    for_each_halo_box<Stencil>(boxes[std::size_t(b)].size, [&](const Cells& d, int j, const Cells& first,
                                                               const Cells& last) {
      const Neighbour n = neighbour_of(grid, b, d);
      if (n.kind != Neighbour::Kind::block) return;
      Cells shift;
      for (int a = 0; a < 3; ++a)
        shift[a] = boxes[std::size_t(b)].origin[a] - n.wrap[a] * grid.size[a] - boxes[std::size_t(n.block)].origin[a];
      links.push_back({b, n.block, j, j, d, first, last, shift, 0});
    });
  return links;
}

/// Half-way bounce-back (walls.hpp) at open faces. `wall_velocity(crossed)` gives the velocity of the half-way wall
/// that a link meets which crosses the faces `crossed` (components -1, 0, 1), or nothing where it meets something else.
template <class Stencil, class WallVelocity>
std::vector<LinkBox> half_way_links(const Grid& grid, WallVelocity&& wall_velocity) {
  const std::vector<BlockBox> boxes = block_boxes(grid);
  std::vector<LinkBox> links;
  for (int b = 0; b < int(boxes.size()); ++b)
    for_each_halo_box<Stencil>(
        boxes[std::size_t(b)].size, [&](const Cells& d, int j, const Cells& first, const Cells& last) {
          const Neighbour n = neighbour_of(grid, b, d);
          if (n.kind != Neighbour::Kind::open) return;
          const auto velocity = wall_velocity(n.wrap);
          if (!velocity) return;
          const auto& c = Stencil::velocity[j];
          links.push_back(
              {b, b, j, opposite(j), d, first, last, {-c[0], -c[1], -c[2]}, wall_correction<Stencil>(j, *velocity)});
        });
  return links;
}

}  // namespace stresslet
