#include "stresslet/lattice/boundary/sheared.hpp"

#include <cmath>

#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

/// The populations that a cell sent out in the sweep that started from `swept`, as they still lie.
template <class Stencil, class T>
std::array<double, Stencil::size> outgoing(const Populations<Stencil, T>& populations, Arrangement swept,
                                           std::size_t index) {
  std::array<double, Stencil::size> f;
  for (int i = 0; i < Stencil::size; ++i) f[i] = populations.source(opposite(i), swept)[index];
  return f;
}

template <class Stencil>
CellPopulations<Stencil, double> in_pairs(const std::array<double, Stencil::size>& f) {
  CellPopulations<Stencil, double> cell;
  cell.rest = f[0];
  for (int k = 0; k < Stencil::pairs; ++k) {
    const int i = first_of_pair(k);
    cell.pair[k] = {f[i] + f[i + 1], f[i] - f[i + 1]};
  }
  return cell;
}

template <class Stencil>
std::array<double, Stencil::size> equilibrium(double density_deviation, const Vec3<double>& velocity) {
  const Equilibrium<Stencil, double> eq(density_deviation, velocity);
  std::array<double, Stencil::size> f;
  f[0] = eq.rest();
  unroll<Stencil::pairs>([&](auto k) {
    const EvenOdd<double> pair = eq.template pair<first_of_pair(k)>();
    f[first_of_pair(k)] = 0.5 * (pair.even + pair.odd);
    f[first_of_pair(k) + 1] = 0.5 * (pair.even - pair.odd);
  });
  return f;
}

int wrapped(int k, int n) { return ((k % n) + n) % n; }

}  // namespace

template <class Stencil, class T>
constexpr std::array<int, ShearedBoundary<Stencil, T>::crossing> ShearedBoundary<Stencil, T>::crossing_populations(
    int up) {
  std::array<int, crossing> found{};
  int count = 0;
  for (int i = 1; i < Stencil::size; ++i)
    if (Stencil::velocity[i][1] == up) found[count++] = i;
  return found;
}

template <class Stencil, class T>
ShearedBoundary<Stencil, T>::ShearedBoundary(const Grid& grid, std::string_view interpolation)
    : nx_(grid.size[0]),
      ny_(grid.size[1]),
      nz_(grid.size[2]),
      wraps_in_z_(grid.closure[2] == Closure::periodic),
      departed_(std::size_t(2 * crossing) * std::size_t(nx_) * std::size_t(nz_)) {
  ShearInterpolations::dispatch(interpolation, [&](auto law) { weights_ = decltype(law)::type::weights; });
}

template <class Stencil, class T>
void ShearedBoundary<Stencil, T>::collect(const Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) {
  const Vec3<double> half_force = 0.5 * lattice.input.force_density;
  for (int side = 0; side < 2; ++side) {
    const int up = side == 0 ? 1 : -1;
    constexpr std::array<std::array<int, crossing>, 2> populations_of_side{crossing_populations(1),
                                                                           crossing_populations(-1)};
    const auto& crossing_of_side = populations_of_side[std::size_t(side)];
    const double jump = -up * lattice.shear_velocity;
    for (const auto& block : lattice.blocks) {
      const BlockLayout& layout = block.populations.layout();
      const int y = (up > 0 ? ny_ - 1 : 0) - block.origin[1];
      if (y < 0 || y >= layout.size()[1]) continue;
      const Range planes = member.share(std::size_t(layout.size()[2]));
      for (int z = int(planes.begin); z < int(planes.end); ++z)
        for (int x = 0; x < layout.size()[0]; ++x) {
          const auto f = outgoing(block.populations, swept, layout.index(x, y, z));
          const Moments<double> m = moments_of(in_pairs<Stencil>(f));
          const Vec3<double> u = (m.momentum - half_force) / m.density();
          const auto here = equilibrium<Stencil>(m.density_deviation, u);
          const auto there = equilibrium<Stencil>(m.density_deviation, {u.x + jump, u.y, u.z});
          double mass = 1.0 / 6;
          for (const int i : crossing_of_side) mass += f[i];
          const double missing = 0.5 * jump * (mass - m.density() * (1.0 / 6 + 0.5 * up * u.y));
          for (int k = 0; k < crossing; ++k) {
            const int i = crossing_of_side[k];
            const auto& c = Stencil::velocity[i];
            row(side, k, block.origin[2] + z)[block.origin[0] + x] =
                f[i] + (there[i] - here[i]) + (c[2] == 0 ? c[0] * missing : 0);
          }
        }
    }
  }
}

template <class Stencil, class T>
void ShearedBoundary<Stencil, T>::deliver(Lattice<Stencil, T>& lattice, Arrangement next, double offset,
                                          Member& member) const {
  for (int side = 0; side < 2; ++side) {
    const int up = side == 0 ? 1 : -1;
    const auto crossing_of_side = crossing_populations(up);
    const double shift = up * offset, whole = std::floor(shift);
    const std::array<double, 4> weight = weights_(shift - whole);
    for (auto& block : lattice.blocks) {
      const BlockLayout& layout = block.populations.layout();
      const int y = (up > 0 ? 0 : ny_ - 1) - block.origin[1];
      if (y < 0 || y >= layout.size()[1]) continue;
      const Range planes = member.share(std::size_t(layout.size()[2]));
      for (int z = int(planes.begin); z < int(planes.end); ++z)
        for (int k = 0; k < crossing; ++k) {
          const int i = crossing_of_side[k];
          const auto& c = Stencil::velocity[i];
          const int from_z = block.origin[2] + z - c[2];
          if (!wraps_in_z_ && (from_z < 0 || from_z >= nz_)) continue;
          const double* from = row(side, k, wrapped(from_z, nz_));
          T* to = block.populations.source(i, next) + layout.index(0, y, z);
          int left = wrapped(block.origin[0] - c[0] + int(whole) - 1, nx_);
          for (int x = 0; x < layout.size()[0]; ++x) {
            double value = 0;
            for (int n = 0, at = left; n < 4; ++n) {
              value += weight[n] * from[at];
              if (++at == nx_) at = 0;
            }
            to[x] = T(value);
            if (++left == nx_) left = 0;
          }
        }
    }
  }
}

template <class Stencil, class T>
void ShearedBoundary<Stencil, T>::before_sweep(Lattice<Stencil, T>& lattice, Member& member) {
  if (lattice.arrangement != Arrangement::departing) return;
  collect(lattice, Arrangement::arrived, member);
  member.barrier();
  deliver(lattice, Arrangement::departing, lattice.departure_offset, member);
}

template <class Stencil, class T>
void ShearedBoundary<Stencil, T>::look_after_sweep(const Lattice<Stencil, T>& lattice, Member& member) {
  if (lattice.arrangement == Arrangement::departing) collect(lattice, Arrangement::departing, member);
}

template <class Stencil, class T>
void ShearedBoundary<Stencil, T>::after_sweep(Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) {
  if (swept == Arrangement::departing) deliver(lattice, Arrangement::arrived, lattice.shear_offset, member);
}

template class ShearedBoundary<D3Q19, double>;
template class ShearedBoundary<D3Q19, float>;
template class ShearedBoundary<D2Q9, double>;
template class ShearedBoundary<D3Q27, double>;

}  // namespace stresslet
