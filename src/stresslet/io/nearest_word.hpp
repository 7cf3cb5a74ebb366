#pragma once
/// The known word that was probably meant.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stresslet {

/// Edits (insert, delete, replace, swap of neighbours) that turn `a` into `b`: the optimal string alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `known` with the fewest edits from `word`, of equals the longest; none if more than a third of the
/// letters (and more than two) would have to change.
std::optional<std::string> nearest_word(std::string_view word, const std::vector<std::string>& known);

/// "a, b, c".
std::string comma_separated(const std::vector<std::string>& words);

}  // namespace stresslet
