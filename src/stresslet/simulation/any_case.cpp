#include "stresslet/simulation/any_case.hpp"

#include <algorithm>
#include <array>

#include "stresslet/io/results_file.hpp"
#include "stresslet/simulation/fidelity.hpp"
#include "stresslet/simulation/fluid/plan.hpp"
#include "stresslet/simulation/fluid/run.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/run.hpp"

namespace stresslet {

namespace {

AnyCase read_any(InputDocument document, const std::vector<std::string>& overrides) {
  for (const std::string& assignment : overrides) document.override_key(assignment);
  if (fidelity_of(document) == Fidelity::fluid) return read_fluid_case(std::move(document));
  return read_case(std::move(document));
}

bool sets_fidelity(const std::string& assignment) { return assignment.starts_with(std::string(fidelity_key) + "="); }

/// What describes the particles' start in another way than a file, or has a default that depends on the fidelity.
constexpr std::array replaced_by_start{"suspension.solid_fraction=", "suspension.count=", "suspension.box_aspect=",
                                       "suspension.sizes=",          "suspension.box=",   "output.sample_every="};

/// A new, resolved run that starts from the last state of the lubricated one whose input is `text`.
ExitCode run_resolved_from(const std::filesystem::path& file, const std::string& text,
                           const std::vector<std::string>& overrides, const RunOptions& options) {
  if (options.output.empty())
    throw InputError({"--set fidelity=resolved", "no folder for the resolved run is given",
                      "it is a new run, which starts from the last state of the lubricated one; that keeps its results",
                      "name one with --output"});
  std::vector<std::string> all(replaced_by_start.begin(), replaced_by_start.end());
  all.push_back("suspension.file=" + std::filesystem::absolute(file).string());
  all.insert(all.end(), overrides.begin(), overrides.end());
  return run_case(read_any_case_text(text, file.string(), all), options);
}

}  // namespace

AnyCase read_any_case(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read_any(InputDocument::from_file(path), overrides);
}

AnyCase read_any_case_text(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                           const std::filesystem::path& folder) {
  return read_any(InputDocument::from_text(text, name, folder), overrides);
}

std::string resolved_toml(const AnyCase& settled) {
  return std::visit([](const auto& c) { return resolved_toml(c); }, settled);
}

std::string plan_report(const AnyCase& settled) {
  return std::visit([](const auto& c) { return plan_report(c, make_plan(c)); }, settled);
}

ExitCode run_case(const AnyCase& settled, const RunOptions& options) {
  return std::visit([&](const auto& c) { return run_case(c, options); }, settled);
}

ExitCode restart_any_run(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                         RunOptions options) {
  const std::filesystem::path file = folder / results_file_name;
  const std::string text = ResultsReader(file).resolved_input();
  InputDocument document = InputDocument::from_text(text, file.string());
  const Fidelity before = fidelity_of(document);
  if (std::any_of(overrides.begin(), overrides.end(), sets_fidelity)) {
    for (const std::string& assignment : overrides) document.override_key(assignment);
    if (before == Fidelity::lubricated && fidelity_of(document) == Fidelity::resolved)
      return run_resolved_from(file, text, overrides, options);
  }
  if (!options.output.empty())
    throw InputError({"--output " + options.output.string(), "a restart goes on in the folder of its run",
                      "series and checkpoints lie there; only a resolved run that starts from a lubricated one is new",
                      "leave --output out, or add --set fidelity=resolved"});
  options.output = folder;
  return before == Fidelity::fluid ? restart_fluid_run(overrides, options) : restart_run(overrides, options);
}

}  // namespace stresslet
