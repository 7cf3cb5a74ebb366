#pragma once
/// Comma-separated numbers with one header line. Written: series.csv, header cells "name[unit]". Read: size tables,
/// start configurations and what this writes; also with semicolons, tabs or blanks, '#' comments and CRLF line ends.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "stresslet/io/results_data.hpp"

namespace stresslet {

/// Header line, with the line end.
std::string csv_header(std::span<const Column> columns);
/// One line of numbers, exact on reading back, with the line end.
std::string csv_row(std::span<const double> values);

/// A table of finite numbers, column by column.
struct CsvTable {
  std::string file;
  std::vector<std::string> names, units;  ///< from header cells "name" or "name[unit]"
  std::vector<std::vector<double>> columns;
  std::vector<std::size_t> lines;  ///< line in the file of each row, for messages

  std::size_t rows() const { return lines.size(); }
  bool has(const std::string& name) const;
  /// InputError, listing the names there are, if `name` is not among them.
  const std::vector<double>& column(const std::string& name) const;
};

/// InputError with file:line if the header is missing or anything is not a finite number or a row has gaps.
CsvTable read_csv(const std::filesystem::path& file);

}  // namespace stresslet
