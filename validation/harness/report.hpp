#pragma once
/// What a finished trial becomes: a table on the screen, validation.json, one CSV file a table of numbers.
#include <filesystem>
#include <string>

#include "stresslet/io/provenance.hpp"
#include "validation/harness/case.hpp"
#include "validation/harness/trial.hpp"

namespace stresslet::validation {

std::string table_text(const Case& what, const Trial& trial);

/// Keys: id, title, quick, verdict, seconds, parameters, rows {quantity, reference, source, value, error,
/// error_is "relative" | "absolute", tolerance [lowest, highest], verdict}, provenance.
std::string json_text(const Case& what, const Trial& trial, double seconds, const Provenance& provenance);

/// Writes validation.json and the tables into `folder`; what lies there already is replaced.
void write_results(const std::filesystem::path& folder, const Case& what, const Trial& trial, double seconds,
                   const Provenance& provenance);

}  // namespace stresslet::validation
