#include "stresslet/particles/packing/generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stresslet/base/error.hpp"
#include "stresslet/particles/packing/agitation.hpp"
#include "stresslet/particles/packing/mean_motion.hpp"
#include "stresslet/particles/packing/random_close_packing.hpp"
#include "stresslet/particles/packing/relaxation.hpp"

namespace stresslet {

namespace {

constexpr double margin = 1e-4;            // relative inflation at which the spheres are relaxed
constexpr double beyond_estimate = 0.025;  // above the estimate by more than this no attempt is made
constexpr int most_relaxation_steps = 30000, most_compactions = 24;
constexpr double agitation_room = 0.03;      // shrinkage that lets a jammed packing rearrange
constexpr double compaction_stride = 0.004;  // in solid fraction
constexpr int sweeps_to_compact = 500;
constexpr double skin = 0.25;  // in mean diameters

std::vector<double> diameters_of(const std::vector<SizeClassed>& sizes) {
  std::vector<double> diameters;
  for (const SizeClassed& s : sizes) diameters.push_back(s.diameter);
  return diameters;
}

void check(const std::vector<SizeClassed>& sizes, const PackingRequest& request) {
  if (sizes.empty()) throw InputError({"", "no particles", "there is nothing to pack", "ask for at least one"});
  for (const SizeClassed& s : sizes)
    if (!(std::isfinite(s.diameter) && s.diameter > 0))
      throw InputError({"", fmt::format("diameter {}", s.diameter), "diameters are positive", "correct the sizes"});
  if (!(request.solid_fraction > 0 && request.solid_fraction < 1))
    throw InputError({"", fmt::format("solid fraction {}", request.solid_fraction),
                      "it is the volume of the particles over that of the box", "give a number between 0 and 1"});
  for (const double a : {request.aspect.x, request.aspect.y, request.aspect.z})
    if (!(std::isfinite(a) && a > 0))
      throw InputError({"", fmt::format("box aspect {}", a), "ratios of lengths are positive", "correct the aspect"});
  if (!(std::isfinite(request.density) && request.density > 0))
    throw InputError({"", fmt::format("density {}", request.density), "masses are positive", "correct the density"});
}

Complaint beyond_reach(const std::string& where, double wanted, const std::string& reached, double estimate) {
  return {where, fmt::format("solid fraction {:.4g} is out of reach: {}", wanted, reached),
          fmt::format("spheres of these sizes jam at random near {:.3f} (random close packing), between walls lower",
                      estimate),
          "lower the solid fraction or widen the size distribution"};
}

/// The box and, at random, the centres.
Spheres scatter(const std::vector<SizeClassed>& sizes, const PackingRequest& request, Random& random) {
  Spheres spheres;
  for (const SizeClassed& s : sizes) spheres.radius.push_back(0.5 * s.diameter);
  const Vec3<double> aspect = request.aspect;
  const double volume = spheres.solid_volume() / request.solid_fraction;
  const double scale = std::cbrt(volume / (aspect.x * aspect.y * aspect.z));
  spheres.box = {request.kind, scale * aspect, request.shear_rate, 0};

  const Vec3<double> length = spheres.box.length;
  const double largest = 2 * *std::max_element(spheres.radius.begin(), spheres.radius.end());
  const bool periodic = spheres.box.periodic_in_y();
  if (std::min({length.x, length.z, periodic ? length.y : length.x}) < 2 * largest ||
      length.y <= largest * (1 + 2 * margin))
    throw InputError({"",
                      fmt::format("a box of {:.4g} x {:.4g} x {:.4g} for particles of diameter up to {:.4g}", length.x,
                                  length.y, length.z, largest),
                      "a particle would meet its own image, or both walls",
                      "ask for more particles, a lower solid fraction or a more cubic box"});

  for (const double a : spheres.radius) {
    const double margin_y = periodic ? 0 : a;
    const double x = length.x * random.uniform();
    const double y = margin_y + (length.y - 2 * margin_y) * random.uniform();
    const double z = length.z * random.uniform();
    spheres.x.push_back(x), spheres.y.push_back(y), spheres.z.push_back(z);
  }
  return spheres;
}

/// Ascending part of the work done.
class Progress {
 public:
  explicit Progress(const std::function<void(double)>& report) : report_(report) {}

  void overlap(double largest) {
    constexpr double first = 0.5, last = 0.5 * margin;
    done(0.95 * std::log(first / std::clamp(largest, last, first)) / std::log(first / last));
  }

  void done(double part) {
    if (report_ && part > part_) report_(part_ = part);
  }

 private:
  const std::function<void(double)>& report_;
  double part_ = -1;
};

/// Moves the spheres apart until none overlap at inflation > 1, which is returned.
double separate(Spheres& spheres, const PackingRequest& request, double estimate, Random& random, Progress& progress) {
  const double solid_fraction = request.solid_fraction;
  Relaxation relaxation(spheres, skin * spheres.mean_diameter());
  const auto fraction_at = [&](double inflation) { return solid_fraction * std::pow(inflation, 3); };
  const double wanted = 1 + margin;
  double goal = wanted, reached = 0;
  for (int compaction = 0; compaction <= most_compactions; ++compaction) {
    const auto [overlap, steps] = relaxation.run(goal, 0.5 * margin, most_relaxation_steps,
                                                 [&](double o) { progress.overlap(o + (wanted - goal)); });
    const double inflation = goal * (1 - overlap) * (1 - 1e-12);
    if (goal == wanted && overlap <= 0.5 * margin) return inflation;
    reached = std::max(reached, inflation);
    agitate(spheres, inflation * (1 - agitation_room), sweeps_to_compact, random);
    goal = std::min(wanted, std::cbrt((fraction_at(reached) + compaction_stride) / solid_fraction));
  }
  throw InputError(
      beyond_reach(request.where, solid_fraction,
                   fmt::format("the closest packing found has {:.4f}", fraction_at(std::min(reached, 1.0))), estimate));
}

}  // namespace

void check_reach(const std::vector<SizeClassed>& sizes, double solid_fraction, const std::string& where) {
  const double estimate = random_close_packing(diameters_of(sizes));
  if (solid_fraction > estimate + beyond_estimate)
    throw InputError(
        beyond_reach(where, solid_fraction, fmt::format("the largest is about {:.3f}", estimate), estimate));
}

Packing generate_packing(const std::vector<SizeClassed>& sizes, const PackingRequest& request,
                         const std::function<void(double)>& report) {
  check(sizes, request);
  check_reach(sizes, request.solid_fraction, request.where);
  const double estimate = random_close_packing(diameters_of(sizes));

  Progress progress(report);
  progress.done(0);
  Random random(request.seed);
  Spheres spheres = scatter(sizes, request, random);
  const double inflation = separate(spheres, request, estimate, random, progress);
  agitate(spheres, inflation, request.sweeps, random);

  Packing packing{spheres.box, {}};
  ParticleState& state = packing.state;
  state.resize(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    state.set_position(i, spheres.position(i));
    state.radius[i] = spheres.radius[i];
    state.species[i] = sizes[i].species;
    state.id[i] = std::int32_t(i);
    state.density[i] = request.density;
  }
  move_with_mean_flow(state, packing.box);
  progress.done(1);
  return packing;
}

}  // namespace stresslet
