#pragma once
/// What a run keeps in its checkpoint besides the suspension, and what a restart reads back.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "stresslet/io/results_folder.hpp"
#include "stresslet/rheology/profile.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/series.hpp"
#include "stresslet/simulation/summary.hpp"

namespace stresslet {

void add_run_state(Checkpoint& checkpoint, const ProfileSums& profile, const RunCost& cost);
ProfileSums profile_sums(const Checkpoint& checkpoint);
RunCost run_cost(const Checkpoint& checkpoint);

Series restored_series(const ResultsReader& reader, FluidColumns fluid);

/// Puts the profiles of velocity and solid fraction into the results.
void set_profiles(ResultsFolder& results, const ShearProfile& profile);

/// Keys that may be overridden when a run goes on.
inline constexpr std::array<std::string_view, 9> changeable_by_restart{
    "run.strain",          "run.average_from", "run.relative_error", "run.threads",    "run.monitor_tolerance",
    "output.commit_every", "output.csv",       "output.xyz",         "output.paraview"};

/// The plan of a continuation: particles and box come from the checkpoint instead of a packing or a start file.
Plan make_restart_plan(const Case& settled, const ResultsReader& reader);

}  // namespace stresslet
