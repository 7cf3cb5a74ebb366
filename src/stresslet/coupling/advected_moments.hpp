#pragma once
/// What motion past the lattice adds to the odd populations.
///
/// Of a flow that passes the lattice with u, the third moments are out of equilibrium by (Chapman & Enskog)
///   sum n c_i^2 c_j = (tau_odd/tau) (u_j Pi_ii + 2 u_i Pi_ij) + what a flow at rest has,
/// Pi the non-equilibrium stress: for one relaxation time the recursion of Malaspinas, arXiv:1505.06900 (2015); odd
/// populations that relax with a time of their own carry tau_odd/tau times that. In the Hermite basis of the lattice,
/// with H = (c_i^2 - 1/3) c_j,
///   n = 27/2 w sum over i != j of H (tau_odd/tau) (u_j Pi_ii + 2 u_i Pi_ij),
/// which D3Q19, though its H are not orthogonal, holds exactly. Its square is no energy that the flow loses: with
/// tau_odd - 1/2 = Lambda/(3 nu) it grows with (u/nu)^2, at a viscosity of 0.02 and u = 0.05 to 6 % of the dissipation.
#include <array>

#include "stresslet/coupling/operators/kinetic_stress.hpp"
#include "stresslet/lattice/moments.hpp"

namespace stresslet {

template <class R>
class AdvectedMoments {
 public:
  /// `odd_to_shear`: tau_odd/tau.
  AdvectedMoments(const Vec3<R>& u, const SymTensor3<R>& stress, const R& odd_to_shear) {
    const auto third = [&](const R& u_i, const R& u_j, const R& pi_ii, const R& pi_ij) {
      return odd_to_shear * (u_j * pi_ii + as<R>(2) * u_i * pi_ij);
    };
    const SymTensor3<R>& s = stress;
    along_[0] = {as<R>(0), third(u.y, u.x, s.yy, s.xy), third(u.z, u.x, s.zz, s.xz)};
    along_[1] = {third(u.x, u.y, s.xx, s.xy), as<R>(0), third(u.z, u.y, s.zz, s.yz)};
    along_[2] = {third(u.x, u.z, s.xx, s.xz), third(u.y, u.z, s.yy, s.yz), as<R>(0)};
  }

  /// Odd part of the pair whose first population is `i`.
  template <class Stencil, int i>
  R odd() const {
    constexpr auto c = Stencil::velocity[i];
    R sum = as<R>(0);
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        sum += as<R>(27 * Stencil::weight[i] * c[j] * (c[k] * c[k] - 1.0 / 3)) * along_[std::size_t(j)][std::size_t(k)];
    return sum;
  }

 private:
  std::array<std::array<R, 3>, 3> along_;  ///< [j][i]: of sum n c_i^2 c_j; zero for i = j
};

/// Populations without it.
template <class Stencil, class R>
CellPopulations<Stencil, R> without_advected_moments(CellPopulations<Stencil, R> f, const Vec3<R>& velocity,
                                                     const R& odd_to_shear) {
  const AdvectedMoments<R> advected(velocity, non_equilibrium_stress(f, velocity), odd_to_shear);
  unroll<Stencil::pairs>([&](auto k) { f.pair[k].odd -= advected.template odd<Stencil, first_of_pair(k)>(); });
  return f;
}

}  // namespace stresslet
