#include "stresslet/particles/packing/from_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stresslet/base/error.hpp"
#include "stresslet/particles/cell_grid.hpp"
#include "stresslet/particles/packing/mean_motion.hpp"

namespace stresslet {

namespace {

class ColumnReader {
 public:
  ColumnReader(const ParticleColumns& columns, const std::string& source) : columns_(columns), source_(source) {}

  [[noreturn]] void refuse(std::string problem, std::string reason, std::string fix) const {
    throw InputError({source_, std::move(problem), std::move(reason), std::move(fix)});
  }

  std::string particle(std::size_t row) const {
    const std::string name = fmt::format("particle in row {}", row + 1);
    return columns_.id.empty() ? name : name + fmt::format(" (id {})", columns_.id[row]);
  }

  void check_lengths() const {
    const std::size_t n = columns_.x.size();
    if (n == 0) refuse("no particles", "a run needs at least one", "give a file with particles");
    const auto require = [&](const char* name, std::size_t length, bool optional) {
      if (length == n || (optional && length == 0)) return;
      refuse(fmt::format("{} entries of {} for {} of x", length, name, n), "columns have one entry per particle",
             "complete the column");
    };
    const bool velocities = columns_.ux.empty() && columns_.uy.empty() && columns_.uz.empty();
    const bool spins = columns_.wx.empty() && columns_.wy.empty() && columns_.wz.empty();
    require("y", columns_.y.size(), false), require("z", columns_.z.size(), false);
    require("radius", columns_.radius.size(), false);
    require("ux", columns_.ux.size(), velocities), require("uy", columns_.uy.size(), velocities);
    require("uz", columns_.uz.size(), velocities);
    require("wx", columns_.wx.size(), spins), require("wy", columns_.wy.size(), spins);
    require("wz", columns_.wz.size(), spins);
    require("density", columns_.density.size(), true), require("species", columns_.species.size(), true);
    require("id", columns_.id.size(), true);
  }

  void check_numbers() const {
    const auto finite = [&](const char* name, const std::vector<double>& column) {
      for (std::size_t i = 0; i < column.size(); ++i)
        if (!std::isfinite(column[i]))
          refuse(fmt::format("{} of {} is {}", name, particle(i), column[i]), "it is not a finite number",
                 "correct the entry");
    };
    const auto positive = [&](const char* name, const std::vector<double>& column) {
      for (std::size_t i = 0; i < column.size(); ++i)
        if (!(column[i] > 0))
          refuse(fmt::format("{} of {} is {}", name, particle(i), column[i]), "it must be positive",
                 "correct the entry");
    };
    finite("x", columns_.x), finite("y", columns_.y), finite("z", columns_.z);
    finite("radius", columns_.radius), finite("density", columns_.density);
    finite("ux", columns_.ux), finite("uy", columns_.uy), finite("uz", columns_.uz);
    finite("wx", columns_.wx), finite("wy", columns_.wy), finite("wz", columns_.wz);
    positive("radius", columns_.radius), positive("density", columns_.density);
    for (std::size_t i = 0; i < columns_.species.size(); ++i)
      if (columns_.species[i] < 0)
        refuse(fmt::format("species of {} is {}", particle(i), columns_.species[i]), "it counts size classes from 0",
               "correct the entry");
  }

  /// Rank of each particle's id.
  std::vector<std::int32_t> names() const {
    const std::size_t n = columns_.x.size();
    std::vector<std::int32_t> name(n);
    std::iota(name.begin(), name.end(), 0);
    if (columns_.id.empty()) return name;
    std::vector<std::size_t> row(n);
    std::iota(row.begin(), row.end(), std::size_t(0));
    std::stable_sort(row.begin(), row.end(),
                     [&](std::size_t a, std::size_t b) { return columns_.id[a] < columns_.id[b]; });
    for (std::size_t k = 0; k < n; ++k) {
      if (k > 0 && columns_.id[row[k]] == columns_.id[row[k - 1]])
        refuse(fmt::format("id {} occurs in rows {} and {}", columns_.id[row[k]], row[k - 1] + 1, row[k] + 1),
               "an id names one particle", "give every particle its own id");
      name[row[k]] = std::int32_t(k);
    }
    return name;
  }

  void check_overlaps(const ParticleState& state, const Box& box, double allowed) const {
    const double largest = *std::max_element(state.radius.begin(), state.radius.end());
    CellGrid grid;
    grid.build(box, state.x, state.y, state.z, 2 * largest);
    for (std::size_t i = 0; i < state.size(); ++i) {
      const double a = state.radius[i];
      if (!box.periodic_in_y()) {
        const double to_wall = std::min(state.y[i], box.length.y - state.y[i]);
        if (a - to_wall > allowed * a)
          refuse(fmt::format("{} overlaps a wall by {:.3g} of its radius", particle(i), (a - to_wall) / a),
                 fmt::format("at most {:.3g} is allowed", allowed), "move the particle or raise the box length in y");
      }
      grid.for_each_candidate(state.position(i), 2 * a, [&](std::int32_t candidate) {
        const auto j = std::size_t(candidate);
        const double b = state.radius[j];
        if (!(b < a || (b == a && j > i))) return;
        const double overlap = a + b - norm(box.nearest_image(state.position(j) - state.position(i)).r);
        if (overlap > allowed * b)
          refuse(fmt::format("{} and {} overlap by {:.3g} of the smaller radius", particle(std::min(i, j)),
                             particle(std::max(i, j)), overlap / b),
                 fmt::format("at most {:.3g} is allowed", allowed),
                 "check positions, radii, units and the box lengths, or allow a larger overlap");
      });
    }
  }

  ParticleState read(const Box& box, const ColumnLimits& limits) const {
    check_lengths();
    check_numbers();
    ParticleState state;
    const std::size_t n = columns_.x.size();
    state.resize(n);
    const std::vector<std::int32_t> name = names();
    for (std::size_t i = 0; i < n; ++i) {
      Vec3<double> p{columns_.x[i], columns_.y[i], columns_.z[i]};
      if (!box.periodic_in_y() && (p.y < 0 || p.y > box.length.y))
        refuse(fmt::format("{} lies at y = {}", particle(i), p.y),
               fmt::format("it is beyond the walls at 0 and {}", box.length.y), "correct y or the box length");
      double velocity_x = columns_.ux.empty() ? 0 : columns_.ux[i];
      box.wrap(p, velocity_x);
      state.set_position(i, p);
      state.set_velocity(i, columns_.ux.empty() ? Vec3<double>{box.mean_flow(p.y), 0, 0}
                                                : Vec3<double>{velocity_x, columns_.uy[i], columns_.uz[i]});
      state.set_angular_velocity(i, columns_.wx.empty() ? mean_angular_velocity(box)
                                                        : Vec3<double>{columns_.wx[i], columns_.wy[i], columns_.wz[i]});
      state.radius[i] = columns_.radius[i];
      state.density[i] = columns_.density.empty() ? limits.density : columns_.density[i];
      state.species[i] = columns_.species.empty() ? 0 : columns_.species[i];
      state.id[i] = name[i];
    }
    check_overlaps(state, box, limits.largest_overlap);
    return state;
  }

 private:
  const ParticleColumns& columns_;
  const std::string& source_;
};

}  // namespace

ParticleState state_from_columns(const ParticleColumns& columns, const Box& box, const ColumnLimits& limits,
                                 const std::string& source) {
  return ColumnReader(columns, source).read(box, limits);
}

}  // namespace stresslet
