#pragma once
/// The lists of lattice laws: keywords, messages, instantiation, conformance tests and documentation follow from them.
#include "stresslet/base/type_list.hpp"
#include "stresslet/lattice/collision/bgk.hpp"
#include "stresslet/lattice/collision/mrt.hpp"
#include "stresslet/lattice/collision/trt.hpp"
#include "stresslet/lattice/forcing/exact_difference.hpp"
#include "stresslet/lattice/forcing/guo.hpp"
#include "stresslet/lattice/forcing/he.hpp"
#include "stresslet/lattice/forcing/no_force.hpp"
#include "stresslet/lattice/forcing/velocity_shift.hpp"
#include "stresslet/lattice/stencil/d2q9.hpp"
#include "stresslet/lattice/stencil/d3q19.hpp"
#include "stresslet/lattice/stencil/d3q27.hpp"

namespace stresslet {

using Stencils = TypeList<D3Q19, D2Q9, D3Q27>;
using CollisionLaws = TypeList<Bgk, Trt, Mrt>;
using ForcingLaws = TypeList<NoForce, Guo, ExactDifference, He, VelocityShift>;

}  // namespace stresslet
