#include "stresslet/coupling/sheared_plane.hpp"

#include "stresslet/lattice/stencil/d3q19.hpp"

namespace stresslet {

namespace {

/// Momentum along x and mass of the populations that arrived through the plane, `up` +1 or -1; row by row, in order.
struct Arrived {
  double momentum = 0, mass = 0;
};

template <class Stencil, class T>
Arrived arrived(const Lattice<Stencil, T>& lattice, int up) {
  const Grid& grid = lattice.grid;
  const int global_y = up > 0 ? 0 : grid.size[1] - 1;
  std::vector<Arrived> cells(std::size_t(grid.size[0]) * std::size_t(grid.size[2]));
  for (const auto& block : lattice.blocks) {
    const BlockLayout& layout = block.populations.layout();
    const int y = global_y - block.origin[1];
    if (y < 0 || y >= layout.size()[1]) continue;
    for (int z = 0; z < layout.size()[2]; ++z)
      for (int x = 0; x < layout.size()[0]; ++x) {
        Arrived& cell =
            cells[std::size_t(block.origin[0] + x) + std::size_t(grid.size[0]) * std::size_t(block.origin[2] + z)];
        for (int i = 1; i < Stencil::size; ++i) {
          if (Stencil::velocity[i][1] != up) continue;
          const double f = double(block.populations.source(i, lattice.arrangement)[layout.index(x, y, z)]);
          cell.momentum += Stencil::velocity[i][0] * f;
          cell.mass += f + Stencil::weight[i];
        }
      }
  }
  Arrived sum;
  for (const Arrived& cell : cells) sum.momentum += cell.momentum, sum.mass += cell.mass;
  return sum;
}

}  // namespace

template <class Stencil, class T>
double fluid_momentum_across(const Lattice<Stencil, T>& lattice) {
  const Arrived up = arrived(lattice, 1), down = arrived(lattice, -1);
  return up.momentum - down.momentum + 0.5 * lattice.shear_velocity * (up.mass + down.mass);
}

/// A wall that turns f'_j into f_i = f'_j + 6 w_i c_i.u gives  c_i f_i - c_j f'_j = c_i (2 f_i - 6 w_i c_i.u),  and the
/// weights of the five populations that it turns add up to  sum w_i c_ix^2 = 1/18.
template <class Stencil, class T>
double wall_momentum_upwards(const Lattice<Stencil, T>& lattice, double velocity_difference) {
  const double cells = double(lattice.grid.size[0]) * lattice.grid.size[2];
  return arrived(lattice, 1).momentum - arrived(lattice, -1).momentum + velocity_difference * cells / 6;
}

double solid_momentum_across(const std::vector<ExchangeAcross>& across, const std::vector<ResolvedSphere>& spheres) {
  double sum = 0;
  for (const ExchangeAcross& part : across) {
    const ResolvedSphere& sphere = spheres[std::size_t(part.sphere)];
    sum += part.images_up * load_on_sphere(part.sums, sphere.velocity, sphere.angular_velocity).force.x;
  }
  return sum;
}

template double fluid_momentum_across(const Lattice<D3Q19, double>&);
template double fluid_momentum_across(const Lattice<D3Q19, float>&);
template double wall_momentum_upwards(const Lattice<D3Q19, double>&, double);
template double wall_momentum_upwards(const Lattice<D3Q19, float>&, double);

}  // namespace stresslet
