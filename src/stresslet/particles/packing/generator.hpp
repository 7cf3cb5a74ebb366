#pragma once
/// Packing generator: sizes, solid fraction and seed to an overlap-free configuration.
///
/// Random points are relaxed at the wanted solid fraction until no two spheres overlap (`relaxation.hpp`); where that
/// jams too early, the spheres are shrunk a little, agitated (`agitation.hpp`) and relaxed again, which packs them
/// closer each time. At last they are agitated a little at their final size. Every gap exceeds 4e-5 of the distance of
/// the centres.
///
/// How much agitation: shear brings many pairs near contact, and so does the relaxation. Started from few sweeps the
/// sheared suspension is steady after a strain of 1 or 2; from the hard-sphere fluid (800 sweeps) after 2 to 3 in the
/// models with drag, and after more than 10 with squeezing lubrication alone, phi = 0.5.
///
/// The same request gives the same bits with the same build. Compilers and processors that round differently give
/// other, equally good configurations at high solid fractions, where relaxation amplifies the last bit.
#include <cstdint>
#include <functional>
#include <string>
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
  int sweeps = 20;    ///< Monte Carlo sweeps at the final size; 800 give the pair distribution of the hard-sphere fluid
  std::string where;  ///< place of the solid fraction in the input, for messages
};

struct Packing {
  Box box;              ///< volume from the solid fraction, offset zero
  ParticleState state;  ///< in the order of the sizes, id = index; carried by the mean flow
};

/// Throws InputError, at once, for a solid fraction far beyond random close packing.
void check_reach(const std::vector<SizeClassed>& sizes, double solid_fraction, const std::string& where);

/// `report` receives the part of the work done, 0 ... 1, ascending. Throws InputError for wrong parameters, for boxes
/// shorter than two of the largest diameters, and for solid fractions beyond random close packing (at once where
/// they are far beyond, else after an attempt).
Packing generate_packing(const std::vector<SizeClassed>& sizes, const PackingRequest& request,
                         const std::function<void(double)>& report = {});

}  // namespace stresslet
