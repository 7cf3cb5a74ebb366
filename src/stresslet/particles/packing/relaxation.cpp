#include "stresslet/particles/packing/relaxation.hpp"

#include <algorithm>
#include <cmath>

namespace stresslet {

namespace {

constexpr double first_step = 0.1, longest_step = 0.5;  // in sqrt(inertia / stiffness) of the mean sphere
constexpr double step_growth = 1.1, step_cut = 0.5;     // these and the next two: Bitzek et al.
constexpr double first_mixing = 0.1, mixing_decay = 0.99;
constexpr int steps_before_growth = 5;
constexpr double longest_move_per_step = 0.1;  // in mean diameters
constexpr double balanced_force = 2e-3;        // net force over contact force, both root mean square
constexpr int steps_between_reports = 100;

}  // namespace

Relaxation::Forces Relaxation::compute_forces(double inflation) {
  Forces sums;
  const Box& box = spheres_.box;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    Vec3<double> f;
    const auto push = [&](const Vec3<double>& away, double overlap, double contact_distance) {
      f += overlap * away;
      sums.sum_of_squared_overlaps += overlap * overlap;
      sums.largest_overlap = std::max(sums.largest_overlap, overlap / contact_distance);
    };
    const double a = inflation * spheres_.radius[i];
    const Vec3<double> p = spheres_.position(i);
    for (const std::int32_t neighbour : near_.of(i)) {
      const auto j = std::size_t(neighbour);
      const double contact = a + inflation * spheres_.radius[j];
      const Vec3<double> r = box.nearest_image(spheres_.position(j) - p).r;
      const double squared = dot(r, r);
      if (squared >= contact * contact) continue;
      const double distance = std::max(std::sqrt(squared), 1e-12 * contact);
      push(-1.0 / distance * r, contact - distance, contact);
    }
    if (!box.periodic_in_y()) {
      if (p.y < a) push({0, 1, 0}, a - p.y, a);
      if (p.y > box.length.y - a) push({0, -1, 0}, p.y - (box.length.y - a), a);
    }
    force_[i] = f;
    sums.sum_of_squared_forces += dot(f, f);
    sums.power += dot(f, velocity_[i]);
  }
  return sums;
}

void Relaxation::mix_velocities(double mixing) {
  double speed = 0, push = 0;
  for (std::size_t i = 0; i < force_.size(); ++i) {
    const double w = inverse_inertia_[i];
    speed += dot(velocity_[i], velocity_[i]) / w;
    push += dot(force_[i], force_[i]) * w;
  }
  const double along = push > 0 ? mixing * std::sqrt(speed / push) : 0;
  for (std::size_t i = 0; i < force_.size(); ++i)
    velocity_[i] = (1 - mixing) * velocity_[i] + along * inverse_inertia_[i] * force_[i];
}

void Relaxation::stop() { std::fill(velocity_.begin(), velocity_.end(), Vec3<double>{}); }

void Relaxation::advance(double step, double longest_move) {
  for (std::size_t i = 0; i < force_.size(); ++i) {
    const bool is_free = force_[i] == Vec3<double>{};
    velocity_[i] = is_free ? Vec3<double>{} : velocity_[i] + step * inverse_inertia_[i] * force_[i];
    const double move = step * norm(velocity_[i]);
    if (move > longest_move) velocity_[i] = (longest_move / move) * velocity_[i];
    spheres_.move_to(i, spheres_.position(i) + step * velocity_[i]);
  }
}

RelaxationResult Relaxation::run(double inflation, double tolerance, int most_steps,
                                 const std::function<void(double)>& report_overlap) {
  const double diameter = spheres_.mean_diameter();
  force_.assign(spheres_.size(), {});
  velocity_.assign(spheres_.size(), {});
  inverse_inertia_.clear();
  for (const double a : spheres_.radius) inverse_inertia_.push_back(std::pow(0.5 * diameter / a, 2));

  double step = first_step, mixing = first_mixing;
  int since_stop = 0;
  for (int n = 0;; ++n) {
    near_.update(spheres_, inflation);
    const Forces now = compute_forces(inflation);
    if (n % steps_between_reports == 0 && report_overlap) report_overlap(now.largest_overlap);
    const bool balanced = now.sum_of_squared_forces < balanced_force * balanced_force * now.sum_of_squared_overlaps;
    if (now.largest_overlap <= tolerance || balanced || n == most_steps) return {now.largest_overlap, n};

    if (now.power > 0) {
      mix_velocities(mixing);
      if (++since_stop > steps_before_growth) {
        step = std::min(step * step_growth, longest_step);
        mixing *= mixing_decay;
      }
    } else if (n > 0) {
      stop();
      step *= step_cut, mixing = first_mixing, since_stop = 0;
    }
    advance(step, longest_move_per_step * diameter);
  }
}

}  // namespace stresslet
