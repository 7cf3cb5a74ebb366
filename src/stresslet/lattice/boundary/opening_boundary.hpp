#pragma once
/// Openings: the populations that come in through a face, on the last layer of cells, from those that are known.
///
/// Non-equilibrium bounce-back with the transverse momentum put right, in the form of Hecht & Harting, J. Stat. Mech.
/// (2010) P01018, eqs. 13-19, for any stencil of velocity components -1, 0, 1 and any face of inward normal n:
///   f_i = f_opposite(i) + w_i (6 c_i.m + c_i.q),   c_i.n > 0,
///   q = 18 (2/3 m_t - sum over c.n = 0 of f c),    m = sum f c as prescribed, m_t its part along the face,
/// since   sum over c.n > 0 of w c_t c_t = 1/18.
///
/// Regularised (Latt, Chopard, Malaspinas, Deville & Michler, Phys. Rev. E 77 (2008) 056703, eqs. 24-27): all
/// populations of the cell become  f_i = feq_i + 9/2 w_i (c_i c_i - 1/3) : Pi,  Pi the second moment of f - feq with
/// the unknown f - feq taken from the opposite ones. This is done last before the sweep and once a step, so that
/// filling may be repeated.
///
/// Reads all known populations of the cells of a face, writes five (nine, three), or all; every sweep.
#include <vector>

#include "stresslet/lattice/boundary/openings.hpp"
#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

struct CellAt {
  int block;
  std::size_t index;
};

template <class Stencil, class T, class Law>
class OpeningBoundary : public Boundary<Stencil, T> {
 public:
  /// `cells`: those of the last layer before the face at `side` (-1 low, 1 high) of `axis`.
  OpeningBoundary(int axis, int side, const FaceSetup& face, std::vector<CellAt> cells)
      : axis_(axis), side_(side), face_(face), cells_(std::move(cells)) {
    inward_ = {axis == 0 ? -side : 0.0, axis == 1 ? -side : 0.0, axis == 2 ? -side : 0.0};
  }

  void before_sweep(Lattice<Stencil, T>& lattice, Member& member) override {
    for_each_cell(lattice, member, [&](auto& place) {
      const auto [state, along] = known(lattice, place);
      const Vec3<double> q = tangential_part(12.0 * state.momentum - 18.0 * along, inward_);
      for (int i = 1; i < Stencil::size; ++i)
        if (moves(i) == Moves::inwards)
          place(i) = T(double(place(opposite(i))) + Stencil::weight[i] * dot(direction(i), 6.0 * state.momentum + q));
    });
  }

  void replace_before_sweep(Lattice<Stencil, T>& lattice, Member& member) override {
    if constexpr (Law::regularised)
      for_each_cell(lattice, member, [&](auto& place) {
        const OpeningState state = known(lattice, place).state;
        const double density = 1 + state.density_deviation;
        const Vec3<double> u = (state.momentum + 0.5 * lattice.input.force_density) / density;
        const auto equilibrium = [&](int i) {
          const double cu = dot(direction(i), u);
          return Stencil::weight[i] * (state.density_deviation + 3 * dot(direction(i), state.momentum) +
                                       density * (4.5 * cu * cu - 1.5 * dot(u, u)));
        };
        SymTensor3<double> stress{};
        for (int i = 1; i < Stencil::size; ++i)
          if (moves(i) != Moves::inwards)
            stress += ((moves(i) == Moves::along ? 1 : 2) * (double(place(i)) - equilibrium(i))) * square(direction(i));
        for (int i = 0; i < Stencil::size; ++i) {
          const double projected = 4.5 * dot(direction(i), stress * direction(i)) - 1.5 * trace(stress);
          place(i) = T(equilibrium(i) + Stencil::weight[i] * projected);
        }
      });
  }

 private:
  enum class Moves { inwards, along, outwards };
  struct Known {
    OpeningState state;
    Vec3<double> along;  ///< momentum of the populations that move along the face
  };

  Moves moves(int i) const {
    const int outwards = side_ * Stencil::velocity[i][std::size_t(axis_)];
    return outwards < 0 ? Moves::inwards : outwards > 0 ? Moves::outwards : Moves::along;
  }

  static Vec3<double> direction(int i) {
    const auto& c = Stencil::velocity[i];
    return {double(c[0]), double(c[1]), double(c[2])};
  }

  /// Calls `body(place)` for this member's share of the cells; place(i) is where incoming population i lies.
  template <class Body>
  void for_each_cell(Lattice<Stencil, T>& lattice, Member& member, Body&& body) {
    const Range share = member.share(cells_.size());
    for (std::size_t k = share.begin; k < share.end; ++k) {
      const auto& populations = lattice.blocks[std::size_t(cells_[k].block)].populations;
      const auto place = [&](int i) -> T& { return populations.source(i, lattice.arrangement)[cells_[k].index]; };
      body(place);
    }
  }

  template <class Place>
  Known known(const Lattice<Stencil, T>& lattice, const Place& place) const {
    double arrived = 0;
    Vec3<double> along{};
    for (int i = 0; i < Stencil::size; ++i) {
      if (moves(i) == Moves::inwards) continue;
      const double f = place(i);
      arrived += moves(i) == Moves::along ? f : 2 * f;
      if (moves(i) == Moves::along) along += f * direction(i);
    }
    return {Law::state(arrived, inward_, face_, lattice.input.force_density), along};
  }

  int axis_, side_;
  FaceSetup face_;
  Vec3<double> inward_;
  std::vector<CellAt> cells_;
};

}  // namespace stresslet
