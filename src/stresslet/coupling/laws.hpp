#pragma once
/// The lists of coupling laws: keywords, messages, instantiation, conformance tests and documentation follow from them.
#include "stresslet/base/type_list.hpp"
#include "stresslet/coupling/operators/bounce_back.hpp"
#include "stresslet/coupling/operators/guo_form.hpp"
#include "stresslet/coupling/operators/half_holdych.hpp"
#include "stresslet/coupling/operators/holdych.hpp"
#include "stresslet/coupling/operators/superposition.hpp"
#include "stresslet/coupling/solid_fraction/distance_weighting.hpp"
#include "stresslet/coupling/solid_fraction/exact_overlap.hpp"
#include "stresslet/coupling/solid_fraction/plane_cut.hpp"
#include "stresslet/coupling/solid_fraction/sub_cells.hpp"
#include "stresslet/coupling/subgrid/hard_cut_off.hpp"
#include "stresslet/coupling/subgrid/soft_cut_off.hpp"
#include "stresslet/coupling/weights/linear.hpp"
#include "stresslet/coupling/weights/noble_torczynski.hpp"
#include "stresslet/coupling/weights/viscosity_scaled.hpp"

namespace stresslet {

using SolidFractionLaws = TypeList<PlaneCut, SubCells, ExactOverlap, DistanceWeighting>;
using CouplingOperators = TypeList<Superposition, GuoForm, NonEquilibriumBounceBack, HalfHoldych, Holdych>;
using SolidWeights = TypeList<ViscosityScaledWeight, LinearWeight, NobleTorczynskiWeight>;
using SubgridLaws = TypeList<SoftCutOff, HardCutOff>;

}  // namespace stresslet
