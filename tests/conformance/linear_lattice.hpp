#pragma once
/// What one plane wave does under the linearised lattice Boltzmann equation with two relaxation times (von Neumann
/// analysis, Lallemand & Luo, Phys. Rev. E 61 (2000) 6546): written from the definitions, population by population,
/// without any code of the lattice but its tables.
#include <Eigen/Dense>
#include <complex>

#include "stresslet/base/vec3.hpp"

namespace stresslet::testing {

/// Factor per step of the shear wave exp(i k.x) of this polarisation, continued from exp(-nu k^2).
template <class Stencil>
double shear_wave_factor(const Vec3<double>& k, const Vec3<double>& polarisation, double even_rate, double odd_rate) {
  constexpr int n = Stencil::size;
  const auto c = [](int i) {
    const auto& v = Stencil::velocity[std::size_t(i)];
    return Vec3<double>{double(v[0]), double(v[1]), double(v[2])};
  };
  const auto reversed = [&](int i) {
    for (int j = 0; j < n; ++j)
      if (c(j) == -c(i)) return j;
    return -1;
  };
  Eigen::MatrixXcd step(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double w = Stencil::weight[std::size_t(i)];
      const double same = i == j, opposite = reversed(i) == j;
      const double even = 0.5 * (same + opposite) - w, odd = 0.5 * (same - opposite) - 3 * w * dot(c(i), c(j));
      step(i, j) = std::polar(1.0, -dot(k, c(i))) * (same - even_rate * even - odd_rate * odd);
    }
  const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> modes(step);
  const double expected = std::exp(-(1 / even_rate - 0.5) / 3 * dot(k, k));
  std::complex<double> best = 0;
  for (int m = 0; m < n; ++m) {
    std::complex<double> momentum = 0;
    for (int i = 0; i < n; ++i) momentum += modes.eigenvectors()(i, m) * dot(c(i), polarisation);
    if (std::abs(momentum) > 0.01 && std::abs(modes.eigenvalues()(m) - expected) < std::abs(best - expected))
      best = modes.eigenvalues()(m);
  }
  return best.real();
}

}  // namespace stresslet::testing
