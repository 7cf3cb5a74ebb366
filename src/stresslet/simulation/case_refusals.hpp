#pragma once
/// Refusals that the rules of every kind of case share. A case `C` knows the place of its keys: `where(key)`.
#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "stresslet/base/error.hpp"

namespace stresslet {

[[noreturn]] inline void refuse(const std::string& where, const std::string& problem, const std::string& reason,
                                const std::string& fix) {
  throw InputError({where, problem, reason, fix});
}

/// A key and whether it is given.
struct Given {
  std::string_view key;
  bool given;
};

template <class C>
[[noreturn]] void refuse_both(const C& read, std::string_view first, std::string_view second, std::string_view reason) {
  refuse(read.where(second), fmt::format("both {} and {} are given", first, second),
         fmt::format("{}; {} is given at {}", reason, first, read.where(first)),
         fmt::format("remove one of them, or override with --set {}=", first));
}

template <class C>
void refuse_any_with(const C& read, std::string_view owner, std::initializer_list<Given> others,
                     std::string_view reason) {
  for (const Given& other : others)
    if (other.given) refuse_both(read, owner, other.key, reason);
}

}  // namespace stresslet
