#pragma once
/// SIMD pack of doubles for law functions templated on the value type, and the few operations the standard pack
/// lacks. `Pack` is the widest register of the target; arrays of pairs are padded to multiples of `pack_width`.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <type_traits>
#include <utility>

namespace stresslet {

namespace stdx = std::experimental;

template <class T>
using PackOf = stdx::native_simd<T>;

using Pack = PackOf<double>;
inline constexpr std::size_t pack_width = Pack::size();

inline constexpr std::size_t padded(std::size_t n) { return (n + pack_width - 1) / pack_width * pack_width; }

/// Loads base[stride * index[k]] for every lane k.
inline Pack gather(const double* base, const std::int32_t* index, std::size_t stride = 1) {
  return Pack([&](auto k) { return base[stride * std::size_t(index[k])]; });
}

template <class T>
PackOf<T> load(const T* p) {
  return PackOf<T>(p, stdx::vector_aligned);
}
template <class T>
void store(T* p, const std::type_identity_t<PackOf<T>>& v) {
  v.copy_to(p, stdx::vector_aligned);
}
/// The same at any address.
template <class T>
PackOf<T> load_unaligned(const T* p) {
  return PackOf<T>(p, stdx::element_aligned);
}
template <class T>
void store_unaligned(T* p, const std::type_identity_t<PackOf<T>>& v) {
  v.copy_to(p, stdx::element_aligned);
}

namespace detail {

template <std::size_t block, std::size_t... k>
void swap_blocks(Pack& low, Pack& high, std::index_sequence<k...>) {
  typedef double Register __attribute__((vector_size(sizeof(Pack))));
  const Register a = std::bit_cast<Register>(low), b = std::bit_cast<Register>(high);
  low = std::bit_cast<Pack>(__builtin_shufflevector(a, b, int(k & block ? pack_width + k - block : k)...));
  high = std::bit_cast<Pack>(__builtin_shufflevector(a, b, int(k & block ? pack_width + k : k + block)...));
}

}  // namespace detail

/// rows[r][k] <-> rows[k][r] for `pack_width` packs: blocks of 1, 2, 4 ... lanes change places between pairs of rows.
template <std::size_t block = 1>
inline void transpose(Pack* rows) {
  if constexpr (block < pack_width) {
    for (std::size_t r = 0; r < pack_width; ++r)
      if (!(r & block)) detail::swap_blocks<block>(rows[r], rows[r + block], std::make_index_sequence<pack_width>());
    transpose<2 * block>(rows);
  }
}

/// Lane-wise choice: `mask ? a : b`; the scalar overload lets laws be written once.
template <class T, class Abi>
[[gnu::always_inline]] inline stdx::simd<T, Abi> select(const stdx::simd_mask<T, Abi>& mask,
                                                        const std::type_identity_t<stdx::simd<T, Abi>>& a,
                                                        const std::type_identity_t<stdx::simd<T, Abi>>& b) {
  stdx::simd<T, Abi> result = b;
  stdx::where(mask, result) = a;
  return result;
}
inline double select(bool mask, double a, double b) { return mask ? a : b; }

inline double natural_log(double x) { return std::log(x); }

/// Natural logarithm of positive normal numbers, relative error below 4e-16 away from 1 and absolute error below
/// 2e-16 near it: x = 2^k m with m in [1/sqrt 2, sqrt 2), log m = 2 artanh s, s = (m - 1)/(m + 1), odd series to s^21.
inline Pack natural_log(const Pack& x) {
  using Int = stdx::fixed_size_simd<int, pack_width>;
  Int exponent;
  Pack mantissa = stdx::frexp(x, &exponent);
  Pack k = stdx::static_simd_cast<Pack>(exponent);
  const auto low = mantissa < 0.70710678118654752440;
  stdx::where(low, mantissa) = mantissa + mantissa;
  stdx::where(low, k) = k - 1.0;
  const Pack s = (mantissa - 1.0) / (mantissa + 1.0);
  const Pack s2 = s * s;
  Pack series = 1.0 / 21.0;
  for (int n = 19; n >= 3; n -= 2) series = series * s2 + 1.0 / n;
  return k * 0.69314718055994530942 + 2.0 * (s + s * s2 * series);
}

}  // namespace stresslet
