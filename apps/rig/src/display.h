// What a screen shows of a float image. Values that are not finite are magenta, whatever stands around them.
#pragma once

#include <rig/image.h>

#include <cstdint>
#include <vector>

namespace tyndall::rig {

/// The value that is shown as white for both images: the largest, but for the brightest thousandth, of the
/// finite ones in `expected`, or in `image` where nothing is expected. 1 for a black image.
double whitePoint(const Image* image, const Image* expected);

/// RGB bytes: value over white, then the sRGB transfer function. One and two channels show as grey and as red
/// and green; a fourth is left out.
std::vector<std::uint8_t> displayed(const Image& image, double white);

/// |image - expected| of two images of one shape.
Image absoluteDifference(const Image& image, const Image& expected);

/// RGB bytes of a difference: the largest channel of each pixel over `most`, black over red and yellow to white;
/// what differs at all is at least dark blue.
std::vector<std::uint8_t> heatMap(const Image& difference, double most);

}  // namespace tyndall::rig
