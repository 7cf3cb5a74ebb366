#pragma once
/// Lees-Edwards boundary for populations: the faces across y are periodic, but the image above moves with the shear
/// velocity U and is displaced by the offset d along x (Wagner & Pagonabarraga, J. Stat. Phys. 107 (2002) 521).
///
/// A population that leaves through the top, collided at density rho and velocity u, enters at the bottom as
///   f_i + feq_i(rho, u - U x) - feq_i(rho, u) + m_i,    m_i = -U/2 [sum_up f - rho (1/6 + u_y/2)] c_ix  for c_i =
///   (+-1, 1, 0),
/// taken from the row at x - c_ix + d by interpolation; opposite signs of U and d at the top. The equilibria are of
/// second order in u; m makes the momentum exact: whatever mass crosses carries exactly -U x of momentum more. So
///   sum momentum_x + U * (mass that has crossed upwards, net)
/// is conserved to round-off, as for particles. d is the offset at the time of the collision.
///
/// Reads 19 and writes 10 populations per cell of the two rim rows: of the order of 2/ny of the bulk.
#include "stresslet/lattice/boundary/interpolation.hpp"
#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

template <class Stencil, class T>
class ShearedBoundary : public Boundary<Stencil, T> {
 public:
  ShearedBoundary(const Grid& grid, std::string_view interpolation);

  bool looks_across() const override { return false; }

  void before_sweep(Lattice<Stencil, T>& lattice, Member& member) override;
  void look_after_sweep(const Lattice<Stencil, T>& lattice, Member& member) override;
  void after_sweep(Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) override;

 private:
  static constexpr int crossing = Stencil::dimensions == 2 ? 3 : (Stencil::size == 27 ? 9 : 5);
  /// Populations with c_y = `up` (+1 or -1).
  static constexpr std::array<int, crossing> crossing_populations(int up);

  void collect(const Lattice<Stencil, T>& lattice, Arrangement swept, Member& member);
  template <int up>
  void collect_side(const Lattice<Stencil, T>& lattice, Arrangement swept, Member& member);
  void deliver(Lattice<Stencil, T>& lattice, Arrangement next, double offset, Member& member) const;
  double* row(int side, int k, int z) {
    return departed_.data() + std::size_t(nx_) * (std::size_t(z) + std::size_t(nz_) * std::size_t(k + crossing * side));
  }
  const double* row(int side, int k, int z) const { return const_cast<ShearedBoundary*>(this)->row(side, k, z); }

  int nx_, ny_, nz_;
  bool wraps_in_z_;
  std::array<double, 4> (*weights_)(double) = nullptr;
  std::vector<double> departed_;  ///< [side: 0 through the top, 1 through the bottom][population][z][x], transformed
};

}  // namespace stresslet
