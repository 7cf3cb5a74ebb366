#include "stresslet/rheology/steady_state.hpp"

#include <limits>

namespace stresslet {

namespace {
constexpr std::size_t batch = 5;
constexpr std::size_t fewest_batches = 10;
}  // namespace

SteadyState find_steady_state(std::span<const double> series) {
  const std::size_t batches = series.size() / batch;
  if (batches < fewest_batches) return {};

  std::size_t best = 0;
  double smallest = std::numeric_limits<double>::infinity();
  double mean = 0, squares = 0;  // of the batches from d on, updated backwards (Welford 1962)
  for (std::size_t d = batches; d-- > 0;) {
    double value = 0;
    for (std::size_t k = 0; k < batch; ++k) value += series[d * batch + k] / double(batch);
    const double kept = double(batches - d);
    const double deviation = value - mean;
    mean += deviation / kept;
    squares += deviation * (value - mean);
    if (2 * d > batches) continue;
    const double rule = squares / (kept * kept);
    if (rule <= smallest) smallest = rule, best = d;
  }
  return {best * batch, best < batches / 2};
}

}  // namespace stresslet
