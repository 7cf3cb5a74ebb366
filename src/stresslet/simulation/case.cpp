#include "stresslet/simulation/case.hpp"

#include <algorithm>

#include "stresslet/dem/laws.hpp"
#include "stresslet/io/schema_read.hpp"
#include "stresslet/io/schema_text.hpp"
#include "stresslet/simulation/case_checks.hpp"
#include "stresslet/simulation/fidelity.hpp"

namespace stresslet {
namespace {

constexpr double default_stokes = 0.1;
constexpr std::int64_t default_count = 1000, resolved_count = 300;
constexpr std::string_view default_model = "CLM-S";
constexpr double default_sampling = 0.001, default_resolved_sampling = 0.01;  // strain

Case read_document(InputDocument document, const std::vector<std::string>& overrides) {
  for (const std::string& assignment : overrides) document.override_key(assignment);
  return read_case(std::move(document));
}

}  // namespace

Case read_case(InputDocument document) {
  const Fidelity fidelity = fidelity_of(document);
  if (fidelity == Fidelity::fluid)
    throw InputError({document.where(fidelity_key), "this is no case of a suspension", "it has fluid alone",
                      "give a case with fidelity = \"lubricated\" or \"resolved\""});
  Case result = read_described<Case>(document, {fidelity_key});
  result.fidelity = fidelity;
  result.source.document = std::move(document);
  check_case(result);
  settle(result);
  return result;
}

ModelSwitches Case::switches() const {
  if (model.name) return switches_of_model(*model.name).value();
  return {model.lubrication.value(), model.drag.value(), model.stresslet.value()};
}

double Case::stokes_number() const {
  if (units) return units->density * units->diameter * units->diameter * units->shear_rate / units->viscosity;
  return flow.stokes.value();
}

std::optional<double> Case::contact_stiffness() const {
  if (contact.stiffness) return contact.stiffness;
  if (!contact.stiffness_si) return std::nullopt;
  const UnitsInput& si = units.value();
  const double stress = si.viscosity * si.shear_rate;
  return *contact.stiffness_si / (contact.normal == "hertz" ? stress : stress * si.diameter);
}

void settle(Case& settled) {
  SuspensionInput& suspension = settled.suspension;
  if (!suspension.file) {
    if (!suspension.count) suspension.count = default_count;
    if (!suspension.box_aspect) suspension.box_aspect = Vec3<double>{1, 1, 1};
    if (!suspension.sizes) suspension.sizes.emplace();
    SizesInput& sizes = *suspension.sizes;
    if (sizes.law == SizeLaw::discrete && !sizes.diameters) {
      sizes.diameters = {1.0, 1.4};
      sizes.volume_shares = {0.5, 0.5};
    }
  }
  ModelInput& model = settled.model;
  if (!model.name && !model.lubrication) model.name = default_model;
  ContactInput& contact = settled.contact;
  if (!contact.stiffness && !contact.stiffness_si && !contact.largest_overlap)
    NormalContactLaws::dispatch(contact.normal,
                                [&](auto law) { contact.stiffness = decltype(law)::type::default_stiffness; });
  if (!settled.units && !settled.flow.stokes) settled.flow.stokes = default_stokes;
  if (!settled.output.sample_every)
    settled.output.sample_every =
        std::min(settled.resolved() ? default_resolved_sampling : default_sampling, settled.run.strain);
  if (settled.resolved()) {
    if (!settled.flow.reynolds) settled.flow.reynolds = settled.stokes_number();
    if (!settled.resolution) settled.resolution.emplace();
    settle(*settled.resolution);
  }
}

Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read_document(InputDocument::from_file(path), overrides);
}

Case read_case_text(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                    const std::filesystem::path& folder) {
  return read_document(InputDocument::from_text(text, name, folder), overrides);
}

std::string resolved_toml(const Case& resolved) {
  const std::string head = resolved.resolved() ? "fidelity = \"resolved\"\n\n" : "";
  return head + resolved_text(described(resolved));
}

std::string new_case_template(Fidelity fidelity) {
  Case standard;
  standard.fidelity = fidelity;
  standard.suspension.solid_fraction = 0.5;
  standard.run.strain = 10;
  standard.run.average_from = 2;
  if (fidelity == Fidelity::resolved) standard.suspension.count = resolved_count;
  settle(standard);
  return "# Input of stresslet. Lengths are in units of the diameter d1, times in 1/shear rate.\n"
         "# Keys that are commented out show their defaults.\n\n" +
         std::string(standard.resolved() ? "fidelity = \"resolved\"\n\n" : "") + template_text(described(standard));
}

}  // namespace stresslet
