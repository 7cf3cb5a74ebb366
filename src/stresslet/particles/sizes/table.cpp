#include "stresslet/particles/sizes/table.hpp"

#include "stresslet/particles/sizes/checks.hpp"

namespace stresslet {

namespace {

/// Number of particles in row k, up to a factor common to all rows.
double number_of_row(const Table::Params& p, std::size_t k) {
  if (p.basis == Table::Basis::number) return p.shares[k];
  const double b = p.diameters[k], a = k == 0 ? b : p.diameters[k - 1];
  return p.shares[k] * (a + b) / (2 * a * a * b * b);
}

/// Diameter below which the part `u` of row k's particles lies.
double quantile_of_row(const Table::Params& p, std::size_t k, double u) {
  const double b = p.diameters[k], a = k == 0 ? b : p.diameters[k - 1];
  if (p.basis == Table::Basis::number) return a + u * (b - a);
  return 1 / std::sqrt(1 / (a * a) - u * (1 / (a * a) - 1 / (b * b)));
}

}  // namespace

void Table::validate(const Params& p) {
  if (p.diameters.empty())
    throw InputError({"", "an empty size table", "a size distribution needs at least one row", "add rows"});
  for (const double d : p.diameters) require_positive(d, "diameter");
  for (std::size_t k = 1; k < p.diameters.size(); ++k)
    if (!(p.diameters[k] > p.diameters[k - 1]))
      throw InputError({"",
                        "row " + std::to_string(k + 1) + " of the size table has diameter " +
                            std::to_string(p.diameters[k]) + " after " + std::to_string(p.diameters[k - 1]),
                        "the cumulative distribution needs ascending diameters", "sort the rows by diameter"});
  require_shares(p.shares, p.diameters.size(), "shares");
}

std::vector<SizeClassed> Table::sizes(const Params& p, std::size_t count) {
  validate(p);
  std::vector<double> cumulative;
  double total = 0;
  for (std::size_t k = 0; k < p.diameters.size(); ++k) cumulative.push_back(total += number_of_row(p, k));

  std::vector<SizeClassed> sizes;
  sizes.reserve(count);
  std::size_t row = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double target = total * (double(i) + 0.5) / double(count);
    while (row + 1 < cumulative.size() && cumulative[row] < target) ++row;
    const double number = number_of_row(p, row);
    const double u = (target - (cumulative[row] - number)) / number;
    sizes.push_back({quantile_of_row(p, row, std::fmin(std::fmax(u, 0), 1)), std::int32_t(row)});
  }
  return sizes;
}

}  // namespace stresslet
