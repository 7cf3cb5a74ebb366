#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/dem/laws.hpp"
#include "stresslet/lattice/boundary/interpolation.hpp"
#include "stresslet/lattice/boundary/laws.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lubrication/laws.hpp"
#include "stresslet/particles/sizes/laws.hpp"
#include "stresslet/simulation/case_choices.hpp"
#include "stresslet/simulation/fluid/initial_fields.hpp"
#include "stresslet/simulation/reference.hpp"
#include "stresslet/simulation/schemes/laws.hpp"
#include "stresslet/simulation/series.hpp"

namespace stresslet {

namespace {

template <class List>
void print_laws(const char* title, const char* key) {
  fmt::print("{} ({})\n", title, key);
  List::for_each([](auto tag) {
    using Law = typename decltype(tag)::type;
    fmt::print("  {:<22}{}\n", Law::name, Law::summary);
  });
}

void print_models() {
  fmt::print("models (model.name)\n");
  for (const NamedModel& m : named_models)
    fmt::print("  {:<22}lubrication {}{}{}\n", m.name, m.switches.lubrication, m.switches.drag ? ", Stokes drag" : "",
               m.switches.stresslet ? ", stresslet" : "");
}

}  // namespace

void add_list(CLI::App& app, ExitCode&) {
  auto what = std::make_shared<std::string>("laws");
  CLI::App* command = app.add_subcommand("list", "List what can be chosen: laws, columns of the series, or input keys");
  command->add_option("WHAT", *what, "laws, columns or keys")->check(CLI::IsMember({"laws", "columns", "keys"}));
  command->callback([what] {
    if (*what == "keys") {
      fmt::print("{}", input_reference_markdown());
    } else if (*what == "columns") {
      for (const Column& c : series_columns(FluidColumns::resolved_and_sheared))
        fmt::print("{:<40}{:<26}{}\n", c.name, c.unit, c.description);
    } else {
      print_models();
      print_laws<LubricationLaws>("pair lubrication", "model.lubrication");
      print_laws<NormalContactLaws>("contact", "contact.normal");
      print_laws<TimeSchemes>("time schemes", "time.scheme");
      print_laws<SizeDistributionLaws>("size distributions", "suspension.sizes.law");
      print_laws<Stencils>("fluid: stencils", "lattice.stencil");
      print_laws<CollisionLaws>("fluid: collision", "lattice.collision");
      print_laws<ForcingLaws>("fluid: body force", "force.law");
      print_laws<BoundaryLaws>("fluid: faces", "boundaries.x_low.law");
      print_laws<ShearInterpolations>("fluid: sheared box", "boundaries.shear_interpolation");
      print_laws<SubgridLaws>("resolved: sub-grid lubrication", "stresslet calibrate --law");
      print_laws<InitialFields>("fluid: start", "initial.state");
    }
  });
}

}  // namespace stresslet
