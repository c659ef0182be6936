// The tests' textures: texels in binary32, row by row from the top, with their own sampling.
#pragma once

#include <algorithm>
#include <cmath>
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

/// A texture of one value.
Texture constantTexture(int width, int height, const std::vector<float>& value);

/// A texel's coordinate in the image, by the addressing mode.
int addressed(int i, int size, Address address);

/// Bilinear sample at every texel coordinate of the box x, y (in texels; 0.5 is the first texel's centre) of
/// an image given by its texel function, which is called only for texels inside.
template <class Texel>
Interval bilinear(int width, int height, Address address, Interval x, Interval y, const Texel& texel) {
    const double tx = x.mid() - 0.5, ty = y.mid() - 0.5;
    const int cx = static_cast<int>(std::floor(tx)), cy = static_cast<int>(std::floor(ty));
    const double fx = tx - cx, fy = ty - cy;

    // A box of less than a texel around the middle touches at most the 4 x 4 texels around it; between them
    // the surface is no steeper than the largest step between neighbours. Larger boxes get larger patches.
    const double radius = std::min(std::max(x.radius(), y.radius()), static_cast<double>(std::max(width, height)));
    const int reach = 1 + static_cast<int>(radius);
    const int side = 2 * reach + 2;
    thread_local std::vector<double> patch;
    patch.resize(static_cast<std::size_t>(side) * side);
    const auto at = [&](int i, int j) -> double& {
        return patch[static_cast<std::size_t>(j + reach) * side + i + reach];
    };
    for (int j = -reach; j <= reach + 1; ++j) {
        const int row = addressed(cy + j, height, address);
        for (int i = -reach; i <= reach + 1; ++i) at(i, j) = texel(addressed(cx + i, width, address), row);
    }

    double stepX = 0.0, stepY = 0.0;
    for (int j = -reach; j <= reach + 1; ++j)
        for (int i = -reach; i <= reach; ++i) {
            stepX = std::max(stepX, std::abs(at(i + 1, j) - at(i, j)));
            stepY = std::max(stepY, std::abs(at(j, i + 1) - at(j, i)));
        }
    const double top = at(0, 0) + (at(1, 0) - at(0, 0)) * fx;
    const double bottom = at(0, 1) + (at(1, 1) - at(0, 1)) * fx;
    return around(top + (bottom - top) * fy, stepX * x.radius() + stepY * y.radius());
}

/// Bilinear sample of a float texture at u, v in [0, 1], rounding of the coordinates and of the filter included.
Interval sampleLinear(const Texture& texture, int channel, Address address, Interval u, Interval v);

}  // namespace tyndall::test
