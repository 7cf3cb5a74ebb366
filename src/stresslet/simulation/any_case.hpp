#pragma once
/// A case of any fidelity, read, planned, run and continued by the same words.
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/fluid/case.hpp"
#include "stresslet/simulation/run_options.hpp"

namespace stresslet {

using AnyCase = std::variant<Case, FluidCase>;

/// As `read_case` and `read_case_text`, the kind of case chosen by the key `fidelity`.
AnyCase read_any_case(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
AnyCase read_any_case_text(std::string_view text, const std::string& name,
                           const std::vector<std::string>& overrides = {}, const std::filesystem::path& folder = {});

std::string resolved_toml(const AnyCase& settled);
/// Everything derived from the case, for people.
std::string plan_report(const AnyCase& settled);

ExitCode run_case(const AnyCase& settled, const RunOptions& options);
/// Continues whatever run lies in `folder`, there; `options.output` is empty. One exception: where `overrides` turn a
/// lubricated run into a resolved one, its last state is the start of a new run in `options.output`.
ExitCode restart_any_run(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                         RunOptions options);

}  // namespace stresslet
