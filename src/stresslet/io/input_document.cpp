#include "stresslet/io/input_document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "stresslet/base/error.hpp"
#include "stresslet/io/number_text.hpp"

namespace stresslet {
namespace {

constexpr std::size_t most_parts_of_a_key = 8;
constexpr std::string_view blanks = " \t";  // around the parts of an assignment

std::string place(const std::string& name, const toml::source_position& position) {
  return position.line > 0 ? fmt::format("{}:{}", name, position.line) : name;
}

/// A key as it is written in a path: bare if TOML allows, else quoted.
std::string key_segment(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? std::string(key) : toml_quoted(key);
}

void refuse_excess(std::string_view text, const std::string& name) {
  if (text.size() > InputDocument::largest_size)
    throw InputError({name, "the input is larger than 1 MiB", "an input file holds some dozens of keys",
                      "give the path of a TOML input; long tables belong in a CSV file that it names"});
  const auto signs = std::count_if(text.begin(), text.end(), [](char c) { return c == '.' || c == '[' || c == '{'; });
  if (std::size_t(signs) > InputDocument::most_nesting_signs)
    throw InputError(
        {name, fmt::format("the input holds {} dots and opening brackets", signs),
         fmt::format("more than {} are refused, to bound how deep keys can nest", InputDocument::most_nesting_signs),
         "put long lists into a CSV file and name that file in the input"});
}

toml::table parsed(std::string_view text, const std::string& name) {
  refuse_excess(text, name);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw InputError({place(name, error.source().begin),
                      "this is not TOML: " + shortened(std::string(error.description()), 300),
                      fmt::format("reading stopped in column {}", error.source().begin.column),
                      "correct the line; a key is written as name = value, a text as \"text\", a list as [1, 2]"});
  }
}

std::vector<std::string> path_segments(std::string_view path) {
  std::vector<std::string> segments(1);
  for (const char c : path) {
    if (c == '.')
      segments.emplace_back();
    else
      segments.back() += c;
  }
  return segments;
}

/// The right-hand side of `--set key=value` as a document with the one key "value".
toml::table parsed_assignment(std::string_view value, const std::string& where) {
  if (value.find_first_of("\r\n") == std::string_view::npos) {
    try {
      toml::table table = parsed("value = " + std::string(value), where);
      if (table.size() == 1 && table.contains("value")) return table;
    } catch (const InputError&) {
      // Not TOML, hence a bare text.
    }
  }
  try {
    return toml::parse("value = " + toml_quoted(value));
  } catch (const toml::parse_error&) {
    throw InputError({"--set", "the value given to --set is not UTF-8 text", "all text in an input is UTF-8",
                      "write the value in UTF-8"});
  }
}

}  // namespace

/// Turns a TOML tree into entries with dotted keys.
struct InputDocument::Flattener {
  InputDocument& document;
  const std::filesystem::path& folder;
  std::string fixed_where{};  ///< place of every key, if not its own line

  std::string where(const toml::source_position& position) const {
    return fixed_where.empty() ? place(document.name_, position) : fixed_where;
  }

  InputValue value(const toml::node& node, const std::string& place_of_key) const {
    InputValue result{InputValue::Other{"a date or time"}, place_of_key, folder};
    if (const auto* boolean = node.as_boolean()) {
      result.content = boolean->get();
    } else if (const auto* integer = node.as_integer()) {
      result.content = integer->get();
    } else if (const auto* real = node.as_floating_point()) {
      result.content = real->get();
    } else if (const auto* text = node.as_string()) {
      result.content = text->get();
    } else if (const auto* array = node.as_array()) {
      InputValue::List list;
      for (const toml::node& item : *array) list.push_back(value(item, place_of_key));
      result.content = std::move(list);
    } else if (node.is_table()) {
      result.content = InputValue::Other{"a section"};
    }
    return result;
  }

  void add(const std::string& key, const toml::node& node, const toml::source_position& position) {
    const toml::table* table = node.as_table();
    // Document order comes from line and column, which TOML's sorted tables do not keep.
    const std::size_t order =
        fixed_where.empty() ? (std::size_t(position.line) << 20) + position.column : ++document.next_order_;
    document.entries_.insert_or_assign(
        key, Entry{value(node, where(position)), table ? Entry::Kind::section : Entry::Kind::key, false, order});
    if (table) add_all(*table, key + ".");
  }

