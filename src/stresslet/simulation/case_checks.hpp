#pragma once
/// Rules that tie several keys of the input together. What one key may be on its own stands in its description.

namespace stresslet {

struct Case;

/// Throws InputError for the first rule that the case as read, not yet settled, breaks.
void check_case(const Case& read);

}  // namespace stresslet
