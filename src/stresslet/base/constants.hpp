#pragma once
#include <numbers>

namespace stresslet {
inline constexpr double pi = std::numbers::pi;
}
