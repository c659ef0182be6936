#include "difference.h"

#include <algorithm>
#include <cmath>

namespace tyndall {

Image difference(const Image& image, const Image& reference) {
    Image result = image;
    for (std::size_t k = 0; k < result.values.size(); ++k) result.values[k] -= reference.values[k];
    return result;
}

std::vector<std::uint8_t> divergingColours(const Image& difference, double scale) {
    std::vector<std::uint8_t> bytes;
    const auto channels = static_cast<std::size_t>(difference.channels);
    bytes.reserve(difference.values.size() / channels * 3);
    for (std::size_t pixel = 0; pixel < difference.values.size(); pixel += channels) {
        double farthest = 0.0;
        bool finite = true;
        for (std::size_t c = 0; c < channels; ++c) {
            const double value = difference.values[pixel + c];
            finite = finite && std::isfinite(value);
            if (std::abs(value) > std::abs(farthest)) farthest = value;
        }
        const double share = std::clamp(farthest / scale, -1.0, 1.0);
        const auto rest = static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - std::abs(share))));
        if (!finite)
            bytes.insert(bytes.end(), {255, 0, 255});
        else if (share > 0.0)
            bytes.insert(bytes.end(), {255, rest, rest});
        else
            bytes.insert(bytes.end(), {rest, rest, 255});
    }
    return bytes;
}

}  // namespace tyndall
