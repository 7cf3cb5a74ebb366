#include "stresslet/io/schema.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stresslet/io/nearest_word.hpp"

namespace stresslet {

bool Check::holds(double value) const {
  return (lower_excluded ? value > lower : value >= lower) && (upper_excluded ? value < upper : value <= upper);
}

std::string Check::text() const {
  if (!choices.empty()) {
    std::string words;
    for (const std::string& choice : choices) words += (words.empty() ? "" : ", ") + toml_quoted(choice);
    return "one of " + words;
  }
  std::string bounds;
  if (std::isfinite(lower)) bounds = fmt::format("{} {}", lower_excluded ? ">" : ">=", lower);
  if (std::isfinite(upper))
    bounds += fmt::format("{}{} {}", bounds.empty() ? "" : " and ", upper_excluded ? "<" : "<=", upper);
  return bounds;
}

std::optional<bool> InputType<bool>::read(const InputValue& value) {
  const bool* content = std::get_if<bool>(&value.content);
  return content ? std::optional(*content) : std::nullopt;
}

std::optional<std::int64_t> InputType<std::int64_t>::read(const InputValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) return *integer;
  // 1e4 is a whole number to everybody but TOML.
  constexpr double exact_below = 9007199254740992.0;
  if (const auto* real = std::get_if<double>(&value.content))
    if (std::abs(*real) < exact_below && *real == std::trunc(*real)) return std::int64_t(*real);
  return std::nullopt;
}

std::optional<double> InputType<double>::read(const InputValue& value) {
  if (const auto* real = std::get_if<double>(&value.content)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) return double(*integer);
  return std::nullopt;
}

std::optional<std::string> InputType<std::string>::read(const InputValue& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  return text ? std::optional(*text) : std::nullopt;
}

std::optional<InputPath> InputType<InputPath>::read(const InputValue& value) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (!text || text->empty()) return std::nullopt;
  return InputPath{(value.folder / *text).lexically_normal().string()};
}

std::optional<std::vector<double>> InputType<std::vector<double>>::read(const InputValue& value) {
  const auto* list = std::get_if<InputValue::List>(&value.content);
  if (!list) return std::nullopt;
  std::vector<double> numbers;
  for (const InputValue& item : *list) {
    const auto number = InputType<double>::read(item);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

InputValue InputType<std::vector<double>>::write(const std::vector<double>& value) {
  InputValue::List list;
  for (const double number : value) list.push_back({number, {}, {}});
  return {std::move(list), {}, {}};
}

std::optional<Vec3<double>> InputType<Vec3<double>>::read(const InputValue& value) {
  const auto numbers = InputType<std::vector<double>>::read(value);
  if (!numbers || numbers->size() != 3) return std::nullopt;
  return Vec3<double>{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

InputValue InputType<Vec3<double>>::write(const Vec3<double>& value) {
  return InputType<std::vector<double>>::write({value.x, value.y, value.z});
}

}  // namespace stresslet