  void add_all(const toml::table& table, const std::string& prefix) {
    for (auto&& [key, node] : table) add(prefix + key_segment(key.str()), node, key.source().begin);
  }
};

InputDocument InputDocument::from_text(std::string_view text, std::string name, const std::filesystem::path& folder) {
  InputDocument document;
  document.name_ = std::move(name);
  document.next_order_ = std::size_t(1) << 52;  // overrides come after every line
  const toml::table table = parsed(text, document.name_);
  Flattener{document, folder}.add_all(table, "");
  return document;
}

InputDocument InputDocument::from_file(const std::filesystem::path& path) {
  std::error_code error;
  const bool folder = std::filesystem::is_directory(path, error);
  std::ifstream file;
  if (!folder) file.open(path, std::ios::binary);
  if (!file.is_open())
    throw InputError({path.string(), folder ? "this is a folder" : "the input file cannot be opened",
                      folder ? "a run needs one input file" : "it does not exist or may not be read",
                      "give the path of a TOML file; `stresslet new` writes one to start from"});
  std::string text(largest_size + 1, '\0');
  file.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(file.gcount()));
  if (file.bad()) throw InputError({path.string(), "the input file cannot be read to its end", "", "check the disk"});
  return from_text(text, path.string(), std::filesystem::absolute(path, error).parent_path());
}

void InputDocument::override_key(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string where = "--set " + shortened(std::string(assignment));
  const std::vector<std::string> segments = path_segments(trimmed(assignment.substr(0, equals), blanks));
  const bool complete = std::none_of(segments.begin(), segments.end(), [](const auto& s) { return s.empty(); });
  if (equals == std::string_view::npos || !complete)
    throw InputError({where, "this is no assignment", "an override names a key with its section and gives a value",
                      "write, for instance, --set suspension.solid_fraction=0.5"});
  if (segments.size() > most_parts_of_a_key)
    throw InputError(
        {where, fmt::format("the key has {} parts", segments.size()), "no section nests that deep", "shorten the key"});

  std::string key;
  for (const std::string& segment : segments) {
    if (!key.empty()) {
      const auto parent = entries_.find(key);
      if (parent == entries_.end())
        entries_[key] = Entry{{InputValue::Other{"a section"}, where, {}}, Entry::Kind::section, false, ++next_order_};
      else if (parent->second.kind != Entry::Kind::section)
        throw InputError({where, fmt::format("{} is a value, not a section", key),
                          "given at " + parent->second.value.where, "drop what follows it in the key"});
      key += '.';
    }
    key += key_segment(segment);
  }
  remove(key);
  const std::string_view value = trimmed(assignment.substr(equals + 1), blanks);
  if (value.empty()) {
    entries_[key] = Entry{{InputValue::Other{"nothing"}, where, {}}, Entry::Kind::removed, false, ++next_order_};
    return;
  }
  const toml::table table = parsed_assignment(value, where);
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  Flattener{*this, here, where}.add(key, *table.get("value"), {});
}

void InputDocument::remove(const std::string& key) {
  entries_.erase(key);
  const std::string prefix = key + ".";
  for (auto entry = entries_.lower_bound(prefix); entry != entries_.end() && entry->first.starts_with(prefix);)
    entry = entries_.erase(entry);
}

const InputValue* InputDocument::look_up(const std::string& key) {
  const auto entry = entries_.find(key);
  if (entry == entries_.end()) return nullptr;
  entry->second.read = true;
  return entry->second.kind == Entry::Kind::removed ? nullptr : &entry->second.value;
}

bool InputDocument::is_section(const std::string& key) const {
  const auto entry = entries_.find(key);
  return entry != entries_.end() && entry->second.kind == Entry::Kind::section;
}

std::string InputDocument::where(std::string_view key) const {
  while (!key.empty()) {
    if (const auto entry = entries_.find(key); entry != entries_.end()) return entry->second.value.where;
    const std::size_t dot = key.rfind('.');
    key = key.substr(0, dot == std::string_view::npos ? 0 : dot);
  }
  return name_;
}

std::vector<std::string> InputDocument::unread() const {
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const auto& [key, entry] : entries_)
    if (!entry.read) found.emplace_back(entry.order, key);
  std::sort(found.begin(), found.end());
  std::vector<std::string> keys;
  for (auto& [order, key] : found) keys.push_back(std::move(key));
  return keys;
}

}  // namespace stresslet
