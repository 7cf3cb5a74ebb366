#include "stresslet/simulation/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/case_refusals.hpp"

namespace stresslet {
namespace {

/// Densest packing of equal spheres, pi / sqrt(18) (Kepler; Hales 2005).
constexpr double densest_equal_spheres = std::numbers::pi / (3 * std::numbers::sqrt2);
constexpr double densest_considered = 0.9;
constexpr double share_sum_tolerance = 1e-3;

void check_suspension(const Case& read) {
  const SuspensionInput& suspension = read.suspension;
  if (suspension.file) {
    refuse_any_with(read, "suspension.file",
                    {{"suspension.solid_fraction", suspension.solid_fraction.has_value()},
                     {"suspension.count", suspension.count.has_value()},
                     {"suspension.box_aspect", suspension.box_aspect.has_value()},
                     {"suspension.sizes", suspension.sizes.has_value()}},
                    "the file already holds the particles and the box");
    return;
  }
  if (suspension.box)
    refuse(read.where("suspension.box"), "suspension.box is given without suspension.file",
           "the box of a random packing follows from solid_fraction, count and box_aspect",
           "remove it, or name a start configuration in suspension.file");
  if (!suspension.solid_fraction)
    refuse(read.where("suspension.solid_fraction"), "suspension.solid_fraction is missing",
           "without a start configuration in suspension.file, a packing is made, and its density has no default",
           "add solid_fraction = ... (> 0 and < 1) to [suspension], or name a start configuration in suspension.file");

  const double solid_fraction = *suspension.solid_fraction;
  const auto& sizes = suspension.sizes;
  const bool one_size =
      sizes && (sizes->law == SizeLaw::monodisperse || (sizes->diameters && sizes->diameters->size() == 1));
  if (one_size && solid_fraction > densest_equal_spheres)
    refuse(read.where("suspension.solid_fraction"),
           fmt::format("suspension.solid_fraction = {} can never be reached", solid_fraction),
           fmt::format("equal spheres fill at most {:.4f} of space, as a crystal", densest_equal_spheres),
           "lower it; disordered equal spheres that can be sheared stay below about 0.62");
  if (solid_fraction > densest_considered)
    refuse(read.where("suspension.solid_fraction"),
           fmt::format("suspension.solid_fraction = {} is out of reach", solid_fraction),
           fmt::format("no random packing of spheres exceeds {}", densest_considered),
           "lower it; two sizes 1 : 1.4 jam near 0.65, and with friction below 0.6");
}

void check_shares(const Case& read, std::string_view key, const std::vector<double>& shares, std::size_t sizes) {
  if (shares.size() != sizes)
    refuse(read.where(key), fmt::format("{} has {} entries", key, shares.size()),
           fmt::format("suspension.sizes.diameters has {}, and each size needs its share", sizes),
           "give both lists the same length");
  double sum = 0;
  for (const double share : shares) sum += share;
  if (std::abs(sum - 1) <= share_sum_tolerance) return;
  std::string scaled;
  for (const double share : shares) scaled += fmt::format("{}{:.4g}", scaled.empty() ? "" : ", ", share / sum);
  refuse(read.where(key), fmt::format("{} adds up to {:.6g}", key, sum), "shares must add up to 1",
         fmt::format("for instance [{}]", scaled));
}

void check_discrete_sizes(const Case& read, const SizesInput& sizes) {
  const auto& shares = sizes.volume_shares ? sizes.volume_shares : sizes.number_shares;
  const std::string_view key =
      sizes.volume_shares ? "suspension.sizes.volume_shares" : "suspension.sizes.number_shares";
  if (sizes.volume_shares && sizes.number_shares)
    refuse_both(read, "suspension.sizes.volume_shares", "suspension.sizes.number_shares",
                "each fixes the number of particles of every size");
  if (!sizes.diameters && shares)
    refuse(read.where(key), fmt::format("{} is given without suspension.sizes.diameters", key),
           "a share belongs to a diameter", "add diameters = [...] to [suspension.sizes], one for each share");
  if (!sizes.diameters) return;
  const std::string diameters = "suspension.sizes.diameters";
  if (sizes.diameters->empty())
    refuse(read.where(diameters), diameters + " is an empty list", "there must be at least one size",
           "give a number > 0 for each size");
  if (!shares)
    refuse(read.where(diameters), "suspension.sizes.diameters is given without shares",
           "it must be known how many particles each size has",
           "add volume_shares = [...] or number_shares = [...] to [suspension.sizes], one share for each diameter");
  check_shares(read, key, *shares, sizes.diameters->size());
}

/// A key of [suspension.sizes], the law it belongs to, and whether that law needs it.
struct SizeKey {
  std::string_view key;
  bool given;
  SizeLaw owner;
  bool needed;
};

void check_sizes(const Case& read) {
  if (!read.suspension.sizes) return;
  const SizesInput& sizes = *read.suspension.sizes;
  for (const SizeKey& entry : {
           SizeKey{"diameters", sizes.diameters.has_value(), SizeLaw::discrete, false},
           SizeKey{"volume_shares", sizes.volume_shares.has_value(), SizeLaw::discrete, false},
           SizeKey{"number_shares", sizes.number_shares.has_value(), SizeLaw::discrete, false},
           SizeKey{"median_diameter", sizes.median_diameter.has_value(), SizeLaw::lognormal, true},
           SizeKey{"sigma", sizes.sigma.has_value(), SizeLaw::lognormal, true},
           SizeKey{"smallest", sizes.smallest.has_value(), SizeLaw::lognormal, true},
           SizeKey{"largest", sizes.largest.has_value(), SizeLaw::lognormal, true},
           SizeKey{"file", sizes.file.has_value(), SizeLaw::table, true},
           SizeKey{"shares", sizes.shares.has_value(), SizeLaw::table, true},
       }) {
    const std::string key = fmt::format("suspension.sizes.{}", entry.key);
    const std::string_view law = keyword(sizes.law);
    if (entry.given && entry.owner != sizes.law)
      refuse(read.where(key), key + " has no effect",
             fmt::format("it belongs to law = \"{}\", but the law is \"{}\"", keyword(entry.owner), law),
             fmt::format("remove it, or write law = \"{}\" in [suspension.sizes]", keyword(entry.owner)));
    if (!entry.given && entry.needed && entry.owner == sizes.law)
      refuse(read.where(key), key + " is missing", fmt::format("law = \"{}\" needs it", law),
             fmt::format("add {} = ... to [suspension.sizes]", entry.key));
  }
  if (sizes.law == SizeLaw::discrete) check_discrete_sizes(read, sizes);
  if (sizes.law == SizeLaw::lognormal && !(*sizes.smallest < *sizes.largest))
    refuse(read.where("suspension.sizes.smallest"),
           fmt::format("suspension.sizes.smallest = {} is not below largest = {}", *sizes.smallest, *sizes.largest),
           fmt::format("no diameter lies between them; largest is given at {}", read.where("suspension.sizes.largest")),
           "exchange or correct the two");
}

void check_flow_and_units(const Case& read) {
  if (read.units && read.flow.stokes)
    refuse_both(read, "flow.stokes", "units", "the Stokes number follows from the four values of [units]");
  if (read.units && !std::isfinite(read.stokes_number()))
    refuse(read.where("units"), "the Stokes number of [units] is not finite",
           "density diameter^2 shear_rate / viscosity overflows",
           "check the powers of ten: all values are in SI units");
  if (read.units && !(read.stokes_number() > 0))
    refuse(read.where("units"), "the Stokes number of [units] is zero",
           "density diameter^2 shear_rate / viscosity underflows",
           "check the powers of ten: all values are in SI units");
}

void check_model(const Case& read) {
  const ModelInput& model = read.model;
  const std::initializer_list<Given> switches{{"model.lubrication", model.lubrication.has_value()},
                                              {"model.drag", model.drag.has_value()},
                                              {"model.stresslet", model.stresslet.has_value()}};
  if (model.name) {
    refuse_any_with(read, "model.name", switches, "a model's name already sets lubrication, drag and stresslet");
    return;
  }
  const bool any = model.lubrication || model.drag || model.stresslet;
  for (const Given& entry : switches)
    if (any && !entry.given)
      refuse(read.where(entry.key), fmt::format("{} is missing", entry.key),
             "without model.name, the three switches lubrication, drag and stresslet are all needed",
             "add it to [model], or give model.name in place of the switches");
}

void check_contact(const Case& read) {
  const ContactInput& contact = read.contact;
  constexpr std::string_view reason = "each of them fixes the stiffness of contacts";
  if (contact.stiffness)
    refuse_any_with(read, "contact.stiffness",
                    {{"contact.stiffness_si", contact.stiffness_si.has_value()},
                     {"contact.largest_overlap", contact.largest_overlap.has_value()}},
                    reason);
  if (contact.stiffness_si && contact.largest_overlap)
    refuse_both(read, "contact.stiffness_si", "contact.largest_overlap", reason);
  if (contact.stiffness_si && !read.units)
    refuse(read.where("contact.stiffness_si"), "contact.stiffness_si is given without [units]",
           "viscosity, shear rate and diameter in SI units are needed to make it dimensionless",
           "add [units], or give contact.stiffness, which has no dimension");
}

void check_lubrication(const Case& read) {
  const LubricationInput& lubrication = read.lubrication;
  if (lubrication.inner_cutoff < lubrication.outer_cutoff) return;
  refuse(read.where("lubrication.inner_cutoff"),
         fmt::format("lubrication.inner_cutoff = {} is not below outer_cutoff = {}", lubrication.inner_cutoff,
                     lubrication.outer_cutoff),
         fmt::format("lubrication acts between the two gaps; outer_cutoff is given at {}",
                     read.where("lubrication.outer_cutoff")),
         "exchange or correct the two; 0.001 and 0.05 are usual");
}

void check_time(const Case& read) {
  if (read.time.scheme != "inertialess") return;
  const bool drag = read.model.name ? switches_of_model(*read.model.name)->drag : read.model.drag.value_or(true);
  if (!drag)
    refuse(read.where("time.scheme"), "the inertialess scheme needs a model with Stokes drag",
           fmt::format("without Stokes drag the resistance is singular: particles far from others would move freely; "
                       "the model is chosen at {}",
                       read.where(read.model.name ? "model.name" : "model.drag")),
           "choose a model with drag (CLM-S, NLM-S, GRM), or time.scheme = \"semi-implicit\"");
  if (read.contact.restitution != 1)
    refuse(read.where("contact.restitution"),
           fmt::format("contact.restitution = {} does not go with the inertialess scheme", read.contact.restitution),
           fmt::format("without inertia nothing rebounds, and a dashpot has no mass to be derived from; the scheme is "
                       "chosen at {}",
                       read.where("time.scheme")),
           "remove it or give 1, or choose time.scheme = \"semi-implicit\"");
}

/// What the resolved fluid cannot do. What it alone needs may stay in the case of another fidelity.
void check_fidelity(const Case& read) {
  if (!read.resolved()) return;
  if (read.time.scheme != "semi-implicit")
    refuse(read.where("time.scheme"), fmt::format("the scheme {} does not go with a resolved fluid", read.time.scheme),
           "particles must move semi-implicitly with the fluid that they hold", "leave time.scheme out");
  if (read.time.step)
    refuse(read.where("time.step"), "time.step is given for a resolved fluid",
           "the lattice fixes the step: nu_lu dx^2 Re", "remove it; resolution.relaxation_time changes the step");
  const bool strain = read.model.name ? switches_of_model(*read.model.name)->lubrication == "grand-resistance"
                                      : read.model.lubrication.value_or("") == "grand-resistance";
  if (strain)
    refuse(read.where(read.model.name ? "model.name" : "model.lubrication"),
           "the full pair resistance does not go with a resolved fluid", "the lattice resolves the strain terms itself",
           "choose a model with all modes (CLM-S) or the normal mode (NLM-S)");
  if (read.resolution && read.resolution->correction_lengths && read.resolution->correction_lengths->size() != 3)
    refuse(read.where("resolution.correction_lengths"),
           fmt::format("resolution.correction_lengths has {} entries", read.resolution->correction_lengths->size()),
           "there are three modes: normal, sliding, opposite rotation", "give three lengths, in cells");
}

void check_run(const Case& read) {
  if (read.run.average_from && !(*read.run.average_from < read.run.strain))
    refuse(read.where("run.average_from"),
           fmt::format("run.average_from = {} is not below run.strain = {}", *read.run.average_from, read.run.strain),
           "the run would end before the first mean is taken", "lower it, or raise run.strain");
  if (read.output.sample_every && *read.output.sample_every > read.run.strain)
    refuse(read.where("output.sample_every"),
           fmt::format("output.sample_every = {} exceeds run.strain = {}", *read.output.sample_every, read.run.strain),
           "the run would end before the first sample", "lower it, or raise run.strain");
}

}  // namespace

void check_case(const Case& read) {
  check_suspension(read);
  check_sizes(read);
  check_flow_and_units(read);
  check_model(read);
  check_contact(read);
  check_lubrication(read);
  check_time(read);
  check_fidelity(read);
  check_run(read);
}

}  // namespace stresslet
