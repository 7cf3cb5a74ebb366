#pragma once
/// The laws of open faces. Unsure: "half-way" for walls; "velocity" where fluid comes in and "pressure" where it
/// leaves; the regularised ones where these become unstable (relaxation time below 0.55 or so).
///
///   law                    boundary lies         prescribes               own error
///   half-way               half a cell outside   velocity along itself    slip of curved profiles, by magic number
///   full-way               half a cell outside   velocity along itself    the same, and one step of delay
///   velocity               on the last cells     velocity                 second order; none for flow along the face
///   pressure               on the last cells     density, velocity along  second order; none for flow along the face
///   regularised-velocity   on the last cells     velocity                 second order
///   regularised-pressure   on the last cells     density, velocity along  second order
///
/// Edges: a link that crosses two faces meets the first wall in the order x, y, z. A wall beside an opening gives the
/// opening its known populations, the opening sets those that move away from it. Openings on faces of two axes are
/// refused, since neither would have all it needs in the common edge.
#include "stresslet/base/type_list.hpp"
#include "stresslet/lattice/boundary/openings.hpp"
#include "stresslet/lattice/boundary/walls.hpp"

namespace stresslet {

using BoundaryLaws =
    TypeList<HalfWay, FullWay, VelocityOpening, PressureOpening, RegularisedVelocity, RegularisedPressure>;

}  // namespace stresslet
