#include "stresslet/io/schema_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stresslet {
namespace {

constexpr std::size_t text_width = 100;

std::string key_name(const DescribedKey& key) {
  const std::size_t dot = key.info.path.rfind('.');
  return dot == std::string::npos ? key.info.path : key.info.path.substr(dot + 1);
}

std::string range_and_unit(const DescribedKey& key) {
  std::string text = key.info.check.choices.empty() ? std::string(key.type) : key.info.check.text();
  if (key.info.check.choices.empty() && !key.info.check.text().empty()) text += ", " + key.info.check.text();
  if (!key.info.unit.empty() && key.info.unit != "1") text += fmt::format(", in {}", key.info.unit);
  return text;
}

std::string otherwise_text(const DescribedKey& key) {
  return key.info.presence.otherwise.empty() ? "not given" : std::string(key.info.presence.otherwise);
}

/// `text` as comment lines of bounded width.
std::string comment(std::string_view text) {
  std::string lines, line;
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    if (!line.empty() && line.size() + blank > text_width) {
      lines += fmt::format("#{}\n", line);
      line.clear();
    }
    line += fmt::format(" {}", text.substr(0, blank));
    text.remove_prefix(std::min(blank + 1, text.size()));
  }
  return lines + fmt::format("#{}\n", line);
}

/// Text safe inside a cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string default_cell(const DescribedKey& key) {
  if (key.info.presence.is_required) return "required";
  if (key.default_value) return fmt::format("`{}`", toml_text(*key.default_value));
  return otherwise_text(key);
}

bool stands_at_default(const DescribedKey& key) {
  if (!key.value) return true;
  return key.default_value && toml_text(*key.value) == toml_text(*key.default_value);
}

}  // namespace

void set_defaults(std::vector<DescribedSection>& sections, const std::vector<DescribedSection>& fresh) {
  for (std::size_t s = 0; s < sections.size(); ++s)
    for (std::size_t k = 0; k < sections[s].keys.size(); ++k)
      if (!sections[s].keys[k].info.presence.is_required) sections[s].keys[k].default_value = fresh[s].keys[k].value;
}

std::string resolved_text(const std::vector<DescribedSection>& sections) {
  std::string text;
  for (const DescribedSection& section : sections) {
    if (!text.empty()) text += '\n';
    if (!section.given) {
      text += fmt::format("# [{}] is not given\n", section.path);
      continue;
    }
    text += fmt::format("[{}]\n", section.path);
    for (const DescribedKey& key : section.keys) {
      if (key.value)
        text += fmt::format("{} = {}\n", key_name(key), toml_text(*key.value));
      else
        text += fmt::format("# {}: {}\n", key_name(key), otherwise_text(key));
    }
  }
  return text;
}

std::string template_text(const std::vector<DescribedSection>& sections) {
  std::string text;
  for (const DescribedSection& section : sections) {
    if (!text.empty()) text += '\n';
    text += comment(section.doc);
    text += fmt::format("{}[{}]\n", section.given ? "" : "# ", section.path);
    for (const DescribedKey& key : section.keys) {
      text += '\n' + comment(fmt::format("{} ({})", key.info.doc, range_and_unit(key)));
      const bool active = section.given && (key.info.presence.is_required || !stands_at_default(key));
      if (key.value && (active || !key.info.presence.is_required))
        text += fmt::format("{}{} = {}\n", active ? "" : "# ", key_name(key), toml_text(*key.value));
      else
        text += fmt::format("# {} =     # {}\n", key_name(key),
                            key.info.presence.is_required ? "required in this section" : otherwise_text(key));
    }
  }
  return text;
}

std::string markdown_text(const std::vector<DescribedSection>& sections) {
  std::string text;
  for (const DescribedSection& section : sections) {
    text += fmt::format("\n## [{}]\n\n{}{}\n\n", section.path, section.doc,
                        section.optional ? " This section is optional." : "");
    text += "| key | value | unit | default | meaning |\n|---|---|---|---|---|\n";
    for (const DescribedKey& key : section.keys) {
      DescribedKey without_unit = key;
      without_unit.info.unit = "";
      text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key_name(key), cell(range_and_unit(without_unit)),
                          cell(key.info.unit), cell(default_cell(key)), cell(key.info.doc));
    }
  }
  return text;
}

}  // namespace stresslet
