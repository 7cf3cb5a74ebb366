/// A simple cubic lattice of free spheres in simple shear, sheared boundary frozen at some strain: viscosity, normal
/// stress differences and angular velocity against the Stokes solution (method of fundamental solutions with periodic
/// Stokeslets; compare Adler, Zuzovsky & Brenner, Int. J. Multiphase Flow 11 (1985) 387), for the sphere on a node,
/// between nodes, and cut by the sheared plane.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "validation/harness/periodic_array.hpp"

namespace stresslet::validation {

namespace {

struct Exact {
  double fraction, strain, spin, viscosity, first_difference, second_difference;
};

constexpr Exact table[] = {{0.1, 0, -0.5, 1.24142, 0, 0},
                           {0.1, 0.125, -0.49783, 1.24586, -0.02641, 0.01545},
                           {0.1, 0.25, -0.49272, 1.25616, -0.03634, 0.02127},
                           {0.1, 0.5, -0.48577, 1.26973, 0, 0},
                           {0.2, 0, -0.5, 1.49709, 0, 0},
                           {0.2, 0.5, -0.47057, 1.61126, 0, 0}};

}  // namespace

void sheared_lattice(Trial& trial) {
  const char* source = "Stokes solution";
  for (const Exact& exact : table) {
    if (trial.quick() && exact.strain != 0.25) continue;
    const int edge = exact.fraction == 0.1 ? 17 : 14;
    const double radius = std::cbrt(exact.fraction * std::pow(edge, 3) * 3 / (4 * pi)), middle = 0.5 * (edge - 1);
    const std::pair<const char*, Vec3<double>> places[] = {{"middle", {middle, middle, middle}},
                                                           {"off node", {middle + 0.5, middle + 0.4, middle - 0.3}},
                                                           {"on the sheared plane", {3, edge - 0.6, middle}}};
    for (const auto& [name, centre] : places) {
      if (trial.quick() && centre.x != 3) continue;
      const ArrayRheology r = sheared_cubic_lattice(trial, default_scheme(1), edge, radius, exact.strain, centre);
      const std::string where = fmt::format("phi {}, strain {}, {}: ", exact.fraction, exact.strain, name);
      trial.row(where + "viscosity", r.viscosity, {exact.viscosity, source},
                relative(exact.fraction == 0.1 ? 0.003 : 0.01));
      trial.row(where + "angular velocity", r.spin, {exact.spin, source}, relative(0.012));
      // At the mirror points of the strain both differences vanish; elsewhere 3 %.
      const double nought = 5e-4;
      trial.row(where + "N1", r.first_difference, {exact.first_difference, source},
                exact.first_difference == 0 ? absolute(nought) : relative(0.03));
      trial.row(where + "N2", r.second_difference, {exact.second_difference, source},
                exact.second_difference == 0 ? absolute(nought) : relative(0.03));
    }
  }
}

}  // namespace stresslet::validation
