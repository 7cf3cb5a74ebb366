#include "stresslet/simulation/resolved/resolution_section.hpp"

#include "stresslet/coupling/weight_choice.hpp"

namespace stresslet {

void settle(ResolutionInput& r) {
  const bool thesis = r.preset == ResolutionPreset::thesis, fast = r.preset == ResolutionPreset::fast;
  const auto choose = [](auto& key, auto value) {
    if (!key) key = value;
  };
  choose(r.cells_per_diameter, fast ? 8.0 : 10.0);
  choose(r.relaxation_time, thesis ? 0.65 : fast ? 2.0 : 1.0);
  choose(r.magic_parameter, 1.0 / 12);
  choose(r.precision, fast ? Precision::floating32 : Precision::floating64);
  choose(r.collision, thesis ? Bgk::name : Trt::name);
  choose(r.coupling, Superposition::name);
  choose(r.solid_fraction, PlaneCut::name);
  choose(r.solid_weight, thesis ? LinearWeight::name : default_weight(*r.coupling));
  choose(r.correction, thesis ? HardCutOff::name : SoftCutOff::name);
}

}  // namespace stresslet
