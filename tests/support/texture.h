// Textures as the tests know them: texels in binary32, row by row from the top, and their own sampling.
#pragma once

#include <functional>
#include <vector>

#include "interval.h"

namespace tyndall::test {

struct Texture {
    int width = 0, height = 0, channels = 1;
    std::vector<float> texels;  ///< channels of a texel side by side

    float at(int x, int y, int channel = 0) const {
        return texels[(static_cast<std::size_t>(y) * width + x) * channels + channel];
    }
};

enum class Address { Clamp, Wrap };

/// A texture filled by `texel(x, y, channel)`.
Texture makeTexture(int width, int height, int channels, const std::function<double(int, int, int)>& texel);

/// Every texel alike.
Texture constantTexture(int width, int height, const std::vector<float>& value);

/// Bilinear sample at every texel coordinate of the box x, y (in texels; 0.5 is the first texel's centre) of
/// an image given by its texel function, which is only asked for texels inside.
Interval bilinear(int width, int height, Address address, Interval x, Interval y,
                  const std::function<double(int, int)>& texel);

/// Bilinear sample of a float texture at u, v in [0, 1], rounding of the coordinates and of the filter included.
Interval sampleLinear(const Texture& texture, int channel, Address address, Interval u, Interval v);

}  // namespace tyndall::test
