#pragma once
/// Reading a described struct from an input document: types, ranges, words, missing and unknown keys.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/io/input_document.hpp"
#include "stresslet/io/schema.hpp"

namespace stresslet {

/// Throws InputError where `value`, of the right kind, is not finite, out of range or none of the known words.
void check_value(const InputValue& value, const KeyInfo& key);

[[noreturn]] void refuse_kind(const InputValue& value, const KeyInfo& key, std::string_view wanted);
[[noreturn]] void refuse_section(const InputValue& value, const std::string& path);
Complaint missing_key(const InputDocument& document, const KeyInfo& key);

/// Throws InputError for the first key of the document that nobody read, naming the nearest of `known`.
void refuse_unread(const InputDocument& document, const std::vector<std::string>& known);

/// Collects the paths of all keys, optional sections included.
class KeyCollector : public SectionPath {
 public:
  template <class T>
  void key(std::string_view name, T&, Presence, const Check&, std::string_view, std::string_view) {
    keys.push_back(path_of(name));
  }
  template <class S>
  void section(std::string_view name, S&, std::string_view) {
    inside(name, [&] {
      if constexpr (IsOptional<S>::value)
        typename S::value_type().describe(*this);
      else
        S().describe(*this);
    });
  }

  std::vector<std::string> keys;
};

class SectionReader : public SectionPath {
 public:
  explicit SectionReader(InputDocument& document) : document_(document) {}

  template <class T>
  void key(std::string_view name, T& member, Presence presence, Check check, std::string_view unit,
           std::string_view doc) {
    if constexpr (IsOptional<T>::value) {
      using Value = typename T::value_type;
      const KeyInfo info{path_of(name), presence, completed<Value>(std::move(check)), unit, doc};
      member = read<Value>(info);
    } else {
      const KeyInfo info{path_of(name), presence, completed<T>(std::move(check)), unit, doc};
      if (auto value = read<T>(info)) member = std::move(*value);
    }
  }

  template <class S>
  void section(std::string_view name, S& member, std::string_view) {
    const std::string path = path_of(name);
    const InputValue* value = document_.look_up(path);
    if (value && !document_.is_section(path)) refuse_section(*value, path);
    inside(name, [&] {
      if constexpr (IsOptional<S>::value) {
        member.reset();
        if (value) member.emplace().describe(*this);
      } else {
        member.describe(*this);
      }
    });
  }

  /// The first required key that is not given: reported after unknown keys, since a misspelt key is both.
  const std::optional<Complaint>& missing() const { return missing_; }

 private:
  template <class T>
  std::optional<T> read(const KeyInfo& info) {
    const InputValue* found = document_.look_up(info.path);
    if (!found) {
      if (info.presence.is_required && !missing_) missing_ = missing_key(document_, info);
      return std::nullopt;
    }
    if (std::is_enum_v<T> && std::holds_alternative<std::string>(found->content)) check_value(*found, info);
    std::optional<T> value = InputType<T>::read(*found);
    if (!value) refuse_kind(*found, info, InputType<T>::name);
    check_value(*found, info);
    return value;
  }

  InputDocument& document_;
  std::optional<Complaint> missing_;
};

/// Reads `S` from the whole document, or throws InputError. `read_before` are keys that the caller has read.
template <class S>
S read_described(InputDocument& document, const std::vector<std::string>& read_before = {}) {
  S result;
  SectionReader reader(document);
  result.describe(reader);
  KeyCollector known;
  S().describe(known);
  known.keys.insert(known.keys.end(), read_before.begin(), read_before.end());
  refuse_unread(document, known.keys);
  if (reader.missing()) throw InputError(*reader.missing());
  return result;
}

}  // namespace stresslet
