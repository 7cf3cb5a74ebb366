#pragma once
/// Contact laws. If unsure use `hooke`: below jamming the rheology depends neither on the law nor on its stiffness
/// (Najuch 2018, ch. 6), and a linear spring has one time scale.
///
/// | law   | force            | stiffness         | duration of a dry collision |
/// |-------|------------------|-------------------|-----------------------------|
/// | hooke | kn overlap       | force per length  | independent of speed        |
/// | hertz | kn overlap^(3/2) | pressure          | falls as speed^(-1/5)       |
#include "stresslet/base/type_list.hpp"
#include "stresslet/dem/contact/normal/hertz.hpp"
#include "stresslet/dem/contact/normal/hooke.hpp"

namespace stresslet {

using NormalContactLaws = TypeList<Hooke, Hertz>;

}  // namespace stresslet
