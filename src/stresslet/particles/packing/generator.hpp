#pragma once
/// Packing generator: sizes, solid fraction and seed to an overlap-free configuration.
///
/// Random points are relaxed at the wanted solid fraction until no two spheres overlap (`relaxation.hpp`); where that
/// jams too early, the spheres are shrunk a little, agitated (`agitation.hpp`) and relaxed again, which packs them
/// closer each time. At last they are agitated at their final size, which gives the pair distribution of the
/// hard-sphere fluid. Every gap exceeds 4e-5 of the distance of the centres.
///
/// The same request gives the same bits with the same build. Compilers and processors that round differently give
/// other, equally good configurations at high solid fractions, where relaxation amplifies the last bit.
#include <cstdint>
#include <functional>
#include <vector>

#include "stresslet/particles/box.hpp"
#include "stresslet/particles/sizes/size_classed.hpp"
#include "stresslet/particles/state.hpp"

namespace stresslet {

struct PackingRequest {
  BoxKind kind = BoxKind::lees_edwards;
  Vec3<double> aspect{1, 1, 1};  ///< ratios of the box lengths
  double solid_fraction = 0.3;   ///< volume of the spheres over volume of the box, walls at its faces
  std::uint64_t seed = 1;
  double shear_rate = 1;
  double density = 1;
};

struct Packing {
  Box box;              ///< volume from the solid fraction, offset zero
  ParticleState state;  ///< in the order of the sizes, id = index; carried by the mean flow
};

/// `report` receives the part of the work done, 0 ... 1, ascending. Throws InputError for wrong parameters, for boxes
/// shorter than two of the largest diameters, and for solid fractions beyond random close packing (at once where
/// they are far beyond, else after an attempt).
Packing generate_packing(const std::vector<SizeClassed>& sizes, const PackingRequest& request,
                         const std::function<void(double)>& report = {});

}  // namespace stresslet
