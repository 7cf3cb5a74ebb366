#include "stresslet/io/input_value.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stresslet {
namespace {

template <class... Visit>
struct Overloaded : Visit... {
  using Visit::operator()...;
};
template <class... Visit>
Overloaded(Visit...) -> Overloaded<Visit...>;

std::string real_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

std::string toml_quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string shortened(std::string text, std::size_t limit) {
  if (text.size() <= limit) return text;
  const auto continues_a_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  while (limit > 0 && continues_a_character(text[limit])) --limit;
  return text.substr(0, limit) + "...";
}

std::string toml_text(const InputValue& value) {
  return std::visit(Overloaded{
                        [](bool b) -> std::string { return b ? "true" : "false"; },
                        [](std::int64_t i) { return fmt::format("{}", i); },
                        [](double x) { return real_text(x); },
                        [](const std::string& text) { return toml_quoted(text); },
                        [](const InputValue::List& list) {
                          std::string text = "[";
                          for (const InputValue& item : list) text += (text.size() > 1 ? ", " : "") + toml_text(item);
                          return text + "]";
                        },
                        [](const InputValue::Other& other) { return other.kind; },
                    },
                    value.content);
}

std::string found_text(const InputValue& value) {
  const std::string text = shortened(toml_text(value));
  return std::visit(Overloaded{
                        [&](bool) { return text; },
                        [&](std::int64_t) { return "the number " + text; },
                        [&](double) { return "the number " + text; },
                        [&](const std::string&) { return "the text " + text; },
                        [&](const InputValue::List&) { return "the list " + text; },
                        [](const InputValue::Other& other) { return other.kind; },
                    },
                    value.content);
}

}  // namespace stresslet
