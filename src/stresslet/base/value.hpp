#pragma once
/// Constants in laws that are templated on the value type.

namespace stresslet {

/// `constant` as a float, double or SIMD pack of either.
template <class R>
R as(double constant) {
  if constexpr (requires { typename R::value_type; })
    return R(typename R::value_type(constant));
  else
    return R(constant);
}

}  // namespace stresslet
