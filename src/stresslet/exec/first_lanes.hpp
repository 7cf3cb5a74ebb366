#pragma once
/// A pack of which only the first `count` lanes lie in an array; memory of the others is not touched.
#include <cstddef>

#include "stresslet/base/value.hpp"
#include "stresslet/exec/simd.hpp"

namespace stresslet {

template <class R>
[[gnu::always_inline]] inline auto first_lanes(std::ptrdiff_t count) {
  return R([](auto k) { return typename R::value_type(k); }) < as<R>(double(count));
}

/// Zero in the other lanes.
template <class R, class T>
[[gnu::always_inline]] inline R load_first(const T* from, std::ptrdiff_t count) {
  R values = as<R>(0);
  stdx::where(first_lanes<R>(count), values).copy_from(from, stdx::element_aligned);
  return values;
}
template <class R, class T>
[[gnu::always_inline]] inline void store_first(T* to, const R& values, std::ptrdiff_t count) {
  stdx::where(first_lanes<R>(count), values).copy_to(to, stdx::element_aligned);
}

}  // namespace stresslet
