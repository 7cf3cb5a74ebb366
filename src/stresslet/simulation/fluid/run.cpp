#include "stresslet/simulation/fluid/run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "stresslet/exec/timer.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/field_file.hpp"
#include "stresslet/io/results_folder.hpp"
#include "stresslet/simulation/fidelity.hpp"
#include "stresslet/simulation/fluid/drive.hpp"
#include "stresslet/simulation/fluid/fields.hpp"
#include "stresslet/simulation/fluid/lattice_checkpoint.hpp"
#include "stresslet/simulation/fluid/plane_averages.hpp"
#include "stresslet/simulation/fluid/sample.hpp"
#include "stresslet/simulation/fluid/start.hpp"
#include "stresslet/simulation/fluid/summary.hpp"
#include "stresslet/simulation/progress.hpp"
#include "stresslet/simulation/run_parts.hpp"
#include "stresslet/simulation/stored.hpp"

namespace stresslet {

namespace {

constexpr double cell_steps_between_looks = 2e6;  // at signals and the clock, per thread
constexpr std::size_t steady_samples = 10;
constexpr std::array<std::string_view, 6> changeable_by_restart{
    "run.end_time", "run.steady_tolerance", "run.threads", "output.commit_every", "output.csv", "output.paraview"};

/// A run in progress.
struct Run {
  const FluidCase& settled;
  const FluidPlan& plan;
  const RunOptions& options;
  ThreadTeam team;
  FluidSetup setup;
  std::unique_ptr<Fluid> fluid;
  ResultsFolder results;
  FlowField field;
  PlaneAverages averages;
  Progress progress;
  CommitClock commit_clock;
  std::vector<Column> columns;
  std::vector<double> row;                          // of the last sample
  std::vector<double> kinetic_energy, dissipation;  // of all samples
  std::vector<FieldFile> field_headers;
  FluidRunCost cost_before;  // of the sessions before this one
  std::int64_t first_step = 0, committed_step = 0;
  bool new_run = true, first_commit = true;  // no commit yet; none of this session
  Timer wall;

  Run(const FluidCase& c, const FluidPlan& p, const RunOptions& o, ResultsFolder r)
      : settled(c),
        plan(p),
        options(o),
        team(p.threads),
        setup(complete_setup(c, p)),
        fluid(make_fluid(c, setup)),
        results(std::move(r)),
        field(setup),
        averages(p, c.output.profile_axis),
        progress(o.quiet),
        commit_clock(c.output.commit_every),
        columns(fluid_columns(c, p)) {}

  std::int64_t step() const { return fluid->steps(); }
  FluidRunCost cost() const {
    return {cost_before.wall_seconds + wall.seconds(),
            cost_before.cell_steps + double(step() - first_step) * plan.cells()};
  }
  std::size_t column(std::string_view name) const {
    return std::size_t(std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; }) -
                       columns.begin());
  }
};

ResultsFolder start_folder(const FluidCase& c, const FluidPlan& plan, const RunOptions& options, bool resumed) {
  const auto open = resumed ? ResultsFolder::resume : ResultsFolder::start;
  return open(options.output, fluid_columns(c, plan), resolved_toml(c),
              provenance(options.command_line, plan.threads, 0), {c.output.csv, false, false});
}

bool due(std::int64_t step, std::int64_t every, const Run& run) {
  return every > 0 ? step % every == 0 : step == run.plan.steps;
}

void write_fields(Run& run, const std::vector<std::string>& names, const CellBox& box) {
  if (names.empty()) return;
  const std::filesystem::path folder = run.results.path() / fields_folder;
  std::filesystem::create_directories(folder);
  FieldFile fields = make_fields(run.field, run.plan, names, box, run.step());
  write_field_file(folder / field_file_name(run.step()), fields);
  for (Field& field : fields.fields) field.values.clear();
  run.field_headers.push_back(std::move(fields));
  if (run.settled.output.paraview)
    replace_file(run.results.path() / fields_xdmf_name, fields_xdmf_text(run.field_headers));
}

/// Measures the fluid; a defect ends the run, with the fields of this moment written.
void measure(Run& run) {
  run.field.measure(*run.fluid, run.team);
  const auto complaint = defect(run.field, run.plan.time(run.step()));
  if (!complaint) return;
  const Cells& n = run.field.size();
  write_fields(run, {"velocity", "pressure"}, {{0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}});
  spdlog::warn("the fields of this moment are in {}",
               (run.results.path() / fields_folder / field_file_name(run.step())).string());
  throw NumericalFailure(*complaint);
}

