// The published constants: Jason L. Mitchell, "Light Shafts: Rendering Shadows in Participating Media", GDC 2004.
// Look::Article draws with them. Their distances are in inches.
#pragma once

namespace tyndall::article {

inline constexpr double intensity = 20000.0;  ///< over the square of the distance in inches
inline constexpr double ambient = 0.25;       ///< added to that
inline constexpr double inchesPerMetre = 39.37007874;
inline constexpr double flatDust = 0.015;  ///< in place of noise
inline constexpr double noiseGain = 0.05;
inline constexpr double weight = 9.0 * 100.0;  ///< over the number of slices: 9 / f, with f the slices over 100

}  // namespace tyndall::article
