/// Two equal spheres that follow each other along their line of centres, F = 6 pi eta a U lambda:
///   lambda = (4/3) sinh(alpha) sum n(n+1)/((2n-1)(2n+3)) [1 - (4 sinh^2((n+1/2) alpha) - (2n+1)^2 sinh^2(alpha)) /
///            (2 sinh((2n+1) alpha) + (2n+1) sinh(2 alpha))],   cosh(alpha) = s/2,
/// s a the distance of the centres: Stimson & Jeffery, Proc. R. Soc. A 111 (1926) 110.
#include <cmath>

#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

double exact_drag(double s) {
  const double alpha = std::acosh(s / 2), sh = std::sinh(alpha);
  double sum = 0;
  for (int n = 1; n < 200; ++n) {
    const double m = 2 * n + 1, half = std::sinh((n + 0.5) * alpha);
    if (m * alpha > 300) break;
    sum += n * (n + 1.0) / ((2 * n - 1.0) * (2 * n + 3.0)) *
           (1 - (4 * half * half - m * m * sh * sh) / (2 * std::sinh(m * alpha) + m * std::sinh(2 * alpha)));
  }
  return 4.0 / 3 * sh * sum;
}

}  // namespace

void stimson_jeffery(Trial& trial) {
  trial.row("series at s = 3", exact_drag(3), {0.698305, "table"}, relative(1e-5));
  const double radius = trial.choose(8.0, 5.0);
  trial.parameter("cells per diameter", 2 * radius);
  for (const double s : trial.choose<std::vector<double>>({2.25, 2.5, 3, 4}, {3})) {
    Unbounded setup{.scheme = default_scheme(2), .radius = radius};
    setup.speed = 5e-4;  // Reynolds number below 0.02
    setup.spheres = {{.centre = {0, -s / 2, 0}, .velocity = {0, 1, 0}},
                     {.centre = {0, s / 2, 0}, .velocity = {0, 1, 0}}};
    const auto r = run_unbounded(trial, setup, fmt::format("Stimson-Jeffery, s = {}", s));
    trial.row(fmt::format("s = {}: lambda", s), -0.5 * (r[0].force.y + r[1].force.y),
              {exact_drag(s), "Stimson & Jeffery 1926"}, relative(0.03));
  }
}

}  // namespace stresslet::validation