void take_sample(Run& run) {
  run.row = sample_row(run.settled, run.plan, run.field, run.step(), run.team);
  run.results.add_sample(run.row);
  run.kinetic_energy.push_back(run.row[run.column("kinetic_energy")]);
  run.dissipation.push_back(run.row[run.column("dissipation_from_gradients")]);
}

/// Whatever is due at the present step.
void observe(Run& run) {
  const std::int64_t step = run.step();
  const bool sample = step % run.plan.sample_every == 0;
  const bool fields = due(step, run.plan.fields_every, run);
  const bool profile = step == 0 || due(step, run.plan.profile_every, run);
  if (!sample && !fields && !profile) return;
  measure(run);
  if (sample) take_sample(run);
  if (profile) run.averages.add(run.field, step);
  if (fields && !run.new_run) write_fields(run, run.settled.output.fields, run.plan.fields_box);
}

void write_all(Run& run) {
  const std::filesystem::path& folder = run.results.path();
  write_populations(folder, run.step(), run.fluid->populations(run.team));
  for (Profile& profile : run.averages.profiles()) run.results.set_profile(std::move(profile));
  Checkpoint checkpoint;
  checkpoint.scalars["step"] = run.step();
  checkpoint.scalars["shear_offset"] = run.fluid->shear_offset();
  checkpoint.scalars["wall_seconds"] = run.cost().wall_seconds;
  checkpoint.scalars["cell_steps"] = run.cost().cell_steps;
  if (run.new_run) std::filesystem::remove(folder / fields_xdmf_name);
  if (run.first_commit) remove_field_files(folder, run.new_run ? -1 : run.step());
  run.results.commit(checkpoint);
  remove_other_populations(folder, run.step());
  run.new_run = run.first_commit = false;
  run.committed_step = run.step();
}

void commit(Run& run) {
  run.commit_clock.run([&] { write_all(run); });
}

double largest_relative_change(const std::vector<double>& values) {
  const auto [lowest, highest] = std::minmax_element(values.end() - steady_samples, values.end());
  return *highest > 0 ? (*highest - *lowest) / *highest : 0;
}

bool steady(const Run& run) {
  const auto& tolerance = run.settled.run.steady_tolerance;
  return tolerance && run.kinetic_energy.size() > steady_samples && run.step() % run.plan.sample_every == 0 &&
         largest_relative_change(run.kinetic_energy) <= *tolerance &&
         largest_relative_change(run.dissipation) <= *tolerance;
}

void show_progress(Run& run) {
  const double rate = double(run.step() - run.first_step) * run.plan.cells() / run.wall.seconds();
  const double left = double(run.plan.steps - run.step()) * run.plan.cells() / rate;
  run.progress.show(fmt::format("time {:.4g} of {:.4g}   largest speed {:.4g} U   {:.3g} cell-steps/s   {} left",
                                run.plan.time(run.step()), run.plan.time(run.plan.steps),
                                run.row.empty() ? 0.0 : run.row[run.column("largest_speed")], rate,
                                duration_text(left)));
}

/// Steps until the next event, in pieces short enough to notice a signal.
std::int64_t steps_to_go(const Run& run, std::int64_t piece) {
  const std::int64_t now = run.step();
  std::int64_t next = std::min(run.plan.steps, now + piece);
  for (const std::int64_t every : {run.plan.sample_every, run.plan.fields_every, run.plan.profile_every})
    if (every > 0) next = std::min(next, (now / every + 1) * every);
  return next - now;
}

/// Steps until the end, a stop from outside or the steady state. Returns how it ended, for the summary.
std::string advance_to_the_end(Run& run) {
  const auto piece = std::int64_t(std::max(1.0, cell_steps_between_looks * run.plan.threads / run.plan.cells()));
  while (run.step() < run.plan.steps) {
    advance(*run.fluid, run.plan, run.team, steps_to_go(run, piece));
    observe(run);
    if (run.progress.due()) show_progress(run);
    if (steady(run)) return "steady";
    if (run.commit_clock.due()) commit(run);
    if (run.options.stop && *run.options.stop) return "interrupted";
  }
  return "finished";
}

/// At the end of a run that ends before its last step, what is written at the end only.
void observe_early_end(Run& run) {
  if (run.plan.fields_every == 0) write_fields(run, run.settled.output.fields, run.plan.fields_box);
  if (run.plan.profile_every == 0) run.averages.add(run.field, run.step());
}

