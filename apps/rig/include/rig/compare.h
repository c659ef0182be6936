// How far a picture is from the one expected, and whether that is too far.
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

/// How close is close enough: what other processors draw differently, and no more.
enum class Tolerance {
    Exact,  ///< bit for bit
    Float,  ///< 2e-5 of the largest magnitude in the same channel of the expected image: sums of slices lose
            ///< relative to their total, and the dark end of a picture inherits what its bright end lost
    Half,   ///< one unit in the last place of binary16, value by value
    Byte,   ///< in 255ths: 3 at most, and over 1 in no more than 0.1 % of the pixels
};

/// Empty where `image` is finite, has the shape of `expected` and is as close to it as `tolerance` asks; else
/// one sentence with the figures.
std::string whyDifferent(const Image& image, const Image& expected, Tolerance tolerance);

/// Empty where every value is finite, else one sentence that counts NaN and infinity apart.
std::string whyNotFinite(const Image& image);

}  // namespace tyndall::rig
