#pragma once
/// Profiles across the velocity gradient: solid fraction and velocity in slabs of equal height, and the slope of the
/// velocity.
///
/// A sphere gives each slab the exact volume it has there; below the plane at height h above its centre lies
/// V = pi (a + h)^2 (2 a - h) / 3. What reaches beyond a periodic face enters at the opposite one as part of the image,
/// whose velocity in the sheared box differs by the jump: beyond y = length.y by -shear_rate length.y, below y = 0 by
/// +shear_rate length.y. What is pressed beyond a flat wall counts to the slab at that wall, so that the mean over the
/// slabs is always the solid fraction.
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "stresslet/particles/box.hpp"

namespace stresslet {

/// Volume of a sphere between the planes at `lower` and `upper`, heights above its centre.
double sphere_volume_between(double radius, double lower, double upper);

/// Sums over the frames added; plain numbers, kept by checkpoints.
struct ProfileSums {
  double frames = 0;
  std::vector<double> volume;           ///< [slab] volume of spheres
  std::vector<double> volume_velocity;  ///< [slab] the same times their velocity u_x
  double slope_yy = 0, slope_yu = 0;    ///< sum of w (y - mean y)^2 and w (y - mean y) u, w the volume of the sphere
};

class ShearProfile {
 public:
  /// Of `box` only kind, lengths and shear rate are used.
  ShearProfile(const Box& box, std::size_t slabs);

  /// Adds one frame: centres y in [0, length.y), velocities u_x in the frame of the box, radii; all [particle].
  void add(std::span<const double> y, std::span<const double> ux, std::span<const double> radius);

  std::vector<double> height() const;          ///< [slab] middle
  std::vector<double> solid_fraction() const;  ///< [slab] mean over frames
  std::vector<double> velocity() const;        ///< [slab] volume-weighted mean of u_x, NaN where no sphere ever was

  /// Least-squares slope du_x/dy over the sphere centres, weighted by volume, each frame about its own mean; in units
  /// of the shear rate of the mean flow where there is one. 0 while all centres have the same height.
  double velocity_slope() const;

  const ProfileSums& sums() const { return sums_; }
  /// Continues from the sums of an earlier profile with as many slabs.
  void restore(ProfileSums sums) { sums_ = std::move(sums); }

 private:
  Box box_;
  double slab_height_;
  ProfileSums sums_;
};

}  // namespace stresslet
