#include "stresslet/lubrication/two_spheres_exact.hpp"

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/error.hpp"

namespace stresslet {
namespace {

using Matrix = Eigen::MatrixXd;

/// A function of multipole orders n (row) and s (column), both from 1.
template <class Entry>
Matrix coefficients(int order, Entry&& entry) {
  Matrix m(order, order);
  for (int n = 1; n <= order; ++n)
    for (int s = 1; s <= order; ++s) m(n - 1, s - 1) = entry(n, s);
  return m;
}

/// How the multipoles of the other sphere act on those of one sphere: its radius over the centre distance is t, that
/// of the other is u. Coefficients of Jeffrey & Onishi (1984), recursions for X^A, Y^A, X^C.
struct Coupling {
  Matrix pp, pv, vp, pq, qp, qq;
};

/// binomial(n + s, k) t^(n-1) u^s, which no power alone would keep in range.
double weight(int n, int s, int k, double t, double u) {
  return std::exp(std::lgamma(n + s + 1) - std::lgamma(k + 1) - std::lgamma(n + s - k + 1) + (n - 1) * std::log(t) +
                  s * std::log(u));
}

Coupling axial_coupling(int order, double t, double u) {
  const auto c = [&](int n, int s) { return weight(n, s, n, t, u); };
  Coupling k;
  k.pp = coefficients(order, [&](double n, double s) {
    return c(int(n), int(s)) * (n * (2 * n + 1) * (2 * n * s - n - s + 2) / (2 * (n + 1) * (2 * s - 1) * (n + s)) -
                                n * (2 * n - 1) / (2 * (n + 1)) * t * t);
  });
  k.pv = coefficients(order, [&](double n, double s) {
    return -c(int(n), int(s)) * n * (4 * n * n - 1) / (2 * (n + 1) * (2 * s + 1)) * u * u;
  });
  k.vp = coefficients(order,
                      [&](double n, double s) { return -c(int(n), int(s)) * 2 * n / ((n + 1) * (2 * n + 3)) * t * t; });
  k.qq = coefficients(order, [&](double n, double s) { return c(int(n), int(s)) * s / (n + 1) * t * u; });
  return k;
}

Coupling transverse_coupling(int order, double t, double u) {
  const auto c = [&](int n, int s) { return weight(n, s, n + 1, t, u); };
  Coupling k;
  k.pp = coefficients(order, [&](double n, double s) {
    return c(int(n), int(s)) * ((2 * n + 1) / (2 * (n + 1)) * (3 * (n + s) - (n * s + 1) * (2 * n * s - s - n + 2)) /
                                    (s * (n + s) * (2 * s - 1)) +
                                n * (2 * n - 1) / (2 * (n + 1)) * t * t);
  });
  k.pv = coefficients(order, [&](double n, double s) {
    return c(int(n), int(s)) * n * (4 * n * n - 1) / (2 * (n + 1) * (2 * s + 1)) * u * u;
  });
  k.pq = coefficients(order,
                      [&](double n, double s) { return -c(int(n), int(s)) * 2 * (4 * n * n - 1) / (3 * (n + 1)) * u; });
  k.vp = coefficients(order,
                      [&](double n, double s) { return c(int(n), int(s)) * 2 * n / ((n + 1) * (2 * n + 3)) * t * t; });
  k.qq = coefficients(order, [&](double n, double s) { return c(int(n), int(s)) * s / (n + 1) * t * u; });
  k.qp = coefficients(order, [&](double n, double s) { return -c(int(n), int(s)) * 3 / (2 * n * s * (n + 1)) * t; });
  return k;
}

/// Rows p1, p2: p_a = given + pp p_b + pv v_b + pq q_b with v_b = p_b + vp p_a put in; then q1, q2.
Matrix system(const Coupling& one, const Coupling& two, bool spin) {
  const Eigen::Index m = one.pp.rows(), blocks = spin ? 4 : 2;
  Matrix a = Matrix::Identity(blocks * m, blocks * m);
  const std::array<const Coupling*, 2> of{&one, &two};
  for (Eigen::Index i = 0; i < 2; ++i) {
    const Eigen::Index j = 1 - i;
    const Coupling &k = *of[std::size_t(i)], &other = *of[std::size_t(j)];
    a.block(i * m, j * m, m, m) -= k.pp + k.pv;
    a.block(i * m, i * m, m, m).noalias() -= k.pv * other.vp;
    if (!spin) continue;
    a.block(i * m, (2 + j) * m, m, m) -= k.pq;
    a.block((2 + i) * m, (2 + j) * m, m, m) -= k.qq;
    a.block((2 + i) * m, j * m, m, m) -= k.qp;
  }
  return a;
}

TwoSphereResistance with_order(int order, double a1, double a2, double distance) {
  const double t1 = a1 / distance, t2 = a2 / distance;
  const std::array<double, 2> a{a1, a2};
  const Eigen::Index m = order;
  TwoSphereResistance f{};
  // Sphere k moves, sphere i answers. The functions of unlike spheres change sign with the axis that each has.
  const auto place = [](std::size_t i, std::size_t k) { return 2 * i + k; };
  const auto unit = [&](Eigen::Index rows, std::initializer_list<Eigen::Index> ones) {
    Matrix right = Matrix::Zero(rows, Eigen::Index(ones.size()));
    Eigen::Index column = 0;
    for (const Eigen::Index one : ones) right(one, column++) = 1;
    return right;
  };
  {
    const Coupling one = axial_coupling(order, t1, t2), two = axial_coupling(order, t2, t1);
    const Matrix p = system(one, two, false).partialPivLu().solve(unit(2 * m, {0, m}));
    Matrix spin = Matrix::Identity(2 * m, 2 * m);
    spin.block(0, m, m, m) -= one.qq;
    spin.block(m, 0, m, m) -= two.qq;
    const Matrix q = spin.partialPivLu().solve(unit(2 * m, {0, m}));
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        const Eigen::Index row = Eigen::Index(i) * m, column = Eigen::Index(k);
        f.XA[place(i, k)] = (i == k ? 1 : -1) * 6 * pi * a[i] * p(row, column);
        f.XC[place(i, k)] = (i == k ? 1 : -1) * 8 * pi * a[i] * a[i] * a[k] * q(row, column);
      }
  }
  const Coupling one = transverse_coupling(order, t1, t2), two = transverse_coupling(order, t2, t1);
  const Matrix x = system(one, two, true).partialPivLu().solve(unit(4 * m, {0, m, 2 * m, 3 * m}));
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const Eigen::Index row = Eigen::Index(i) * m, column = Eigen::Index(k);
      f.YA[place(i, k)] = (i == k ? 1 : -1) * 6 * pi * a[i] * x(row, column);
      f.YB[place(i, k)] = (i == k ? 1 : -1) * (i == 0 ? 1 : -1) * 8 * pi * a[i] * a[i] * x(2 * m + row, column);
      f.YC[place(i, k)] = 8 * pi * a[i] * a[i] * a[k] * x(2 * m + row, 2 + column);
    }
  return f;
}

