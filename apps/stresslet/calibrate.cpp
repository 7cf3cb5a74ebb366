#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <memory>

#include "calibration_file.hpp"
#include "commands.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/weight_choice.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

using Json = nlohmann::ordered_json;

struct Spread {
  double sum_of_squares = 0, lowest = 0, highest = 0;
  int count = 0;
  void add(double error) {
    sum_of_squares += error * error;
    lowest = std::min(lowest, error);
    highest = std::max(highest, error);
    ++count;
  }
  double rms() const { return std::sqrt(sum_of_squares / count); }
};

std::vector<PairMeasurement> measure_all(const CalibrateArguments& a, const std::vector<CalibrationPoint>& points) {
  using Clock = std::chrono::steady_clock;
  ThreadTeam team(a.threads);
  const auto start = Clock::now();
  std::vector<PairMeasurement> measurements;
  for (const CalibrationPoint& point : points) {
    measurements.push_back(measure_pair(
        a.scheme, point.placement,
        {PairMotionKind::squeeze, PairMotionKind::slide, PairMotionKind::roll, PairMotionKind::spin}, team));
    if (a.quiet) continue;
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const double left = seconds / double(measurements.size()) * double(points.size() - measurements.size());
    fmt::print(stderr, "\r{} of {} pairs measured, about {:.0f} s left   ", measurements.size(), points.size(), left);
  }
  if (!a.quiet) fmt::print(stderr, "\n");
  return measurements;
}

Json vector_json(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

void calibrate(const CalibrateArguments& a) {
  const std::vector<CalibrationPoint> points = calibration_points(a.plan);
  const std::vector<PairMeasurement> measurements = measure_all(a, points);
  const SubgridRange range;
  const SubgridLengths lengths = fit_lengths(measurements, a.law, range);

  print_lengths(a, lengths);
  fmt::print("error in per cent, without -> with the correction\n{:<24}{:>6}", "direction", "gap");
  for (const char* name : pair_motion_names) fmt::print("{:>18}", name);
  fmt::print("\n");
  std::array<Spread, 4> spread;
  Json rows = Json::array();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto before = corrected_errors(measurements[k], a.law, {}, range);
    const auto after = corrected_errors(measurements[k], a.law, lengths, range);
    const PairPlacement& p = points[k].placement;
    fmt::print("{:<24}{:>6.3g}", points[k].direction, p.gap);
    Json row{{"direction", points[k].direction},
             {"gap", p.gap},
             {"e", vector_json(p.direction)},
             {"across", vector_json(p.across)},
             {"offset", vector_json(p.offset)}};
    for (std::size_t mode = 0; mode < 4; ++mode) {
      fmt::print("{:>9.1f} ->{:>6.1f}", 100 * before[mode], 100 * after[mode]);
      spread[mode].add(after[mode]);
      const Eigen::Index i = Eigen::Index(mode);
      row[pair_motion_names[mode]] = {{"measured", measurements[k].measured(i, i) / measurements[k].viscosity},
                                      {"exact", measurements[k].exact(i, i) / measurements[k].viscosity},
                                      {"error", after[mode]}};
    }
    fmt::print("\n");
    rows.push_back(std::move(row));
  }
  fmt::print("{:<30}", "root mean square");
  for (const Spread& s : spread) fmt::print("{:>18.1f}", 100 * s.rms());
  fmt::print("\n{:<30}", "lowest, highest");
  for (const Spread& s : spread) fmt::print("{:>18}", fmt::format("{:.1f} {:+.1f}", 100 * s.lowest, 100 * s.highest));
  fmt::print("\n");

  Json residual;
  for (std::size_t mode = 0; mode < 4; ++mode)
    residual[pair_motion_names[mode]] = {
        {"rms", spread[mode].rms()}, {"lowest", spread[mode].lowest}, {"highest", spread[mode].highest}};
  write_calibration(a, {{"plan",
                         {{"cells_across", a.plan.cells_across},
                          {"radius_ratio", a.plan.radius_ratio},
                          {"edge", a.plan.edge},
                          {"gaps", a.plan.gaps},
                          {"random_directions", a.plan.random_directions}}},
                        {"lengths", lengths_json(lengths)},
                        {"residual_errors", residual},
                        {"pairs", rows}});
}

}  // namespace

