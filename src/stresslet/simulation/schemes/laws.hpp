#pragma once
/// Time schemes. If unsure use `semi-implicit`.
///
/// | scheme        | order | step bound by               | particle inertia |
/// |---------------|-------|-----------------------------|------------------|
/// | explicit      | 2     | thinnest film, ~ St         | yes              |
/// | semi-implicit | 1     | relaxation of the contacts  | yes              |
/// | inertialess   | 1     | relaxation of the contacts  | no (St = 0)      |
///
/// The explicit scheme is second order for contacts, first order for lubrication and drag, whose velocities lag by half
/// a step.
#include "stresslet/base/type_list.hpp"
#include "stresslet/simulation/schemes/explicit.hpp"
#include "stresslet/simulation/schemes/inertialess.hpp"
#include "stresslet/simulation/schemes/semi_implicit.hpp"

namespace stresslet {

using TimeSchemes = TypeList<SemiImplicit, Explicit, Inertialess>;

}  // namespace stresslet
