#include "stresslet/simulation/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "stresslet/base/constants.hpp"
#include "stresslet/dem/laws.hpp"
#include "stresslet/lubrication/laws.hpp"
#include "stresslet/simulation/schemes/laws.hpp"

namespace stresslet {

namespace {

constexpr double typical_hertz_overlap = 0.005;  // of the smaller diameter
constexpr double largest_step = 1e-3;            // a thousandth of a diameter at the mean shear, whatever the model

struct PairScales {
  double reduced_mass, stiffness, tangential_stiffness;
  PairResistance<double> film;
};

PairScales pair_scales(const Physics& physics, double a1, double a2, double density) {
  const auto mass = [&](double a) { return density * 4 / 3 * pi * a * a * a; };
  PairScales s{};
  s.reduced_mass = mass(a1) * mass(a2) / (mass(a1) + mass(a2));
  const double overlap = typical_hertz_overlap * 2 * std::min(a1, a2), reduced_radius = a1 * a2 / (a1 + a2);
  NormalContactLaws::dispatch(physics.contact.normal_law, [&](auto tag) {
    using Law = typename decltype(tag)::type;
    s.stiffness = Law::tangent_stiffness(overlap, reduced_radius, physics.contact.stiffness);
    s.tangential_stiffness =
        physics.contact.tangential_ratio * Law::tangential_scale(overlap, reduced_radius, physics.contact.stiffness);
  });
  LubricationLaws::dispatch(physics.lubrication_law, [&](auto tag) {
    s.film = decltype(tag)::type::resistance(a1, a2, physics.cutoffs.inner * effective_diameter(a1, a2));
  });
  return s;
}

/// At most a dozen radii that stand for all, the smallest and the largest among them.
std::vector<double> representatives(std::span<const double> radii) {
  std::vector<double> sorted(radii.begin(), radii.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  constexpr std::size_t most = 12;
  if (sorted.size() <= most) return sorted;
  std::vector<double> chosen;
  for (std::size_t k = 0; k < most; ++k) chosen.push_back(sorted[k * (sorted.size() - 1) / (most - 1)]);
  return chosen;
}

/// Lowers the bound if this candidate binds.
void limit(StepBounds& b, double chosen, double largest, const char* reason) {
  if (chosen < b.chosen) b.chosen = chosen, b.binding = reason;
  b.largest = std::min(b.largest, largest);
}

void limit_by_pair(StepBounds& b, const std::string& scheme, const PairScales& s, bool friction) {
  const double contact = pi * std::sqrt(s.reduced_mass / s.stiffness);
  const double film = s.film.X > 0 ? s.reduced_mass / s.film.X : std::numeric_limits<double>::infinity();
  const double relaxation = s.film.X / s.stiffness;
  const double sliding = std::sqrt(2.0 / 7.0 * s.reduced_mass / s.tangential_stiffness);
  const double before = b.chosen;
  if (scheme == Explicit::name) {
    limit(b, contact / 50, contact / 20, "collisions (1/50 of the half period of a contact)");
    limit(b, 0.45 * film, 0.5 * film, "the thinnest film (0.45 m_eff/X_max)");
  } else {
    const bool overdamped = s.film.X > 2 * std::sqrt(s.stiffness * s.reduced_mass);
    if (overdamped || scheme == Inertialess::name)
      limit(b, 0.02 * relaxation, 0.2 * relaxation, "contacts (1/50 of the relaxation X_max/kn of an overlap)");
    else
      limit(b, contact / 50, contact / 20, "collisions (1/50 of the half period of a contact)");
    if (friction && scheme == Inertialess::name)
      limit(b, 0.3 * s.film.Y / s.tangential_stiffness, s.film.Y / s.tangential_stiffness,
            "sliding contacts (0.3 of the relaxation Y_max/kt of the tangential spring)");
    else if (friction)
      limit(b, 0.6 * sliding, 1.6 * sliding,
            "sliding contacts (0.6 of the inverse frequency of the tangential spring)");
  }
  if (b.chosen < before) {
    b.contact = contact, b.film = std::isfinite(film) ? film : 0, b.relaxation = relaxation;
    b.sliding = friction ? sliding : 0;
  }
}

}  // namespace

StepBounds step_bounds(const Physics& physics, const std::string& scheme, std::span<const double> radii,
                       double density) {
  StepBounds b;
  b.chosen = b.largest = largest_step;
  b.binding = "the mean shear (a thousandth of a diameter per step)";
  const std::vector<double> sizes = representatives(radii);
  for (double a1 : sizes)
    for (double a2 : sizes)
      if (a2 >= a1) limit_by_pair(b, scheme, pair_scales(physics, a1, a2, density), physics.contact.friction > 0);
  return b;
}

}  // namespace stresslet
