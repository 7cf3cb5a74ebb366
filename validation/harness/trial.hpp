#pragma once
/// One run of a case: what the case may use, and where it puts what it finds.
#include <fmt/format.h>

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stresslet/exec/thread_team.hpp"
#include "stresslet/io/results_data.hpp"
#include "stresslet/simulation/progress.hpp"
#include "validation/harness/row.hpp"

namespace stresslet::validation {

/// Numbers behind a figure; becomes NAME.csv.
struct Table {
  std::string name;
  std::vector<Column> columns;
  std::vector<std::vector<double>> values;  ///< column by column
};

using ParameterValue = std::variant<double, std::string>;

class Trial {
 public:
  Trial(bool quick, int threads, bool quiet) : quick_(quick), team_(threads), progress_(quiet) {}

  /// Whether the case shall run its smaller version, with tolerances of its own.
  bool quick() const { return quick_; }
  template <class T>
  T choose(T full, T quick) const {
    return quick_ ? quick : full;
  }

  ThreadTeam& team() { return team_; }
  Progress& progress() { return progress_; }

  void parameter(std::string name, ParameterValue value) {
    parameters_.emplace_back(std::move(name), std::move(value));
  }
  void row(std::string quantity, double value, Reference reference, Tolerance tolerance) {
    rows_.push_back({std::move(quantity), std::move(reference), value, tolerance});
  }
  /// Orders of convergence between successive grids, each judged: one row a pair. `sizes` in cells, ascending.
  void order_rows(const std::string& of, std::span<const int> sizes, std::span<const double> errors, double expected,
                  double lowest, double highest);
  void table(Table table) { tables_.push_back(std::move(table)); }

  const std::vector<Row>& rows() const { return rows_; }
  const std::vector<std::pair<std::string, ParameterValue>>& parameters() const { return parameters_; }
  const std::vector<Table>& tables() const { return tables_; }
  /// Whether there are rows and all pass.
  bool passes() const;

 private:
  bool quick_;
  ThreadTeam team_;
  Progress progress_;
  std::vector<Row> rows_;
  std::vector<std::pair<std::string, ParameterValue>> parameters_;
  std::vector<Table> tables_;
};

}  // namespace stresslet::validation
