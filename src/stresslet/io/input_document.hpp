#pragma once
/// An input document: TOML text plus `--set` overrides, every key with the place it came from.
///
/// Keys are dotted paths ("suspension.sizes.law"). Looking a key up marks it as read; what nobody read is unknown
/// (`unread`). Any bytes may be given: what is not TOML throws InputError with file and line.
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stresslet/io/input_value.hpp"

namespace stresslet {

class InputDocument {
 public:
  /// Longest text and largest number of dots and opening brackets in it. Input files stay far below both; the second
  /// bounds how deep keys can nest.
  static constexpr std::size_t largest_size = std::size_t(1) << 20;
  static constexpr std::size_t most_nesting_signs = 4000;

  /// `name` stands in messages for the document; relative file names in it start from `folder`.
  static InputDocument from_text(std::string_view text, std::string name, const std::filesystem::path& folder = {});
  static InputDocument from_file(const std::filesystem::path& path);

  /// Applies "key=value". The value is TOML, or a bare text where it is none; an empty value removes the key.
  void override_key(std::string_view assignment);

  /// The value of a key or section, or null where it is not given or was removed. Marks it as read. The value of a
  /// section is of kind Other.
  const InputValue* look_up(const std::string& key);
  bool is_section(const std::string& key) const;

  /// Place of a key; where it is not given, of the nearest section around it; else the document's name.
  std::string where(std::string_view key) const;

  /// Keys and sections never looked up, in the order in which they stand in the document.
  std::vector<std::string> unread() const;

  const std::string& name() const { return name_; }

 private:
  struct Entry {
    enum class Kind { key, section, removed };
    InputValue value;
    Kind kind = Kind::key;
    bool read = false;
    std::size_t order = 0;
  };
  struct Flattener;

  void remove(const std::string& key);

  std::string name_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::size_t next_order_ = 0;
};

}  // namespace stresslet
