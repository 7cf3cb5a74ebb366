#pragma once
/// One value of an input document and the place it came from.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stresslet {

struct InputValue {
  using List = std::vector<InputValue>;
  /// A TOML item that no key accepts; `kind` completes "found ..." ("a date", "a section").
  struct Other {
    std::string kind;
  };

  std::variant<bool, std::int64_t, double, std::string, List, Other> content;
  std::string where;             ///< "case.toml:12" or "--set key=value"
  std::filesystem::path folder;  ///< relative file names in this value start here
};

/// The value as TOML reads it; numbers have the fewest digits that give back the same double.
std::string toml_text(const InputValue& value);

/// "the number 0.5", "the text "half"", "a list of 3": completes "found ..." in messages, shortened if long.
std::string found_text(const InputValue& value);

/// `text` as a TOML basic string, quotes included.
std::string toml_quoted(std::string_view text);

/// At most `limit` bytes of `text`, with "..." where it was cut.
std::string shortened(std::string text, std::size_t limit = 60);

}  // namespace stresslet