double solid_fraction(const Run& run) {
  double solid = 0;
  for (const std::uint8_t s : run.setup.solid) solid += s;
  return solid / run.plan.cells();
}

ExitCode finish(Run& run) {
  const std::string status = advance_to_the_end(run);
  if (status == "steady" && run.step() < run.plan.steps) observe_early_end(run);
  commit(run);
  run.progress.finish();
  replace_file(run.results.path() / "summary.json",
               fluid_summary_json(run.settled, run.plan, run.step(), solid_fraction(run), run.columns, run.row,
                                  run.cost(), status));
  if (status == "interrupted") {
    spdlog::warn("stopped at time {:.4g}; continue with: stresslet restart {}", run.plan.time(run.step()),
                 run.results.path().string());
    return ExitCode::interrupted;
  }
  fmt::print("{}results in {}\n", fluid_summary_text(run.columns, run.row), run.results.path().string());
  return ExitCode::success;
}

ExitCode commit_and_finish(Run& run) {
  commit_before_running([&] { commit(run); });
  if (due(run.step(), run.plan.fields_every, run) &&
      !std::filesystem::exists(run.results.path() / fields_folder / field_file_name(run.step()))) {
    measure(run);
    write_fields(run, run.settled.output.fields, run.plan.fields_box);
  }
  return finish_or_explain(
      run.results, "fields of all cells (initial.file)", [&] { return finish(run); },
      [&] { return fmt::format("time {:.6g}", run.plan.time(run.committed_step)); });
}

/// The last sample and the history of the monitored columns.
void restore_series(Run& run, const ResultsReader& reader) {
  for (const Column& c : run.columns) {
    const std::vector<double> values = reader.series(c.name);
    if (values.empty())
      throw InputError(
          {run.results.path().string(), "the series is empty", "the results were damaged", "run the case again"});
    run.row.push_back(values.back());
  }
  run.kinetic_energy = reader.series("kinetic_energy");
  run.dissipation = reader.series("dissipation_from_gradients");
}

}  // namespace

ExitCode run_case(const FluidCase& settled, const RunOptions& options) {
  const FluidPlan plan = make_plan(settled);
  prepare_output_folder(options.output, options.force);
  fmt::print(stderr, "{}", options.quiet ? "" : plan_report(settled, plan) + "\n");
  Run run(settled, plan, options, start_folder(settled, plan, options, false));
  fill(*run.fluid, settled, plan, run.team);
  set_drive(*run.fluid, plan);
  observe(run);
  return commit_and_finish(run);
}

ExitCode restart_fluid_run(const std::vector<std::string>& overrides, const RunOptions& options) {
  const std::filesystem::path file = options.output / results_file_name;
  const ResultsReader reader(file);
  refuse_changed_physics(overrides, changeable_by_restart, "start a new run from its last fields with initial.file");
  InputDocument document = InputDocument::from_text(reader.resolved_input(), file.string());
  for (const std::string& assignment : overrides) document.override_key(assignment);
  fidelity_of(document);
  const FluidCase settled = read_fluid_case(std::move(document));
  const FluidPlan plan = make_plan(settled);
  const Checkpoint checkpoint = reader.checkpoint();
  const auto step = stored<std::int64_t>(checkpoint.scalars, "step");
  if (step >= plan.steps)
    throw InputError({options.output.string(),
                      fmt::format("the run has reached time {:.6g} of {:.6g}", plan.time(step), plan.time(plan.steps)),
                      "there is nothing left to do", "ask for more with --set run.end_time=..."});

  Run run(settled, plan, options, start_folder(settled, plan, options, true));
  restore_series(run, reader);
  run.averages.restore(reader);
  run.new_run = false;
  run.first_step = step;
  run.cost_before = {stored<double>(checkpoint.scalars, "wall_seconds"),
                     stored<double>(checkpoint.scalars, "cell_steps")};
  run.field_headers = field_headers(options.output, step);
  const std::vector<double> populations = read_populations(options.output, step);
  try {
    run.fluid->restore(run.team, populations, step);
  } catch (const std::invalid_argument& why) {
    throw InputError({file.string(), "the checkpoint does not fit the input", why.what(), "run the case again"});
  }
  run.fluid->set_shear_offset(stored<double>(checkpoint.scalars, "shear_offset"));
  set_drive(*run.fluid, plan);
  return commit_and_finish(run);
}

}  // namespace stresslet
