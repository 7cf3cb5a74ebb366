#include "stresslet/simulation/run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stresslet/exec/timer.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/results_folder.hpp"
#include "stresslet/rheology/profile.hpp"
#include "stresslet/simulation/checkpoint.hpp"
#include "stresslet/simulation/fluid/lattice_checkpoint.hpp"
#include "stresslet/simulation/monitor.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/progress.hpp"
#include "stresslet/simulation/resolved/fluid_profile.hpp"
#include "stresslet/simulation/resolved/fluid_sample.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/run_checkpoint.hpp"
#include "stresslet/simulation/run_parts.hpp"
#include "stresslet/simulation/snapshot.hpp"
#include "stresslet/simulation/stability.hpp"
#include "stresslet/simulation/step.hpp"
#include "stresslet/simulation/summary.hpp"

namespace stresslet {

namespace {

constexpr double strain_round_off = 1e-9;
constexpr double profile_from_without_average = 1.0;  // strain, where the steady state is detected afterwards
constexpr double stop_check_strain = 0.1;             // between two looks at run.relative_error

/// A run in progress.
struct Run {
  const Case& settled;
  const Plan& plan;
  const RunOptions& options;
  ThreadTeam team;
  Suspension suspension;
  ResultsFolder results;
  Series series;
  ShearProfile profile;
  FluidProfile fluid_profile;  ///< resolved runs only
  RunCost cost_before;         ///< of the sessions before this one
  Progress progress;
  CommitClock commit_clock;
  Timer wall;
  std::int64_t first_step = 0;
  double committed_strain = 0;

