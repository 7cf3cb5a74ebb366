#pragma once
/// What a run-time check says when it stops a run.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "stresslet/base/error.hpp"

namespace stresslet::testing {

/// The message of the NumericalFailure that `action` throws, or nothing.
inline std::string failure_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const NumericalFailure& failure) {
    EXPECT_EQ(failure.code(), ExitCode::numerical);
    return failure.what();
  }
  return "";
}

}  // namespace stresslet::testing
