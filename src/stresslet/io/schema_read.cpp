#include "stresslet/io/schema_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stresslet/io/nearest_word.hpp"

namespace stresslet {
namespace {

/// "suspension.sizes" and "law" of "suspension.sizes.law".
std::pair<std::string, std::string> split_path(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return {"", path};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

std::vector<std::string> keys_of_section(const std::string& section, const std::vector<std::string>& known) {
  std::vector<std::string> keys;
  for (const std::string& path : known)
    if (auto [owner, key] = split_path(path); owner == section) keys.push_back(key);
  return keys;
}

std::vector<std::string> sections_of(const std::vector<std::string>& known) {
  std::vector<std::string> sections;
  for (const std::string& path : known) {
    const std::string section = split_path(path).first;
    if (!section.empty() && std::find(sections.begin(), sections.end(), section) == sections.end())
      sections.push_back(section);
  }
  return sections;
}

std::string with_unit(std::string_view unit) {
  return unit.empty() || unit == "1" ? "" : fmt::format(" (unit: {})", unit);
}

void check_number(double number, const InputValue& value, const KeyInfo& key) {
  if (!std::isfinite(number))
    throw InputError({value.where, fmt::format("{} is not a finite number", key.path),
                      fmt::format("found {}; NaN and infinity are no input", found_text(value)),
                      fmt::format("give a number {}{}: {}", key.check.text(), with_unit(key.unit), key.doc)});
  if (!key.check.holds(number))
    throw InputError({value.where, fmt::format("{} is out of range", key.path),
                      fmt::format("found {}, but it must be {}", found_text(value), key.check.text()),
                      fmt::format("give a number {}{}: {}", key.check.text(), with_unit(key.unit), key.doc)});
}

void check_word(const std::string& word, const InputValue& value, const KeyInfo& key) {
  const std::vector<std::string>& choices = key.check.choices;
  if (choices.empty() || std::find(choices.begin(), choices.end(), word) != choices.end()) return;
  const auto nearest = nearest_word(word, choices);
  throw InputError({value.where, fmt::format("{} knows no {}", key.path, shortened(toml_quoted(word))),
                    "known: " + comma_separated(choices),
                    nearest ? fmt::format("did you mean {}?", toml_quoted(*nearest)) : "give one of the known words"});
}

Complaint unknown_section(const InputDocument& document, const std::string& path,
                          const std::vector<std::string>& known) {
  const std::vector<std::string> sections = sections_of(known);
  const auto [owner, name] = split_path(path);
  Complaint complaint{document.where(path), fmt::format("unknown section [{}]", shortened(path)),
                      "known sections: " + comma_separated(sections), "remove it, or correct its name"};
  if (std::find(known.begin(), known.end(), path) != known.end())
    complaint.fix = fmt::format("{} is a key: write {} = ... in [{}]", path, name, owner);
  else if (const auto nearest = nearest_word(path, sections))
    complaint.fix = fmt::format("did you mean [{}]?", *nearest);
  return complaint;
}

Complaint unknown_key(const InputDocument& document, const std::string& path, const std::vector<std::string>& known) {
  const auto [section, name] = split_path(path);
  const std::vector<std::string> here = keys_of_section(section, known);
  Complaint complaint{document.where(path), fmt::format("unknown key {}", shortened(path)),
                      "a key that nothing reads is refused, since it would have no effect",
                      "remove it, or correct its name"};
  if (!here.empty() && !section.empty())
    complaint.fix = fmt::format("keys of [{}]: {}", section, comma_separated(here));

  const auto same_name = std::find_if(known.begin(), known.end(), [&name = name](const std::string& candidate) {
    return split_path(candidate).second == name;
  });
  if (same_name != known.end())
    complaint.fix = fmt::format("{} belongs to section [{}]: move it there", name, split_path(*same_name).first);
  else if (const auto nearest = nearest_word(name, here))
    complaint.fix = fmt::format("did you mean {}?", section.empty() ? *nearest : section + "." + *nearest);
  else if (const auto elsewhere = nearest_word(path, known))
    complaint.fix = fmt::format("did you mean {}?", *elsewhere);
  else if (section.empty())
    complaint.fix = "every key belongs to a section: " + comma_separated(sections_of(known));
  return complaint;
}

}  // namespace

void check_value(const InputValue& value, const KeyInfo& key) {
  if (const auto* list = std::get_if<InputValue::List>(&value.content)) {
    for (const InputValue& item : *list) check_value(item, key);
  } else if (const auto number = InputType<double>::read(value)) {
    check_number(*number, value, key);
  } else if (const auto* word = std::get_if<std::string>(&value.content)) {
    check_word(*word, value, key);
  }
}

void refuse_kind(const InputValue& value, const KeyInfo& key, std::string_view wanted) {
  const std::string range = key.check.text();
  throw InputError(
      {value.where, fmt::format("{} must be {}", key.path, wanted), "found " + found_text(value),
       fmt::format("give {}{}{}: {}", wanted, range.empty() ? "" : ", " + range, with_unit(key.unit), key.doc)});
}

void refuse_section(const InputValue& value, const std::string& path) {
  throw InputError({value.where, fmt::format("{} must be a section", path), "found " + found_text(value),
                    fmt::format("write [{}] on a line of its own and its keys below", path)});
}

Complaint missing_key(const InputDocument& document, const KeyInfo& key) {
  const auto [section, name] = split_path(key.path);
  const std::string range = key.check.text();
  return {
      document.where(key.path), fmt::format("{} is missing", key.path), fmt::format("it has no default: {}", key.doc),
      fmt::format("add {} = ... to [{}]{}{}", name, section, range.empty() ? "" : ", " + range, with_unit(key.unit))};
}

void refuse_unread(const InputDocument& document, const std::vector<std::string>& known) {
  const std::vector<std::string> unread = document.unread();
  if (unread.empty()) return;
  const std::string& first = unread.front();
  throw InputError(document.is_section(first) ? unknown_section(document, first, known)
                                              : unknown_key(document, first, known));
}

}  // namespace stresslet
