// A picture read back from the GPU, and checks of it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "oracle.h"

namespace tyndall::test {

struct Picture {
    int width = 0, height = 0;
    std::vector<std::array<float, 4>> pixels;  ///< rows from the top

    const std::array<float, 4>& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// The first channel that is not finite, as a message; empty if all are finite.
std::string whyNotFinite(const Picture& picture);

/// A message about the pixels of `picture` divided by `scale` that lie outside their interval in `allowed`, with the
/// first few; empty if there are none. Finiteness is checked first. Channels from 0 to 3.
using Allowed = std::array<Interval, 4>;
std::string whyOutside(const Picture& picture, double scale, const std::vector<Allowed>& allowed);

/// The oracle's intervals, pixel by pixel.
std::vector<Allowed> allowedBy(const OracleImage& image);

/// The oracle's relative width for this picture: the sum of its intervals' widths over the sum of their middles. A wide
/// oracle proves nothing.
double vagueness(const std::vector<Allowed>& allowed);

/// The number of pixels with any light in them.
int litPixels(const Picture& picture);

/// The largest difference of any channel, relative to the brightest value of either picture.
double largestDifference(const Picture& a, const Picture& b);

}  // namespace tyndall::test
