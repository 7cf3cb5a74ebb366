#include "validation/harness/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/csv.hpp"

namespace stresslet::validation {

namespace {

constexpr const char* verdict(bool passes) { return passes ? "pass" : "FAIL"; }

std::string tolerance_text(const Tolerance& t) {
  if (t.lowest == -t.highest) return fmt::format("{:.2g}", t.highest);
  return fmt::format("{:+.2g} {:+.2g}", t.lowest, t.highest);
}

std::vector<std::string> cells_of(const Row& r) {
  return {r.quantity,
          fmt::format("{:.7g}", r.reference.value),
          fmt::format("{:.7g}", r.value),
          fmt::format("{:+.1e}{}", r.error(), r.tolerance.relative ? " rel" : ""),
          tolerance_text(r.tolerance),
          verdict(r.passes()),
          r.reference.source};
}

}  // namespace

std::string table_text(const Case& what, const Trial& trial) {
  std::vector<std::vector<std::string>> lines{
      {"quantity", "reference", "value", "error", "tolerance", "verdict", "source"}};
  for (const Row& r : trial.rows()) lines.push_back(cells_of(r));
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  std::string text = fmt::format("{} {}{}\n", what.id, what.title, trial.quick() ? " (quick)" : "");
  for (const auto& line : lines) {
    text += " ";
    for (std::size_t k = 0; k + 1 < line.size(); ++k) text += fmt::format(" {:<{}} ", line[k], widths[k]);
    text += " " + line.back() + "\n";
  }
  const auto failed = std::count_if(trial.rows().begin(), trial.rows().end(), [](const Row& r) { return !r.passes(); });
  return text + (trial.rows().empty() ? fmt::format("{}: FAIL, no rows\n", what.id)
                 : failed             ? fmt::format("{}: FAIL, {} of {} rows\n", what.id, failed, trial.rows().size())
                                      : fmt::format("{}: pass, {} rows\n", what.id, trial.rows().size()));
}

std::string json_text(const Case& what, const Trial& trial, double seconds, const Provenance& p) {
  nlohmann::ordered_json j;
  j["id"] = what.id;
  j["title"] = what.title;
  j["quick"] = trial.quick();
  j["verdict"] = trial.passes() ? "pass" : "fail";
  j["seconds"] = seconds;
  j["parameters"] = nlohmann::ordered_json::object();
  for (const auto& parameter : trial.parameters())
    std::visit([&](const auto& value) { j["parameters"][parameter.first] = value; }, parameter.second);
  j["rows"] = nlohmann::ordered_json::array();
  for (const Row& r : trial.rows())
    j["rows"].push_back({{"quantity", r.quantity},
                         {"reference", r.reference.value},
                         {"source", r.reference.source},
                         {"value", r.value},
                         {"error", r.error()},
                         {"error_is", r.tolerance.relative ? "relative" : "absolute"},
                         {"tolerance", {r.tolerance.lowest, r.tolerance.highest}},
                         {"verdict", r.passes() ? "pass" : "fail"}});
  j["provenance"] = {{"version", p.version},           {"commit", p.commit},           {"compiler", p.compiler},
                     {"build_type", p.build_type},     {"build_flags", p.build_flags}, {"date", p.date},
                     {"command_line", p.command_line}, {"threads", p.threads}};
  return j.dump(2) + "\n";
}

void write_results(const std::filesystem::path& folder, const Case& what, const Trial& trial, double seconds,
                   const Provenance& provenance) {
  for (const Table& t : trial.tables()) {
    std::string text = csv_header(t.columns);
    std::vector<double> line(t.columns.size());
    for (std::size_t k = 0; k < t.values.front().size(); ++k) {
      for (std::size_t c = 0; c < line.size(); ++c) line[c] = t.values[c][k];
      text += csv_row(line);
    }
    replace_file(folder / (t.name + ".csv"), text);
  }
  replace_file(folder / "validation.json", json_text(what, trial, seconds, provenance));
}

}  // namespace stresslet::validation
