#include "stresslet/simulation/any_case.hpp"

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

ExitCode restart_any_run(const std::vector<std::string>& overrides, const RunOptions& options) {
  const std::filesystem::path file = options.output / results_file_name;
  InputDocument document = InputDocument::from_text(ResultsReader(file).resolved_input(), file.string());
  return fidelity_of(document) == Fidelity::fluid ? restart_fluid_run(overrides, options)
                                                  : restart_run(overrides, options);
}

}  // namespace stresslet
