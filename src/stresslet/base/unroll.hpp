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

/// term(first) + ... + term(last - 1), summed as a balanced tree: shorter chains of dependent additions than one after
/// the other. `term` is called with integral constants; [first, last) must not be empty.
template <int first, int last, class Term>
[[gnu::always_inline]] constexpr auto tree_sum(Term&& term) {
  if constexpr (last - first == 1) {
    return term(std::integral_constant<int, first>{});
  } else {
    constexpr int middle = (first + last) / 2;
    auto sum = tree_sum<first, middle>(term);
    sum += tree_sum<middle, last>(term);
    return sum;
  }
}

}  // namespace stresslet
