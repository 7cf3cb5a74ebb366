#pragma once
/// The input reference, generated from the descriptions of the input sections.
#include <string>

namespace stresslet {

/// docs/input-reference.md.
std::string input_reference_markdown();

}  // namespace stresslet
