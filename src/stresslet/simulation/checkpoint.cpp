#include "stresslet/simulation/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "stresslet/base/error.hpp"

namespace stresslet {

namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw InputError({"", "the checkpoint cannot be used: " + problem, "it was damaged, or written by another version",
                    "start the run anew, or restart with the version that wrote the result (see /provenance)"});
}

/// Visits every array and scalar of the restart state by name; saving and restoring share this one list.
template <class Visit>
void for_each_stored(Suspension& s, Visit&& visit) {
  s.state.for_each_array([&](const char* name, auto& array) { visit(std::string("state_") + name, array); });
  visit("list_i", s.list.i), visit("list_j", s.list.j);
  visit("displacement_x", s.displacement_x), visit("displacement_y", s.displacement_y);
  visit("displacement_z", s.displacement_z);
  visit("spring_x", s.history.x), visit("spring_y", s.history.y), visit("spring_z", s.history.z);
  visit("wall_spring_x", s.wall_contacts.history.x), visit("wall_spring_y", s.wall_contacts.history.y);
  visit("wall_spring_z", s.wall_contacts.history.z);
  visit("velocity_change", s.change.array());
  visit("box_length_x", s.box.length.x), visit("box_length_y", s.box.length.y), visit("box_length_z", s.box.length.z);
  visit("box_offset", s.box.offset), visit("box_offset_rest", s.box.offset_rest);
  visit("strain", s.strain), visit("steps", s.steps);
  visit("strain_since_build", s.strain_since_build), visit("builds", s.builds);
}

struct Save {
  Checkpoint& out;
  void operator()(const std::string& name, double v) const { out.scalars[name] = v; }
  void operator()(const std::string& name, std::int64_t v) const { out.scalars[name] = v; }
  template <class Array>
  void operator()(const std::string& name, const Array& a) const {
    out.arrays[name] = std::vector<typename Array::value_type>(a.begin(), a.end());
  }
};

struct Restore {
  const Checkpoint& in;
  template <class Scalar>
  void scalar(const std::string& name, Scalar& v) const {
    const auto found = in.scalars.find(name);
    if (found == in.scalars.end() || !std::holds_alternative<Scalar>(found->second)) refuse("no scalar " + name);
    v = std::get<Scalar>(found->second);
  }
  void operator()(const std::string& name, double& v) const {
    scalar(name, v);
    if (!std::isfinite(v)) refuse(name + " is not a finite number");
  }
  void operator()(const std::string& name, std::int64_t& v) const { scalar(name, v); }
  template <class Array>
  void operator()(const std::string& name, Array& a) const {
    using Stored = std::vector<typename Array::value_type>;
    const auto found = in.arrays.find(name);
    if (found == in.arrays.end() || !std::holds_alternative<Stored>(found->second)) refuse("no array " + name);
    const Stored& stored = std::get<Stored>(found->second);
    if constexpr (std::is_floating_point_v<typename Array::value_type>)
      if (!std::all_of(stored.begin(), stored.end(), [](double v) { return std::isfinite(v); }))
        refuse(name + " holds a value that is not a finite number");
    a.assign(stored.begin(), stored.end());
  }
};

void check_consistent(Suspension& s) {
  const std::size_t n = s.state.size();
  if (n == 0) refuse("no particles");
  const auto expect = [](bool good, const char* what) {
    if (!good) refuse(std::string(what) + " has the wrong length or a value out of range");
  };
  s.state.for_each_array([&](const char* name, auto& array) { expect(array.size() == n, name); });
  expect(s.list.j.size() == s.list.size() && s.history.x.size() == s.list.size() &&
             s.history.y.size() == s.list.size() && s.history.z.size() == s.list.size(),
         "the neighbour list");
  for (std::size_t k = 0; k < s.list.size(); ++k)
    expect(s.list.i[k] >= 0 && s.list.i[k] < s.list.j[k] && s.list.j[k] < std::int32_t(n), "the neighbour list");
  expect(s.displacement_x.size() == n && s.displacement_y.size() == n && s.displacement_z.size() == n,
         "the displacement");
  expect(s.wall_contacts.history.x.size() == n && s.wall_contacts.history.y.size() == n &&
             s.wall_contacts.history.z.size() == n,
         "the wall contact history");
  expect(s.change.array().size() == n * twist_stride, "the velocity change");
  for (double a : s.state.radius) expect(a > 0, "a radius");
  for (double rho : s.state.density) expect(rho > 0, "a density");
  std::vector<bool> seen(n, false);
  for (std::int32_t id : s.state.id) {
    expect(id >= 0 && std::size_t(id) < n && !seen[std::size_t(id)], "an id");
    seen[std::size_t(id)] = true;
  }
  expect(s.box.length.x > 0 && s.box.length.y > 0 && s.box.length.z > 0, "the box");
}

}  // namespace

Checkpoint make_checkpoint(Suspension& s) {
  Checkpoint checkpoint;
  for_each_stored(s, Save{checkpoint});
  return checkpoint;
}

void restore_checkpoint(Suspension& s, const Checkpoint& checkpoint) {
  for_each_stored(s, Restore{checkpoint});
  check_consistent(s);
}

}  // namespace stresslet
