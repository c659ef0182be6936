// How much larger than stated an occluder's box is taken to be. Boxes come from 32-bit floats, and surfaces may lie on
// their faces.
#pragma once

namespace tyndall {

inline constexpr double boxMargin = 1e-5;  ///< metres
inline constexpr double boxShare = 1e-6;   ///< share of the box's size

}  // namespace tyndall
