#pragma once
/// Loops that the compiler unrolls: the index is a type, so that tables of constants fold into the code.
#include <utility>

namespace stresslet {

/// Calls `body(std::integral_constant<int, k>{})` for k = 0 ... count-1.
template <int count, class Body>
[[gnu::always_inline]] constexpr void unroll(Body&& body) {
  [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
    (body(std::integral_constant<int, k>{}), ...);
  }
  (std::make_integer_sequence<int, count>{});
}

}  // namespace stresslet
