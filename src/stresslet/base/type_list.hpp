#pragma once
/// A list of law types. The list is the only registry: keywords, error messages, dispatch, conformance tests and
/// the documentation tables are all generated from it. A law has `static constexpr std::string_view name` and
/// `static constexpr std::string_view summary`.
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace stresslet {

template <class T>
struct TypeTag {
  using type = T;
};

template <class... Laws>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Laws);

  /// Calls `visit(TypeTag<Law>{})` for every law in order.
  template <class Visit>
  static constexpr void for_each(Visit&& visit) {
    (visit(TypeTag<Laws>{}), ...);
  }

  /// Calls `visit(TypeTag<Law>{})` for the law called `name`; false if no law has this name.
  template <class Visit>
  static constexpr bool dispatch(std::string_view name, Visit&& visit) {
    return ((Laws::name == name && (visit(TypeTag<Laws>{}), true)) || ...);
  }

  static std::vector<std::string> names() { return {std::string(Laws::name)...}; }

  static constexpr bool contains(std::string_view name) { return ((Laws::name == name) || ...); }
};

}  // namespace stresslet
