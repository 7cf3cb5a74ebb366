#include "stresslet/io/schema.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stresslet/io/nearest_word.hpp"

namespace stresslet {

namespace {

template <class T>
std::optional<std::vector<T>> read_list(const InputValue& value) {
  const auto* list = std::get_if<InputValue::List>(&value.content);
  if (!list) return std::nullopt;
  std::vector<T> items;
  for (const InputValue& entry : *list) {
    auto item = InputType<T>::read(entry);
    if (!item) return std::nullopt;
    items.push_back(std::move(*item));
  }
  return items;
}

template <class T>
InputValue write_list(const std::vector<T>& items) {
  InputValue::List list;
  for (const T& item : items) list.push_back(InputType<T>::write(item));
  return {std::move(list), {}, {}};
}

}  // namespace

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
  return read_list<double>(value);
}

InputValue InputType<std::vector<double>>::write(const std::vector<double>& value) { return write_list(value); }

std::optional<std::vector<std::string>> InputType<std::vector<std::string>>::read(const InputValue& value) {
  return read_list<std::string>(value);
}

InputValue InputType<std::vector<std::string>>::write(const std::vector<std::string>& value) {
  return write_list(value);
}

std::optional<std::vector<std::vector<double>>> InputType<std::vector<std::vector<double>>>::read(
    const InputValue& value) {
  return read_list<std::vector<double>>(value);
}

InputValue InputType<std::vector<std::vector<double>>>::write(const std::vector<std::vector<double>>& value) {
  return write_list(value);
}

std::optional<std::array<std::int64_t, 3>> InputType<std::array<std::int64_t, 3>>::read(const InputValue& value) {
  const auto numbers = read_list<std::int64_t>(value);
  if (!numbers || numbers->size() != 3) return std::nullopt;
  return std::array{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

InputValue InputType<std::array<std::int64_t, 3>>::write(const std::array<std::int64_t, 3>& value) {
  return write_list(std::vector<std::int64_t>(value.begin(), value.end()));
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
