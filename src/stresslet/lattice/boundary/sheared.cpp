#include "stresslet/lattice/boundary/sheared.hpp"

#include <cmath>

#include "stresslet/base/unroll.hpp"
#include "stresslet/exec/first_lanes.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

template <class Stencil>
CellPopulations<Stencil, Pack> in_pairs(const std::array<Pack, Stencil::size>& f) {
  CellPopulations<Stencil, Pack> cell;
  cell.rest = f[0];
  for (int k = 0; k < Stencil::pairs; ++k) {
    const int i = first_of_pair(k);
    cell.pair[k] = {f[i] + f[i + 1], f[i] - f[i + 1]};
  }
  return cell;
}

/// feq_i(u + jump x) - feq_i(u), with the difference written out.
template <class Stencil, int i, class R>
R equilibrium_change(const R& density, const Vec3<R>& velocity, double jump) {
  constexpr double w = Stencil::weight[i], cx = Stencil::velocity[i][0];
  const R along_c = along<Stencil, i>(velocity);
  return w * jump * density * (3 * cx + cx * (9 * along_c + 4.5 * cx * jump) - 3 * velocity.x - 1.5 * jump);
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
template <int up>
void ShearedBoundary<Stencil, T>::collect_side(const Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) {
  constexpr auto crossing_of_side = crossing_populations(up);
  constexpr int side = up > 0 ? 0 : 1;
  const double jump = -up * lattice.shear_velocity;
  const Vec3<double>& force = lattice.input.force_density;
  const Vec3<Pack> half_force{0.5 * force.x, 0.5 * force.y, 0.5 * force.z};
  for (const auto& block : lattice.blocks) {
    const BlockLayout& layout = block.populations.layout();
    const int y = (up > 0 ? ny_ - 1 : 0) - block.origin[1];
    if (y < 0 || y >= layout.size()[1]) continue;
    std::array<const T*, Stencil::size> sent;  // what cells sent out, where it still lies
    for (int i = 0; i < Stencil::size; ++i) sent[i] = block.populations.source(opposite(i), swept);
    const Range planes = member.share(std::size_t(layout.size()[2]));
    for (int z = int(planes.begin); z < int(planes.end); ++z)
      for (int x = 0; x < layout.size()[0]; x += int(pack_width)) {
        const int cells = layout.size()[0] - x;
        std::array<Pack, Stencil::size> f;
        for (int i = 0; i < Stencil::size; ++i) f[i] = load_first<Pack>(sent[i] + layout.index(x, y, z), cells);
        const Moments<Pack> m = moments_of(in_pairs<Stencil>(f));
        const Pack density = m.density();
        const Vec3<Pack> u = (m.momentum - half_force) / density;
        Pack mass = 1.0 / 6;
        for (const int i : crossing_of_side) mass += f[i];
        const Pack missing = 0.5 * jump * (mass - density * (1.0 / 6 + 0.5 * up * u.y));
        unroll<crossing>([&](auto k) {
          constexpr int i = crossing_of_side[k];
          constexpr auto c = Stencil::velocity[i];
          Pack value = f[i] + equilibrium_change<Stencil, i>(density, u, jump);
          if constexpr (c[2] == 0) value += double(c[0]) * missing;
          store_first(row(side, k, block.origin[2] + z) + block.origin[0] + x, value, cells);
        });
      }
  }
}

template <class Stencil, class T>
void ShearedBoundary<Stencil, T>::collect(const Lattice<Stencil, T>& lattice, Arrangement swept, Member& member) {
  collect_side<1>(lattice, swept, member);
  collect_side<-1>(lattice, swept, member);
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
