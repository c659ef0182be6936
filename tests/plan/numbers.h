/// The numbers that are no measure.
#pragma once

#include <limits>

namespace tyndall::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace tyndall::test
