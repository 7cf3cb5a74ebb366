#pragma once
/// The words in which a section of the input describes its keys. A section is a plain struct with
///
///     template <class V>
///     void describe(V& v) {
///       v.key("friction", friction, defaulted, at_least(0), "1", "Coulomb coefficient of friction");
///       v.section("sizes", sizes, "Size distribution");       // nested struct, or std::optional of one
///     }
///
/// and everything else is a visitor: reading (`schema_read.hpp`), resolved input and template (`schema_text.hpp`), the
/// list of known keys and the reference. A default is the value the member has in a freshly made struct. Members may be
/// bool, integers, double, std::string, InputPath, enums with `Keywords`, Vec3<double>, lists, and std::optional of
/// these for keys that have no default of their own.
#include <array>
#include <concepts>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "stresslet/base/vec3.hpp"
#include "stresslet/io/input_value.hpp"

namespace stresslet {

/// What happens where a key is not given.
struct Presence {
  bool is_required = false;
  std::string_view otherwise{};  ///< shown in place of a default value
};
inline constexpr Presence required{true, {}};
inline constexpr Presence defaulted{};
constexpr Presence otherwise(std::string_view text) { return {false, text}; }

/// The values a key accepts: an interval, or one of a list of words. Applies to each element of a list.
struct Check {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_excluded = false;
  bool upper_excluded = false;
  std::vector<std::string> choices{};

  bool holds(double value) const;
  /// "> 0 and <= 1", "one of "a", "b""; empty where everything is accepted.
  std::string text() const;
};
inline Check anything() { return {}; }
inline Check at_least(double lower) { return {.lower = lower}; }
inline Check above(double lower) { return {.lower = lower, .lower_excluded = true}; }
inline Check between(double lower, double upper) { return {.lower = lower, .upper = upper}; }
/// lower < value < upper
inline Check strictly_between(double lower, double upper) {
  return {.lower = lower, .upper = upper, .lower_excluded = true, .upper_excluded = true};
}
/// lower < value <= upper
inline Check above_up_to(double lower, double upper) {
  return {.lower = lower, .upper = upper, .lower_excluded = true};
}
inline Check one_of(std::vector<std::string> choices) { return {.choices = std::move(choices)}; }

/// The name of a file. A relative name is made absolute when read: from the folder of the input, or from the working
/// directory for an override.
struct InputPath {
  std::string text;
  friend bool operator==(const InputPath&, const InputPath&) = default;
};

/// Names of an enum's values: specialise with `static constexpr std::array<std::pair<std::string_view, E>, n> names`.
template <class E>
struct Keywords;

template <class E>
std::string_view keyword(E value) {
  for (const auto& [name, candidate] : Keywords<E>::names)
    if (candidate == value) return name;
  return "?";
}

/// What a visitor is told about a key besides its member.
struct KeyInfo {
  std::string path;
  Presence presence;
  Check check;
  std::string_view unit;  ///< "" for texts and switches
  std::string_view doc;
};

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// Conversion of one member type. `name` completes "must be ..." and heads the type column of the reference.
/// `read` returns nothing where the kind of value is wrong.
template <class T>
struct InputType;

template <>
struct InputType<bool> {
  static constexpr std::string_view name = "true or false";
  static std::optional<bool> read(const InputValue& value);
  static InputValue write(bool value) { return {value, {}, {}}; }
};

template <>
struct InputType<std::int64_t> {
  static constexpr std::string_view name = "a whole number";
  static std::optional<std::int64_t> read(const InputValue& value);
  static InputValue write(std::int64_t value) { return {value, {}, {}}; }
};

template <>
struct InputType<double> {
  static constexpr std::string_view name = "a number";
  static std::optional<double> read(const InputValue& value);
  static InputValue write(double value) { return {value, {}, {}}; }
};

template <>
struct InputType<std::string> {
  static constexpr std::string_view name = "a text";
  static std::optional<std::string> read(const InputValue& value);
  static InputValue write(const std::string& value) { return {value, {}, {}}; }
};

template <>
struct InputType<InputPath> {
  static constexpr std::string_view name = "the name of a file";
  static std::optional<InputPath> read(const InputValue& value);
  static InputValue write(const InputPath& value) { return {value.text, {}, {}}; }
};

template <>
struct InputType<std::vector<double>> {
  static constexpr std::string_view name = "a list of numbers";
  static std::optional<std::vector<double>> read(const InputValue& value);
  static InputValue write(const std::vector<double>& value);
};

template <>
struct InputType<Vec3<double>> {
  static constexpr std::string_view name = "a list of three numbers";
  static std::optional<Vec3<double>> read(const InputValue& value);
  static InputValue write(const Vec3<double>& value);
};

template <>
struct InputType<std::array<std::int64_t, 3>> {
  static constexpr std::string_view name = "a list of three whole numbers";
  static std::optional<std::array<std::int64_t, 3>> read(const InputValue& value);
  static InputValue write(const std::array<std::int64_t, 3>& value);
};

template <>
struct InputType<std::vector<std::string>> {
  static constexpr std::string_view name = "a list of texts";
  static std::optional<std::vector<std::string>> read(const InputValue& value);
  static InputValue write(const std::vector<std::string>& value);
};

/// Rows of numbers, such as one point or one sphere each.
template <>
struct InputType<std::vector<std::vector<double>>> {
  static constexpr std::string_view name = "a list of lists of numbers";
  static std::optional<std::vector<std::vector<double>>> read(const InputValue& value);
  static InputValue write(const std::vector<std::vector<double>>& value);
};

template <class E>
requires std::is_enum_v<E>
struct InputType<E> {
  static constexpr std::string_view name = "a text";
  static std::optional<E> read(const InputValue& value) {
    const auto* text = std::get_if<std::string>(&value.content);
    for (const auto& [keyword, candidate] : Keywords<E>::names)
      if (text && *text == keyword) return candidate;
    return std::nullopt;
  }
  static InputValue write(E value) { return {std::string(keyword(value)), {}, {}}; }
};

/// The check of a key with the names of an enum filled in.
template <class T>
Check completed(Check check) {
  if constexpr (std::is_enum_v<T>)
    for (const auto& [name, value] : Keywords<T>::names) check.choices.emplace_back(name);
  return check;
}

/// Base of visitors: keeps the path of the section being described.
class SectionPath {
 public:
  std::string path_of(std::string_view name) const {
    return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
  }

 protected:
  template <class Body>
  void inside(std::string_view name, Body&& body) {
    const std::string outer = std::exchange(path_, path_of(name));
    body();
    path_ = outer;
  }

 private:
  std::string path_;
};

}  // namespace stresslet
