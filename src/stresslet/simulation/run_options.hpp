#pragma once
/// What the command line says about a run besides the case.
#include <atomic>
#include <filesystem>
#include <string>

namespace stresslet {

struct RunOptions {
  std::filesystem::path output;
  bool force = false;
  bool quiet = false;                       ///< no progress line
  std::string command_line;                 ///< for the provenance
  const std::atomic<bool>* stop = nullptr;  ///< set from outside to end the run with a checkpoint
};

}  // namespace stresslet
