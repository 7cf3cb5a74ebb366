#pragma once
/// Size distributions. If unsure take "discrete" with diameters [1, 1.4] and equal volume shares: it neither
/// crystallises nor demixes, and most published viscosities are of it.
///
/// | name         | sizes                                  | species        | given by                             |
/// |--------------|----------------------------------------|----------------|--------------------------------------|
/// | monodisperse | one                                    | 0              | diameter                             |
/// | discrete     | a few, integer counts near the shares  | index of size  | diameters, number or volume shares   |
/// | lognormal    | N quantiles between two cuts           | 0              | median, width, smallest, largest     |
/// | table        | N quantiles of a measured distribution | row            | diameters, shares by number or volume |
///
/// A law turns parameters and a count into diameters: `validate(params)` throws InputError, and
/// `sizes(params, count)` returns `count` entries, the same every time.
#include "stresslet/base/type_list.hpp"
#include "stresslet/particles/sizes/discrete.hpp"
#include "stresslet/particles/sizes/lognormal.hpp"
#include "stresslet/particles/sizes/monodisperse.hpp"
#include "stresslet/particles/sizes/table.hpp"

namespace stresslet {

using SizeDistributionLaws = TypeList<Monodisperse, Discrete, Lognormal, Table>;

}  // namespace stresslet