double change(const TwoSphereResistance& coarse, const TwoSphereResistance& fine) {
  double largest = 0;
  for (const auto member : {&TwoSphereResistance::XA, &TwoSphereResistance::YA, &TwoSphereResistance::YB,
                            &TwoSphereResistance::XC, &TwoSphereResistance::YC}) {
    double scale = 0, difference = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      scale = std::max(scale, std::abs((fine.*member)[i]));
      difference = std::max(difference, std::abs((fine.*member)[i] - (coarse.*member)[i]));
    }
    largest = std::max(largest, difference / scale);
  }
  return largest;
}

}  // namespace

TwoSphereResistance exact_two_spheres(double a1, double a2, double gap, double tolerance) {
  if (!(a1 > 0 && a2 > 0 && gap > 0))
    throw InputError({"",
                      "two spheres of radii " + std::to_string(a1) + " and " + std::to_string(a2) + " with a gap of " +
                          std::to_string(gap),
                      "the resistance functions need all three above 0", "separate the spheres"});
  const double distance = a1 + a2 + gap;
  TwoSphereResistance before = with_order(12, a1, a2, distance);
  for (int order = 18; order < 700; order = order * 3 / 2) {
    const TwoSphereResistance now = with_order(order, a1, a2, distance);
    if (change(before, now) < tolerance) return now;
    before = now;
  }
  throw InputError({"", "two spheres with a gap of " + std::to_string(gap / (a1 + a2)) + " times the sum of the radii",
                    "their multipole series needs more terms than fit", "use the near-contact forms"});
}

Eigen::Matrix<double, 12, 12> resistance_matrix(const TwoSphereResistance& f, const Vec3<double>& e) {
  const Eigen::Vector3d n(e.x, e.y, e.z);
  const Eigen::Matrix3d along = n * n.transpose(), across = Eigen::Matrix3d::Identity() - along;
  Eigen::Matrix3d turn;  // turn u = e x u
  turn << 0, -n(2), n(1), n(2), 0, -n(0), -n(1), n(0), 0;
  Eigen::Matrix<double, 12, 12> r;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k) {
      const std::size_t ik = std::size_t(2 * i + k), ki = std::size_t(2 * k + i);
      r.block<3, 3>(6 * i, 6 * k) = f.XA[ik] * along + f.YA[ik] * across;
      r.block<3, 3>(6 * i, 6 * k + 3) = f.YB[ki] * turn;
      r.block<3, 3>(6 * i + 3, 6 * k) = -f.YB[ik] * turn;
      r.block<3, 3>(6 * i + 3, 6 * k + 3) = f.XC[ik] * along + f.YC[ik] * across;
    }
  return r;
}

}  // namespace stresslet