void add_calibrate(CLI::App& app, const std::string& command_line) {
  auto a = std::make_shared<CalibrateArguments>();
  a->command_line = command_line;
  CLI::App* command = app.add_subcommand(
      "calibrate",
      "Find the lengths of the sub-grid lubrication correction for a coupling scheme, against exact pairs");
  PairScheme& s = a->scheme;
  command->add_option("--operator", s.coupling_operator, "Coupling operator")
      ->check(CLI::IsMember(CouplingOperators::names()))
      ->capture_default_str();
  CLI::Option* weight =
      command
          ->add_option("--weight", s.weight,
                       "Solid weight; default: viscosity-scaled where the operator bears it, else noble-torczynski")
          ->check(CLI::IsMember(SolidWeights::names()));
  command->add_option("--solid-fraction", s.solid_fraction, "Solid fraction")
      ->check(CLI::IsMember(SolidFractionLaws::names()))
      ->capture_default_str();
  command->add_option("--collision", s.collision, "Collision")
      ->check(CLI::IsMember(CollisionLaws::names()))
      ->capture_default_str();
  command->add_option("--tau", s.relaxation_time, "Relaxation time")
      ->check(CLI::Range(0.51, 10.0))
      ->capture_default_str();
  command->add_option("--magic", s.magic_parameter, "Magic parameter of TRT")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--law", a->law, "Sub-grid law")
      ->check(CLI::IsMember(SubgridLaws::names()))
      ->capture_default_str();
  command->add_option("--cells-across", a->plan.cells_across, "Cells across the smaller sphere")
      ->check(CLI::Range(4.0, 60.0))
      ->capture_default_str();
  command->add_option("--radius-ratio", a->plan.radius_ratio, "Radius of the larger sphere over that of the smaller")
      ->check(CLI::Range(1.0, 4.0))
      ->capture_default_str();
  command->add_option("--gaps", a->plan.gaps, "Gaps in cells")->check(CLI::Range(0.01, 10.0));
  command->add_option("--random", a->plan.random_directions, "Random directions and places per gap")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  CLI::Option* edge = command
                          ->add_option("--edge", a->plan.edge,
                                       "Edge of the periodic cube in cells; default: five "
                                       "times the mean diameter")
                          ->check(CLI::Range(16, 400));
  command->add_option("--threads", a->threads, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  CLI::Option* wall =
      command->add_flag("--wall", a->wall, "Films between a sphere and a half-way wall instead of pairs");
  command->add_flag("--quick", a->quick, "Three gaps and no random directions");
  command->add_flag("--quiet", a->quiet, "No progress line");
  command->add_option("--output", a->output, "JSON file with lengths, residual errors and all measured pairs")
      ->capture_default_str();
  for (const char* of_pairs : {"--radius-ratio", "--gaps", "--random", "--edge", "--quick"})
    wall->excludes(command->get_option(of_pairs));
  command->callback([a, edge, weight] {
    PairScheme& scheme = a->scheme;
    if (weight->count() == 0) scheme.weight = default_weight(scheme.coupling_operator);
    require_borne(scheme.coupling_operator, scheme.weight, "--weight", "take --weight noble-torczynski or linear");
    if (edge->count() == 0) a->plan.edge = int(std::ceil(5 * a->plan.cells_across * 0.5 * (1 + a->plan.radius_ratio)));
    if (a->quick) {
      a->plan.gaps = {0.05, 0.3, 1};
      a->plan.random_directions = 0;
    }
    a->wall ? calibrate_wall(*a) : calibrate(*a);
  });
}

}  // namespace stresslet