  RunCost cost() const {
    return {cost_before.wall_seconds + wall.seconds(),
            cost_before.particle_steps + double(suspension.steps - first_step) * double(plan.count()),
            suspension.spent};
  }
};

/// Index of the last event at multiples of `interval` up to this strain.
std::int64_t events_until(double strain, double interval) {
  return std::int64_t(std::floor((strain + strain_round_off) / interval));
}

/// Whether the last step passed a multiple of `interval`.
bool passed(const Run& run, double interval) {
  const double now = run.suspension.strain;
  return events_until(now, interval) != events_until(now - run.suspension.time.step, interval);
}

void take_sample(Run& run) {
  Suspension& s = run.suspension;
  const Timer timer;
  const Sample m = sample(s, run.team);
  if (s.resolved) check_fluid(s);
  check_finite(s);
  check_solver(s);
  FluidSample fluid;
  if (s.resolved) fluid = sample_fluid(s, run.team);
  s.spent.analysis += timer.seconds();
  run.results.add_sample(run.series.add(s.strain, m, double(run.plan.count()), s.solver_report.iterations, fluid));
  if (s.box.shear_rate > 0) {
    check_energy_balance(run.series, run.settled.run.monitor_tolerance);
    check_stress_closure(run.series, run.settled.run.monitor_tolerance);
  }
  if (s.strain < run.settled.run.average_from.value_or(profile_from_without_average) - strain_round_off) return;
  run.profile.add(s.state.y, s.state.ux, s.state.radius);
  if (s.resolved) run.fluid_profile.add(s.resolved->last_planes());
}

FluidColumns fluid_columns(const Plan& plan) {
  if (!plan.resolved) return FluidColumns::none;
  return plan.resolved->is_sheared() ? FluidColumns::resolved_and_sheared : FluidColumns::resolved;
}

void check_explicit_stability(Run& run) {
  if (run.suspension.time.scheme == "explicit")
    check_explicit_step(explicit_step_number(run.suspension, run.team), run.suspension.time.step);
}

void write_all(Run& run) {
  set_profiles(run.results, run.profile);
  Checkpoint checkpoint = make_checkpoint(run.suspension);
  add_run_state(checkpoint, run.profile.sums(), run.cost());
  const Suspension& s = run.suspension;
  if (s.resolved) {
    run.fluid_profile.put_into(run.results);
    run.fluid_profile.add_to(checkpoint);
    add_carried(checkpoint, s.resolved->carried());
    write_populations(run.results.path(), s.steps, s.resolved->populations(run.team));
  }
  run.results.commit(checkpoint);
  if (s.resolved) remove_other_populations(run.results.path(), s.steps);
  run.committed_strain = run.suspension.strain;
}

void commit(Run& run) {
  run.commit_clock.run([&] { write_all(run); });
  run.suspension.spent.output += run.commit_clock.cost();
}

void show_progress(Run& run) {
  const Suspension& s = run.suspension;
  const double done = double(s.steps - run.first_step);
  const double rate = done * double(run.plan.count()) / run.wall.seconds();
  const double left = (run.settled.run.strain - s.strain) / s.time.step * double(run.plan.count()) / rate;
  const AveragingWindow window = averaging_window(run.settled, run.series);
  const bool averaging = !run.settled.run.average_from || s.strain > *run.settled.run.average_from;
  const Estimate viscosity = mean_over(run.series, window, "relative_viscosity");
  const std::string value = averaging ? fmt::format("{:.4g} +- {:.2g}", viscosity.mean, viscosity.error)
                                      : fmt::format("{:.4g} (start)", run.series["relative_viscosity"].back());
  run.progress.show(fmt::format("strain {:.3f} of {:.4g}   viscosity {}   {:.2g} particle-steps/s   {} left", s.strain,
                                run.settled.run.strain, value, rate, duration_text(left)));
}

bool precise_enough(const Run& run) {
  if (!run.settled.run.relative_error || !passed(run, stop_check_strain)) return false;
  const AveragingWindow window = averaging_window(run.settled, run.series);
  if (!window.steady || run.series.size() - window.first_row < 100) return false;
  const Estimate viscosity = mean_over(run.series, window, "relative_viscosity");
  return viscosity.reliable && viscosity.error <= *run.settled.run.relative_error * std::abs(viscosity.mean);
}

/// Steps until the end, a stop from outside or the requested precision. Returns how it ended, for the summary.
std::string advance(Run& run) {
  Suspension& s = run.suspension;
  const OutputInput& output = run.settled.output;
  while (s.strain < run.settled.run.strain - strain_round_off) {
    step(s, run.team);
    if (s.resolved) check_sphere_speeds(s);
    const bool sampled = passed(run, *output.sample_every);
    if (sampled) take_sample(run);
    if (passed(run, output.snapshot_every)) {
      check_explicit_stability(run);
      run.results.add_snapshot(make_snapshot(s));
    }
    if (sampled) {
      if (run.progress.due()) show_progress(run);
      if (run.commit_clock.due()) commit(run);
      if (precise_enough(run)) return "converged";
    }
    if (run.options.stop && *run.options.stop) return "interrupted";
  }
  return "finished";
}

ExitCode finish(Run& run) {
  const std::string status = advance(run);
  commit(run);
  run.progress.finish();
  replace_file(run.results.path() / "summary.json",
               summary_json(run.settled, run.plan, run.series, run.profile.velocity_slope(), run.cost(), status));
  if (status == "interrupted") {
    spdlog::warn("stopped at strain {:.4g}; continue with: stresslet restart {}", run.suspension.strain,
                 run.results.path().string());
    return ExitCode::interrupted;
  }
  fmt::print("{}", summary_text(run.settled, run.series));
  fmt::print("results in {}\n", run.results.path().string());
  return ExitCode::success;
}

/// From the first commit to the end.
ExitCode commit_and_finish(Run& run) {
  commit_before_running([&] { commit(run); });
  return finish_or_explain(
      run.results, "its last state (suspension.file)", [&] { return finish(run); },
      [&] { return fmt::format("strain {:.6g}", run.committed_strain); });
}

OutputChoice output_choice(const Case& c) { return {c.output.csv, c.output.xyz, c.output.paraview}; }

}  // namespace

ExitCode run_case(const Case& settled, const RunOptions& options) {
  Plan plan = make_plan(settled);
  prepare_output_folder(options.output, options.force);
  fmt::print(stderr, "{}", options.quiet ? "" : plan_report(settled, plan) + "\n");

  Progress packing(options.quiet);
  Suspension suspension = make_suspension(settled, plan, [&](double done) {
    if (packing.due()) packing.show(fmt::format("packing {:.0f} %", 100 * done));
  });
  packing.finish();

  const Box box = suspension.box;
  plan.solid_fraction = solid_fraction(plan.radii, box);
  Run run{settled,
          plan,
          options,
          ThreadTeam(plan.threads),
          std::move(suspension),
          ResultsFolder::start(options.output, series_columns(fluid_columns(plan)), resolved_toml(settled),
                               provenance(options.command_line, plan.threads, settled.suspension.seed),
                               output_choice(settled)),
          Series(fluid_columns(plan)),
          ShearProfile(box, std::size_t(settled.output.profile_bins)),
          plan.resolved ? FluidProfile(*plan.resolved) : FluidProfile(),
          {},
          Progress(options.quiet),
          CommitClock(settled.output.commit_every),
          {}};
  start(run.suspension, run.team);
  take_sample(run);
  check_explicit_stability(run);
  run.results.add_snapshot(make_snapshot(run.suspension));
  return commit_and_finish(run);
}

ExitCode restart_run(const std::vector<std::string>& overrides, const RunOptions& options) {
  const ResultsReader reader(options.output / results_file_name);
  refuse_changed_physics(overrides, changeable_by_restart,
                         "start a new run from its last state with suspension.file = its results.h5");
  const Case settled =
      read_case_text(reader.resolved_input(), (options.output / results_file_name).string(), overrides);
  const Plan plan = make_restart_plan(settled, reader);

  Suspension suspension = make_empty_suspension(plan);
  const Checkpoint checkpoint = reader.checkpoint();
  restore_checkpoint(suspension, checkpoint);
  if (settled.run.strain <= suspension.strain + strain_round_off)
    throw InputError({options.output.string(),
                      fmt::format("the run has reached strain {:.4g} of {:.4g}", suspension.strain, settled.run.strain),
                      "there is nothing left to do", "ask for more with --set run.strain=..."});
  ShearProfile profile(suspension.box, std::size_t(settled.output.profile_bins));
  profile.restore(profile_sums(checkpoint));

  Run run{settled,
          plan,
          options,
          ThreadTeam(plan.threads),
          std::move(suspension),
          ResultsFolder::resume(options.output, series_columns(fluid_columns(plan)), resolved_toml(settled),
                                provenance(options.command_line, plan.threads, settled.suspension.seed),
                                output_choice(settled)),
          restored_series(reader, fluid_columns(plan)),
          std::move(profile),
          plan.resolved ? FluidProfile(*plan.resolved) : FluidProfile(),
          run_cost(checkpoint),
          Progress(options.quiet),
          CommitClock(settled.output.commit_every),
          {}};
  run.first_step = run.suspension.steps;
  resume(run.suspension);
  if (Suspension& s = run.suspension; s.resolved) {
    s.resolved->restore(run.team, read_populations(options.output, s.steps), s.steps, s.box.offset);
    s.resolved->set_carried(carried_across(checkpoint));
    run.fluid_profile.restore(checkpoint);
  }
  return commit_and_finish(run);
}

}  // namespace stresslet
