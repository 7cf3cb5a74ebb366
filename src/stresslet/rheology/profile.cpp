#include "stresslet/rheology/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stresslet/base/constants.hpp"

namespace stresslet {

namespace {

/// Volume of a sphere below the plane at `height` above its centre.
double volume_below(double radius, double height) {
  const double h = std::clamp(height, -radius, radius);
  return pi / 3 * (radius + h) * (radius + h) * (2 * radius - h);
}

}  // namespace

double sphere_volume_between(double radius, double lower, double upper) {
  return volume_below(radius, upper) - volume_below(radius, lower);
}

ShearProfile::ShearProfile(const Box& box, std::size_t slabs) : box_(box), slab_height_(box.length.y / double(slabs)) {
  sums_.volume.assign(slabs, 0.0);
  sums_.volume_velocity.assign(slabs, 0.0);
}

void ShearProfile::add(std::span<const double> y, std::span<const double> ux, std::span<const double> radius) {
  const long slabs = long(sums_.volume.size());
  double weight = 0, weighted_y = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const long lowest = long(std::floor((y[i] - radius[i]) / slab_height_));
    const long highest = long(std::floor((y[i] + radius[i]) / slab_height_));
    double below = 0;
    for (long k = lowest; k <= highest; ++k) {
      const double top = double(k + 1) * slab_height_ - y[i];
      const double next = volume_below(radius[i], k == highest ? radius[i] : top);
      const long boxes_up = box_.periodic_in_y() ? (k >= 0 ? k / slabs : -((slabs - 1 - k) / slabs)) : 0;
      const std::size_t slab = std::size_t(std::clamp(k - boxes_up * slabs, 0L, slabs - 1));
      sums_.volume[slab] += next - below;
      sums_.volume_velocity[slab] += (next - below) * (ux[i] - double(boxes_up) * box_.velocity_jump());
      below = next;
    }
    weight += below;
    weighted_y += below * y[i];
  }
  const double mean_y = weight > 0 ? weighted_y / weight : 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double lever = volume_below(radius[i], radius[i]) * (y[i] - mean_y);
    sums_.slope_yy += lever * (y[i] - mean_y);
    sums_.slope_yu += lever * ux[i];
  }
  ++sums_.frames;
}

std::vector<double> ShearProfile::height() const {
  std::vector<double> middle(sums_.volume.size());
  for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = (double(k) + 0.5) * slab_height_;
  return middle;
}

std::vector<double> ShearProfile::solid_fraction() const {
  std::vector<double> fraction(sums_.volume);
  const double slab_volume = box_.length.x * slab_height_ * box_.length.z;
  for (double& f : fraction) f /= std::max(1.0, sums_.frames) * slab_volume;
  return fraction;
}

std::vector<double> ShearProfile::velocity() const {
  std::vector<double> mean(sums_.volume.size());
  for (std::size_t k = 0; k < mean.size(); ++k)
    mean[k] =
        sums_.volume[k] > 0 ? sums_.volume_velocity[k] / sums_.volume[k] : std::numeric_limits<double>::quiet_NaN();
  return mean;
}

double ShearProfile::velocity_slope() const {
  if (!(sums_.slope_yy > 0)) return 0;
  const double unit = box_.mean_gradient() != 0 ? box_.mean_gradient() : 1.0;
  return sums_.slope_yu / sums_.slope_yy / unit;
}

}  // namespace stresslet
