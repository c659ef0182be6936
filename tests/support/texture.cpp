#include "texture.h"

#include <cmath>

namespace tyndall::test {
namespace {

int resolve(int i, int size, Address address) {
    if (address == Address::Clamp) return std::clamp(i, 0, size - 1);
    return ((i % size) + size) % size;
}

}  // namespace

Texture makeTexture(int width, int height, int channels, const std::function<double(int, int, int)>& texel) {
    Texture texture{width, height, channels, {}};
    texture.texels.reserve(static_cast<std::size_t>(width) * height * channels);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < channels; ++c) texture.texels.push_back(static_cast<float>(texel(x, y, c)));
    return texture;
}

Texture constantTexture(int width, int height, const std::vector<float>& value) {
    return makeTexture(width, height, static_cast<int>(value.size()), [&](int, int, int c) { return value[c]; });
}

Interval bilinear(int width, int height, Address address, Interval x, Interval y,
                  const std::function<double(int, int)>& texel) {
    const double tx = x.mid() - 0.5, ty = y.mid() - 0.5;
    const int cx = static_cast<int>(std::floor(tx)), cy = static_cast<int>(std::floor(ty));
    const double fx = tx - cx, fy = ty - cy;

    // A box of less than a texel around the middle touches at most the 4 x 4 texels around it; between them
    // the surface is no steeper than the largest step between neighbours. Larger boxes get larger patches.
    const double radius = std::min(std::max(x.radius(), y.radius()), static_cast<double>(std::max(width, height)));
    const int reach = 1 + static_cast<int>(std::ceil(radius));
    const int side = 2 * reach + 2;
    std::vector<double> patch(static_cast<std::size_t>(side) * side);
    const auto at = [&](int i, int j) -> double& {
        return patch[static_cast<std::size_t>(j + reach) * side + i + reach];
    };
    for (int j = -reach; j <= reach + 1; ++j)
        for (int i = -reach; i <= reach + 1; ++i)
            at(i, j) = texel(resolve(cx + i, width, address), resolve(cy + j, height, address));

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

Interval sampleLinear(const Texture& texture, int channel, Address address, Interval u, Interval v) {
    // Scaling to texels and subtracting a half, then the fraction: three roundings relative to the coordinate.
    const auto texels = [](Interval t, int size) {
        const Interval scaled = {t.lo * size, t.hi * size};
        const double slack = 3.0 * kFloatEps * (std::max(std::abs(scaled.lo), std::abs(scaled.hi)) + 0.5);
        return Interval{scaled.lo - slack, scaled.hi + slack};
    };
    double largest = 0.0;
    const Interval value = bilinear(texture.width, texture.height, address, texels(u, texture.width),
                                    texels(v, texture.height), [&](int x, int y) {
                                        const double t = texture.at(x, y, channel);
                                        largest = std::max(largest, std::abs(t));
                                        return t;
                                    });
    // Three lerps, each a difference, a product and a sum of values no larger than the largest texel; the
    // difference may be twice that.
    return {value.lo - 3.0 * 4.0 * kFloatEps * largest, value.hi + 3.0 * 4.0 * kFloatEps * largest};
}

}  // namespace tyndall::test
