#include "stresslet/io/extended_xyz.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace stresslet {

std::string xyz_frame(const Snapshot& s) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const auto& [lx, ly, lz] = s.box.length;
  const double offset = s.box.periodic_in_y ? s.box.offset - lx * std::nearbyint(s.box.offset / lx) : 0.0;
  fmt::format_to(out,
                 "{}\nLattice=\"{} 0 0 {} {} 0 0 0 {}\" Origin=\"0 0 0\" pbc=\"T {} T\" "
                 "Properties=id:I:1:species:I:1:pos:R:3:radius:R:1:velo:R:3:angular_velocity:R:3 strain={} time={}\n",
                 s.size(), lx, offset, ly, lz, s.box.periodic_in_y ? 'T' : 'F', s.strain, s.time);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double *x = &s.position[3 * i], *u = &s.velocity[3 * i], *w = &s.angular_velocity[3 * i];
    fmt::format_to(out, "{} {} {} {} {} {} {} {} {} {} {} {}\n", s.id[i], s.species[i], x[0], x[1], x[2], s.radius[i],
                   u[0], u[1], u[2], w[0], w[1], w[2]);
  }
  return fmt::to_string(text);
}

}  // namespace stresslet
