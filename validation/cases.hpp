#pragma once
/// The list of validation cases: `stresslet validate list`, dispatch, messages and tests follow from it.
#include <span>

#include "validation/harness/case.hpp"

namespace stresslet::validation {

std::span<const Case> cases();

/// InputError, with the nearest known ID, if there is none called `id`.
const Case& case_called(std::string_view id);

}  // namespace stresslet::validation
