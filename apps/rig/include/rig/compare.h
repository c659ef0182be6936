// Compares a picture with the expected one, within a tolerance.
#pragma once

#include <rig/image.h>
#include <study/metrics.h>

#include <cstddef>
#include <string>

namespace tyndall::rig {

/// Figures over the values that are finite in both images, which have the same shape.
struct Difference {
    double largest = 0.0;       ///< |image - expected|
    study::PixelIndex at;       ///< where
    double relativeL2 = 0.0;    ///< sqrt(sum (image - expected)^2 / sum expected^2); infinite over nothing
    std::size_t differing = 0;  ///< values whose bits differ, non-finite ones included
};
Difference difference(const Image& image, const Image& expected);

/// Allowed differences: those between processors, no more.
enum class Tolerance {
    Exact,  ///< bit for bit
    Float,  ///< 2e-5 of the largest magnitude in the same channel of the expected image: rounding errors
            ///< of sums of slices are relative to the total, and dark pixels can have the errors of bright ones
    Half,   ///< one unit in the last place of binary16, value by value
    Byte,   ///< in 255ths: at most 3, and more than 1 in at most 0.1 % of the pixels
};

/// Empty if `image` is finite, has the shape of `expected` and is within `tolerance` of it; else
/// one sentence with the figures.
std::string whyDifferent(const Image& image, const Image& expected, Tolerance tolerance);

/// Empty if every value is finite, else one sentence with the counts of NaN and infinity.
std::string whyNotFinite(const Image& image);

}  // namespace tyndall::rig
