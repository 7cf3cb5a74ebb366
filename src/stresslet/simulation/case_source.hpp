#pragma once
/// Where the keys of a case came from.
#include "stresslet/io/input_document.hpp"

namespace stresslet {

/// For messages about values that only later prove impossible. No part of what a case says: all sources compare equal.
struct CaseSource {
  InputDocument document;
  friend bool operator==(const CaseSource&, const CaseSource&) { return true; }
};

}  // namespace stresslet
