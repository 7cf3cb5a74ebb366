#pragma once
/// The time series of a run: one row per sample, the same columns in results.h5 and series.csv, and the means drawn
/// from them.
#include <string>
#include <vector>

#include "stresslet/io/results_data.hpp"
#include "stresslet/rheology/stress.hpp"

namespace stresslet {

/// What a sample of a resolved fluid adds to the row.
struct FluidSample {
  double viscosity_through_plane = 0, stored_momentum = 0;  ///< sheared box or walls
  double lowest_density = 1, highest_density = 1;
  double kinetic_stresslet = 0;  ///< xy, the part of the stresslet that is no first moment of the force
  StressParts virtual_films;     ///< resolved/virtual_films.hpp
};
/// Which of these the series has.
enum class FluidColumns { none, resolved, resolved_and_sheared };

/// Columns in the order of `Series::add`.
std::vector<Column> series_columns(FluidColumns fluid);

/// All rows so far, by column; kept in memory for error bars, steady-state detection and the monitor.
class Series {
 public:
  explicit Series(FluidColumns fluid = FluidColumns::none);

  /// Appends a row made from a sample and returns it. `particles` counts them; relative viscosity from dissipation uses
  /// the energies of the row before.
  const std::vector<double>& add(double strain, const Sample& sample, double particles, double solver_iterations,
                                 const FluidSample& fluid = {});
  /// Appends a row read back from a file.
  void restore(const std::vector<double>& row);

  bool has(const std::string& column) const;
  std::size_t size() const { return columns_.front().size(); }
  const std::vector<double>& operator[](const std::string& column) const;
  /// Rows from the first whose strain is at least `strain` (minus round-off).
  std::size_t first_row_from(double strain) const;

 private:
  double last(const std::string& column) const;
  FluidColumns fluid_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
  std::vector<double> row_;
};

}  // namespace stresslet
