#include "stresslet/simulation/fluid/case.hpp"

#include <algorithm>
#include <cmath>

#include "stresslet/io/schema_read.hpp"
#include "stresslet/io/schema_text.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/simulation/fidelity.hpp"

namespace stresslet {

namespace {

constexpr double samples_of_a_run = 200;
constexpr const char* fidelity_line = "fidelity = \"fluid\"\n\n";

}  // namespace

double FluidCase::reynolds_number() const {
  return units ? units->length * units->velocity / units->kinematic_viscosity : flow.reynolds.value();
}

Vec3<double> FluidCase::box() const {
  return {domain.size[0], domain.size[1], domain.dimensions() == 3 ? domain.size[2] : 1.0 / double(domain.resolution)};
}

double FluidCase::fastest_velocity() const {
  const auto length = [](const Vec3<double>& u) { return std::sqrt(dot(u, u)); };
  double fastest = 1;
  for (const auto& axis : boundaries.faces)
    for (const auto& face : axis)
      if (face && face->velocity) fastest = std::max(fastest, length(*face->velocity));
  const double mean_flow = boundaries.shear_rate ? std::abs(*boundaries.shear_rate) * domain.size[1] / 2 : 0;
  const bool moves = initial.state == "shear-wave" || initial.state == "taylor-green";
  const double start = moves ? std::abs(initial.amplitude) + length(initial.velocity) : length(initial.velocity);
  return std::max(fastest, mean_flow + start);
}

void settle(FluidCase& settled) {
  if (!settled.lattice.stencil)
    settled.lattice.stencil = std::string(settled.domain.dimensions() == 2 ? D2Q9::name : D3Q19::name);
  if (!settled.output.sample_every) settled.output.sample_every = settled.run.end_time / samples_of_a_run;
  InitialInput& initial = settled.initial;
  if (!initial.waves && initial.state == "shear-wave") initial.waves = {0, 1, 0};
  if (!initial.waves && initial.state == "taylor-green") initial.waves = {1, 1, 0};
}

FluidCase read_fluid_case(InputDocument document) {
  FluidCase result = read_described<FluidCase>(document, {fidelity_key});
  result.source.document = std::move(document);
  check_fluid_case(result);
  settle(result);
  return result;
}

std::string resolved_toml(const FluidCase& resolved) { return fidelity_line + resolved_text(described(resolved)); }

std::string new_fluid_case_template() {
  FluidCase channel;
  channel.domain = {{0.125, 1}, 32};
  channel.flow.reynolds = 10;
  channel.force = ForceInput{};
  channel.force->density = Vec3<double>{0.8, 0, 0};
  channel.boundaries.faces[1] = {FaceInput{}, FaceInput{}};
  channel.run.end_time = 10;
  settle(channel);
  channel.output.sample_every.reset();
  return "# Input of stresslet: plain fluid, here pressed between two walls (Poiseuille). Lengths are in units of L,\n"
         "# velocities of U, times of L/U, pressures of rho U^2. Keys that are commented out show their defaults.\n\n" +
         (fidelity_line + template_text(described(channel)));
}

}  // namespace stresslet
