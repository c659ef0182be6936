#include "texture.h"

#include <cmath>

namespace tyndall::test {

int addressed(int i, int size, Address address) {
    if (address == Address::Clamp) return std::clamp(i, 0, size - 1);
    return ((i % size) + size) % size;
}

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
