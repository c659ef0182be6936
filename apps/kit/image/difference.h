// The difference of an image and its reference, as a picture.
#pragma once

#include <kit/fail.h>
#include <kit/image/image.h>

#include <cstdint>
#include <vector>

namespace tyndall {

/// image - reference, value by value, as floats. Both have one size and number of channels. NaN where either is NaN.
Image difference(const Image& image, const Image& reference);

/// RGB bytes of a difference: each pixel shows its channel that is farthest from 0, linearly from white for 0
/// to full red for +scale (the image is brighter) and full blue for -scale, and magenta where it is not
/// finite. `scale` > 0; larger differences are shown as `scale`.
std::vector<std::uint8_t> divergingColours(const Image& difference, double scale);

}  // namespace tyndall
