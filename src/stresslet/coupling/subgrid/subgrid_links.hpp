#pragma once
/// The sub-grid correction of a pair of resolved spheres for the solve of all spheres, and its share of the stress.
#include <optional>
#include <string>

#include "stresslet/coupling/sphere_images.hpp"
#include "stresslet/coupling/sphere_links.hpp"
#include "stresslet/coupling/subgrid/subgrid_resistance.hpp"

namespace stresslet {

struct SubgridCorrection {
  std::string law = "soft-cut-off";  ///< a name from SubgridLaws
  SubgridLengths lengths;            ///< calibrated_lengths.hpp has those of the common schemes
  SubgridRange range;
  std::optional<SubgridLengths> wall_lengths;  ///< of films at walls, where they differ

  const SubgridLengths& lengths_at_walls() const { return wall_lengths ? *wall_lengths : lengths; }
};

/// The image of `second` that meets `first`: its centre and velocity less those of `second`.
struct ImageShift {
  Vec3<double> displacement{}, velocity{};
};

/// The 12x12 form of pair_law.hpp; `centre_distance` along the unit vector `e` from the first to the second.
Matrix12 pair_resistance_matrix(const PairResistance<double>& k, const Vec3<double>& e, double centre_distance);

/// Of the sphere and the wall that it faces along `e`: force and torque on the sphere are -matrix (U - wall, w).
Matrix6 wall_resistance_matrix(const PairResistance<double>& k, const Vec3<double>& e);

/// Empty where the pair is beyond the range. `dynamic_viscosity` in lattice units.
std::optional<SphereLink> subgrid_link(const std::vector<ResolvedSphere>& spheres, std::int32_t first,
                                       std::int32_t second, const ImageShift& image, double dynamic_viscosity,
                                       const SubgridCorrection& correction);

/// The same of a sphere whose surface is `gap` cells from a wall along `e`.
std::optional<Matrix6> subgrid_wall_resistance_matrix(double radius, const Vec3<double>& e, double gap,
                                                      double dynamic_viscosity, const SubgridCorrection& correction);

/// Force on the first sphere of a link.
Vec3<double> link_force(const SphereLink& link, const std::vector<ResolvedSphere>& spheres);

/// First moment of the pair's film, tension positive as HydrodynamicLoad::stresslet: the force on the first times the
/// vector from first to second, symmetric part.
inline SymTensor3<double> link_stresslet(const Vec3<double>& force_on_first, const Vec3<double>& first_to_second) {
  return symmetric_product(force_on_first, first_to_second);
}

}  // namespace stresslet
