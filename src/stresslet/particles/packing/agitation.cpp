#include "stresslet/particles/packing/agitation.hpp"

#include <algorithm>

namespace stresslet {

namespace {

constexpr double wanted_acceptance = 1.0 / 3;
constexpr double first_move = 0.05, shortest_move = 1e-6;  // in mean diameters
constexpr double least_skin = 0.25;                        // in mean diameters
constexpr double longest_move = 0.25;  // in skins: along all axes less than half of one, so that lists last a while

/// A skin that grows with the free space between spheres, in mean diameters.
double skin_of(const Spheres& spheres) {
  const double solid_fraction = spheres.solid_volume() / spheres.box.volume();
  return std::max(least_skin, 0.5 * std::cbrt(0.64 / solid_fraction) - 0.5);
}

bool is_free(const Spheres& spheres, const NearList& near, std::size_t i, const Vec3<double>& p, double inflation) {
  const double a = inflation * spheres.radius[i];
  if (!spheres.box.periodic_in_y() && (p.y < a || p.y > spheres.box.length.y - a)) return false;
  for (const std::int32_t neighbour : near.of(i)) {
    const auto j = std::size_t(neighbour);
    const double contact = a + inflation * spheres.radius[j];
    const Vec3<double> r = spheres.box.nearest_image(spheres.position(j) - p).r;
    if (dot(r, r) < contact * contact) return false;
  }
  return true;
}

}  // namespace

void agitate(Spheres& spheres, double inflation, int sweeps, Random& random) {
  const double diameter = spheres.mean_diameter();
  const double skin = skin_of(spheres) * diameter;
  NearList near(skin);
  near.build(spheres, inflation);
  double move = first_move * diameter;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::size_t accepted = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const double dx = random.symmetric(move), dy = random.symmetric(move), dz = random.symmetric(move);
      const Vec3<double> before = spheres.position(i);
      spheres.move_to(i, before + Vec3<double>{dx, dy, dz});
      if (near.moved_too_far(spheres, i)) near.build(spheres, inflation);
      if (is_free(spheres, near, i, spheres.position(i), inflation))
        ++accepted;
      else
        spheres.set_position(i, before);
    }
    const double acceptance = double(accepted) / double(spheres.size());
    move = std::clamp(move * std::clamp(acceptance / wanted_acceptance, 0.7, 1.4), shortest_move * diameter,
                      longest_move * skin);
  }
}

}  // namespace stresslet
