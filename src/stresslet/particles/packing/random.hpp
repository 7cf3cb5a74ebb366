#pragma once
/// Random numbers of the packing generator: PCG64 (O'Neill 2014), turned into doubles bit by bit, so that a seed
/// means the same on every machine and with every standard library.
#include <cstdint>
#include <pcg_random.hpp>

namespace stresslet {

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// Uniform in [0, 1): the upper 53 bits.
  double uniform() { return double(generator_() >> 11) * 0x1p-53; }

  /// Uniform in [-half_width, half_width).
  double symmetric(double half_width) { return half_width * (2 * uniform() - 1); }

 private:
  pcg64 generator_;
};

}  // namespace stresslet
