#pragma once
/// A validation case: one folder beside this one, one function in it, one row in cases.cpp.
#include <string_view>

namespace stresslet::validation {

class Trial;

struct Case {
  std::string_view id;      ///< what the user types
  std::string_view folder;  ///< under validation/
  std::string_view title;
  void (*run)(Trial&);
};

}  // namespace stresslet::validation
