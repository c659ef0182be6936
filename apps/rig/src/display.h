// Float images for display. Values that are not finite are magenta.
#pragma once

#include <rig/image.h>

#include <cstdint>
#include <vector>

namespace tyndall::rig {

/// The value that is shown as white in both images: the largest finite value of `expected`, or of `image` if nothing
/// is expected, without the brightest thousandth of the pixels. 1 for a black image.
double whitePoint(const Image* image, const Image* expected);

/// RGB bytes: value over white, then the sRGB transfer function. One and two channels show as grey and as red
/// and green; a fourth is left out.
std::vector<std::uint8_t> displayed(const Image& image, double white);

/// |image - expected| of two images of one shape.
Image absoluteDifference(const Image& image, const Image& expected);

/// RGB bytes of a difference: the largest channel of each pixel divided by `max`, from black over red and yellow to
/// white; pixels that differ are at least dark blue.
std::vector<std::uint8_t> heatMap(const Image& difference, double max);

}  // namespace tyndall::rig
