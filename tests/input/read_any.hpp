#pragma once
/// Reads any bytes as an input, for the property tests and the fuzzer.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/simulation/any_case.hpp"

namespace stresslet {

/// `bytes` are a document, followed after the first 0xff (no byte of UTF-8) by overrides separated by 0xff. Returns 1
/// if they are a case and 0 if they are refused by an InputError. Anything else (another exception, a case that does
/// not survive writing and reading) is a defect: the exception passes, a changed case aborts.
inline int read_any(std::string_view bytes) {
  const auto cut = [&bytes] {
    const std::size_t end = bytes.find('\xff');
    const std::string_view part = bytes.substr(0, end);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    return part;
  };
  const std::string_view text = cut();
  std::vector<std::string> overrides;
  while (!bytes.empty()) overrides.emplace_back(cut());
  try {
    const AnyCase read = read_any_case_text(text, "input", overrides);
    const std::string resolved = resolved_toml(read);
    if (!(read_any_case_text(resolved, "resolved") == read)) {
      std::fprintf(stderr, "the case changes when written and read:\n%s", resolved.c_str());
      std::abort();
    }
    return 1;
  } catch (const InputError&) {
    return 0;
  }
}

}  // namespace stresslet
