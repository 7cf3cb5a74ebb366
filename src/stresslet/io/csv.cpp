#include "stresslet/io/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/number_text.hpp"

namespace stresslet {
namespace {

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& problem,
                         const std::string& reason, const std::string& fix) {
  throw InputError({line ? fmt::format("{}:{}", file, line) : file, problem, reason, fix});
}

char separator_of(std::string_view header) {
  for (char candidate : {',', ';', '\t'})
    if (header.find(candidate) != std::string_view::npos) return candidate;
  return ' ';
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  if (separator == ' ') {
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) cells.push_back(word);
    return cells;
  }
  std::size_t end;
  do {
    end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end != std::string_view::npos) line.remove_prefix(end + 1);
  } while (end != std::string_view::npos);
  return cells;
}

void read_header(CsvTable& table, const std::vector<std::string_view>& cells, std::size_t line) {
  for (std::string_view cell : cells) {
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    if (number(cell))
      refuse(table.file, line, "the header line is missing", "the first line holds numbers, not names",
             "put a line with the column names on top, such as: x,y,z,radius");
    const std::size_t bracket = cell.find('[');
    const bool has_unit = bracket != std::string_view::npos && cell.back() == ']';
    const std::string name(trimmed(cell.substr(0, has_unit ? bracket : cell.size())));
    if (name.empty() || table.has(name))
      refuse(table.file, line, name.empty() ? "a column has no name" : "column '" + name + "' stands there twice",
             "columns are found by their names", "give every column a name of its own");
    table.names.push_back(name);
    table.units.emplace_back(has_unit ? cell.substr(bracket + 1, cell.size() - bracket - 2) : "");
  }
  table.columns.resize(table.names.size());
}

void read_row(CsvTable& table, const std::vector<std::string_view>& cells, std::size_t line) {
  if (cells.size() != table.names.size())
    refuse(table.file, line, fmt::format("{} values in this line", cells.size()),
           fmt::format("the header names {} columns", table.names.size()),
           "give one number per column, or correct the header");
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto value = number(cells[k]);
    if (!value)
      refuse(table.file, line, fmt::format("'{}' in column '{}'", cells[k], table.names[k]), "it is no finite number",
             "write numbers as 0.5 or 5e-1, with a decimal point");
    table.columns[k].push_back(*value);
  }
  table.lines.push_back(line);
}

}  // namespace

std::string csv_header(std::span<const Column> columns) {
  std::string line;
  for (const Column& column : columns)
    line += fmt::format("{}{}[{}]", line.empty() ? "" : ",", column.name, column.unit);
  return line + '\n';
}

std::string csv_row(std::span<const double> values) { return fmt::format("{}\n", fmt::join(values, ",")); }

bool CsvTable::has(const std::string& name) const { return std::find(names.begin(), names.end(), name) != names.end(); }

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    refuse(file, 0, "there is no column '" + name + "'", fmt::format("the columns are: {}", fmt::join(names, ", ")),
           "name the columns in the header line");
  return columns[std::size_t(found - names.begin())];
}

CsvTable read_csv(const std::filesystem::path& file) {
  const std::string text = read_whole_file(file);
  CsvTable table;
  table.file = file.string();
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  char separator = 0;
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    std::string_view line = take_line(rest);
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    if (separator) {
      read_row(table, cells_of(line, separator), line_number);
    } else {
      separator = separator_of(line);
      read_header(table, cells_of(line, separator), line_number);
    }
  }
  if (table.rows() == 0)
    refuse(table.file, 0, "the table holds no numbers", "a header line and at least one line of numbers are needed",
           "check that this is the right file");
  return table;
}

}  // namespace stresslet
