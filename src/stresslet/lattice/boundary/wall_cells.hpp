#pragma once
/// Walls of single links rather than boxes: full-way walls and solid cells.
///
/// A link leads from a fluid cell x along c_j into a wall. Its two places are `inside` = (x, slot opposite(j)) and
/// `beyond` = (x + c_j, slot j); links.hpp tells which of them a sweep uses.
///
/// Full-way: a wall cell that reverses what it receives, f'_opposite(j) = f_j, leaves every value where it is, in both
/// arrangements; so a wall at rest needs no work at all, and a moving one adds its correction to what has just gone
/// out. The place that the next sweep does not read holds populations on their way through the wall.
///
/// Solid cells: half-way walls between fluid and solid, so the two places are to agree. Solid cells are swept as if
/// they were fluid, which writes to no place that lasts, and set back to the rest state after every sweep.
#include <vector>

#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

struct WallLink {
  int block;
  int slot;  ///< j
  std::size_t cell, beyond;
  double correction;  ///< of a moving wall

  template <class Stencil, class T>
  T& inside_place(const Lattice<Stencil, T>& lattice) const {
    return lattice.blocks[std::size_t(block)].populations.slot(opposite(slot))[cell];
  }
  template <class Stencil, class T>
  T& beyond_place(const Lattice<Stencil, T>& lattice) const {
    return lattice.blocks[std::size_t(block)].populations.slot(slot)[beyond];
  }
};

template <class Stencil, class T>
class FullWayBoundary : public Boundary<Stencil, T> {
 public:
  /// `links` in an order that does not depend on blocks.
  explicit FullWayBoundary(std::vector<WallLink> links) : links_(std::move(links)) {}

  void after_sweep(Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) override {
    const Range share = member.share(links_.size());
    for (std::size_t k = share.begin; k < share.end; ++k) {
      const WallLink& link = links_[k];
      if (link.correction == 0) continue;
      T& gone = swept == Arrangement::departing ? link.beyond_place(lattice) : link.inside_place(lattice);
      gone += T(link.correction);
    }
  }

  std::size_t kept() const override { return links_.size(); }
  void save(const Lattice<Stencil, T>& lattice, double* kept) const override {
    for (const WallLink& link : links_)
      *kept++ = lattice.arrangement == Arrangement::arrived ? link.beyond_place(lattice) : link.inside_place(lattice);
  }
  void restore(Lattice<Stencil, T>& lattice, const double* kept) override {
    for (const WallLink& link : links_) link.beyond_place(lattice) = T(*kept++);
  }
  void initialise(Lattice<Stencil, T>& lattice) override {
    for (const WallLink& link : links_) link.beyond_place(lattice) = link.inside_place(lattice);
  }

 private:
  std::vector<WallLink> links_;
};

/// Solid cells that follow each other along x.
struct SolidRun {
  int block;
  std::size_t first, count;
};

template <class Stencil, class T>
class SolidBoundary : public Boundary<Stencil, T> {
 public:
  SolidBoundary(std::vector<WallLink> links, std::vector<SolidRun> solid)
      : links_(std::move(links)), solid_(std::move(solid)) {}

  void before_sweep(Lattice<Stencil, T>& lattice, Member& member) override {
    if (lattice.arrangement != Arrangement::departing) return;
    const Range share = member.share(links_.size());
    for (std::size_t k = share.begin; k < share.end; ++k)
      links_[k].beyond_place(lattice) = links_[k].inside_place(lattice);
  }

  void after_sweep(Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) override {
    if (swept == Arrangement::departing) {
      const Range share = member.share(links_.size());
      for (std::size_t k = share.begin; k < share.end; ++k)
        links_[k].inside_place(lattice) = links_[k].beyond_place(lattice);
      member.barrier();  // places beyond lie in solid cells
    }
    const Range share = member.share(solid_.size());
    for (std::size_t k = share.begin; k < share.end; ++k)
      for (int i = 0; i < Stencil::size; ++i)
        std::fill_n(lattice.blocks[std::size_t(solid_[k].block)].populations.slot(i) + solid_[k].first, solid_[k].count,
                    T(0));
  }

 private:
  std::vector<WallLink> links_;
  std::vector<SolidRun> solid_;
};

}  // namespace stresslet
