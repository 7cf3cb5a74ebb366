#include "stresslet/simulation/reference.hpp"

#include "stresslet/io/schema_text.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/fluid/case.hpp"

namespace stresslet {

std::string input_reference_markdown() {
  return "# Input reference\n\n"
         "Generated from the code; a test keeps it current. An input is a TOML file. The key `fidelity`, above all "
         "sections, chooses the kind of case: `\"lubricated\"` (suspensions, the default), `\"resolved\"` (the same "
         "suspensions with the fluid solved for) or `\"fluid\"` (flow without particles, [below](#fluid-cases)). Every "
         "other key belongs to a section; a key that nothing reads is an "
         "error.\n\n"
         "Any key can be overridden on the command line: `--set suspension.solid_fraction=0.55`, "
         "`--set model.name=NLM`. The value is TOML, or a bare text where it is none. `--set contact.stiffness=` "
         "removes a key that the file gives. Relative file names start from the folder of the input, in overrides from "
         "the working directory.\n\n"
         "# Suspensions\n\n"
         "Lengths are in units of the diameter d1, times in 1/shear rate, stresses in viscosity times shear rate.\n" +
         markdown_text(described(Case{})) +
         "\n# Fluid cases\n\n"
         "With `fidelity = \"fluid\"`. Lengths are in units of a reference length L, velocities of a reference "
         "velocity "
         "U, times of L/U, pressures of rho U^2, rho the density of the fluid.\n" +
         markdown_text(described(FluidCase{}));
}

}  // namespace stresslet
