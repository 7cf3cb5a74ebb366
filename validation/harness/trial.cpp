#include "validation/harness/trial.hpp"

#include <algorithm>

#include "validation/harness/convergence.hpp"

namespace stresslet::validation {

void Trial::order_rows(const std::string& of, std::span<const int> sizes, std::span<const double> errors,
                       double expected, double lowest, double highest) {
  for (std::size_t k = 1; k < sizes.size(); ++k)
    row(fmt::format("order of {}, {} to {} cells", of, sizes[k - 1], sizes[k]),
        observed_order(sizes[k - 1], errors[k - 1], sizes[k], errors[k]), {expected, "scheme"},
        {false, lowest - expected, highest - expected});
}

bool Trial::passes() const {
  return !rows_.empty() && std::all_of(rows_.begin(), rows_.end(), [](const Row& r) { return r.passes(); });
}

}  // namespace stresslet::validation
