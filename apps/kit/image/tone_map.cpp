#include <kit/image/srgb.h>
#include <kit/image/tone_map.h>

#include <algorithm>
#include <cmath>

namespace tyndall {
namespace {

constexpr double key = 0.18;
/// Exposed value that becomes white: 22 times the key, about four and a half stops above it.
constexpr double white = 4.0;
/// Pixels darker than this share of the brightest pixel are background and do not count for the exposure.
constexpr double unlit = 1e-5;

double luminance(const glm::vec3& p) {
    return 0.2126 * p.x + 0.7152 * p.y + 0.0722 * p.z;
}  // Rec. 709

}  // namespace

double automaticExposure(const Image& picture) {
    double brightest = 0.0;
    for (std::size_t i = 0; i < pixelCount(picture); ++i) brightest = std::max(brightest, luminance(rgbOf(picture, i)));
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixelCount(picture); ++i)
        if (const double value = luminance(rgbOf(picture, i)); value > unlit * brightest) {
            sum += std::log2(value);
            ++count;
        }
    return count == 0 ? 0.0 : std::log2(key) - sum / static_cast<double>(count);
}

double toneMap(double radiance, double exposureStops) {
    const double c = std::max(radiance, 0.0) * std::exp2(exposureStops);
    return std::min(c * (1.0 + c / (white * white)) / (1.0 + c), 1.0);
}

double displayStep(double exposureStops) {
    constexpr double srgbSlope = 12.92;  // at black, where the tone curve's own slope is 1
    return std::exp2(-exposureStops) / (256.0 * srgbSlope);
}

std::vector<std::uint8_t> displayBytes(const Image& picture, std::optional<double> exposureStops) {
    const double stops = exposureStops.value_or(automaticExposure(picture));
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * pixelCount(picture));
    for (std::size_t i = 0; i < pixelCount(picture); ++i) {
        const glm::vec3 pixel = rgbOf(picture, i);
        for (int c = 0; c < 3; ++c)
            bytes.push_back(static_cast<std::uint8_t>(
                std::lround(255.0f * srgbFromLinear(static_cast<float>(toneMap(pixel[c], stops))))));
    }
    return bytes;
}

}  // namespace tyndall
