#include "stresslet/simulation/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "stresslet/base/error.hpp"

namespace stresslet {

namespace {

std::uint64_t pair_key(std::int32_t a, std::int32_t b) {
  return (std::uint64_t(std::uint32_t(std::min(a, b))) << 32) | std::uint32_t(std::max(a, b));
}

/// Tangential springs by pair of permanent ids, seen from the smaller id.
using SpringTable = std::unordered_map<std::uint64_t, Vec3<double>>;

SpringTable stretched_springs(const Suspension& s) {
  SpringTable table;
  for (std::size_t k = 0; k < s.history.x.size(); ++k) {
    const Vec3<double> zeta = s.history.get(k);
    if (zeta == Vec3<double>{}) continue;
    const std::int32_t a = s.state.id[std::size_t(s.list.i[k])], b = s.state.id[std::size_t(s.list.j[k])];
    table[pair_key(a, b)] = a < b ? zeta : -zeta;
  }
  return table;
}

void restore_springs(Suspension& s, const SpringTable& table) {
  s.history.resize(s.list.size());
  if (table.empty()) return;
  for (std::size_t k = 0; k < s.list.size(); ++k) {
    const std::int32_t a = s.state.id[std::size_t(s.list.i[k])], b = s.state.id[std::size_t(s.list.j[k])];
    if (const auto found = table.find(pair_key(a, b)); found != table.end())
      s.history.set(k, a < b ? found->second : -found->second);
  }
}

template <class Array>
void permute(Array& a, const std::vector<std::int32_t>& order) {
  if (a.size() != order.size()) return;
  Array sorted(a.size());
  for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = a[std::size_t(order[k])];
  a = std::move(sorted);
}

/// Puts particle order[k] at index k; the list must be built anew afterwards.
void reorder(Suspension& s, const std::vector<std::int32_t>& order) {
  s.state.for_each_array([&](const char*, auto& array) { permute(array, order); });
  for (auto* h : {&s.wall_contacts.history.x, &s.wall_contacts.history.y, &s.wall_contacts.history.z})
    permute(*h, order);
  if (s.change.size() == order.size()) {
    const TwistVector before = s.change;
    for (std::size_t k = 0; k < order.size(); ++k) s.change.set(k, before.get(std::size_t(order[k])));
  }
  s.solver.prepare(s.state);
}

}  // namespace

void check_box(const Box& box, double largest_radius, const InteractionRange& range, double skin,
               const std::string& where) {
  const double needed = 2 * (2 * largest_radius + range(largest_radius, largest_radius) + skin);
  const auto& l = box.length;
  const double shortest = std::min({l.x, l.z, box.periodic_in_y() ? l.y : l.x});
  if (shortest < needed)
    throw InputError(
        {where, fmt::format("the box is {:.3g} d1 long in its shortest periodic direction", shortest),
         fmt::format("a particle would meet two images of the same neighbour; at least {:.3g} d1 is needed "
                     "for the largest sphere, the lubrication range and the list's skin",
                     needed),
         "raise suspension.count, or choose a less slender box"});
}

double largest_displacement(const Suspension& s) {
  double square = 0;
  for (std::size_t i = 0; i < s.state.size(); ++i)
    square = std::max(square, s.displacement_x[i] * s.displacement_x[i] + s.displacement_y[i] * s.displacement_y[i] +
                                  s.displacement_z[i] * s.displacement_z[i]);
  return std::sqrt(square);
}

void rebuild_neighbours(Suspension& s, ThreadTeam& team, bool may_sort) {
  constexpr std::int64_t builds_between_sorts = 25;
  const SpringTable springs = stretched_springs(s);
  s.list.build(team, s.state, s.box);
  if (may_sort && s.builds % builds_between_sorts == 0) {
    reorder(s, s.list.spatial_order());
    s.list.build(team, s.state, s.box);
  }
  restore_springs(s, springs);
  const std::size_t n = s.state.size();
  for (auto* d : {&s.displacement_x, &s.displacement_y, &s.displacement_z}) d->assign(n, 0.0);
  s.strain_since_build = 0;
  ++s.builds;
  prepare_pair_arrays(s);
}

void prepare_pair_arrays(Suspension& s) {
  s.pairs.prepare(s.list, s.state.size());
  s.contacts.prepare(s.list.size());
  s.lubrication.prepare(s.list.size());
}

void prepare_particle_arrays(Suspension& s) {
  const std::size_t n = s.state.size();
  s.wall_contacts.prepare(n);
  s.walls.prepare(n, s.box);
  s.solver.prepare(s.state);
  s.velocity.resize(n), s.velocity_now.resize(n), s.residual.resize(n);
  if (s.change.size() != n) s.change.resize(n);
}

}  // namespace stresslet
