#include "display.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tyndall::rig {
namespace {

using Rgb = std::array<double, 3>;
constexpr Rgb magenta{1.0, 0.0, 1.0};

// IEC 61966-2-1.
double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

void append(std::vector<std::uint8_t>& bytes, const Rgb& colour) {
    for (const double value : colour)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
}

std::size_t pixelCount(const Image& image) {
    return static_cast<std::size_t>(image.width) * image.height;
}

bool finite(const Image& image, std::size_t pixel) {
    for (int c = 0; c < image.channels; ++c)
        if (!std::isfinite(image.values[pixel * image.channels + c])) return false;
    return true;
}

Rgb heat(double share) {
    constexpr std::array<Rgb, 5> ramp{
        Rgb{0.05, 0.08, 0.35}, {0.45, 0.05, 0.45}, {0.85, 0.2, 0.15}, {1.0, 0.75, 0.1}, {1.0, 1.0, 1.0}};
    const double at = std::clamp(share, 0.0, 1.0) * (ramp.size() - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(at), ramp.size() - 2);
    const double part = at - static_cast<double>(low);
    Rgb mixed;
    for (std::size_t c = 0; c < 3; ++c) mixed[c] = ramp[low][c] + part * (ramp[low + 1][c] - ramp[low][c]);
    return mixed;
}

}  // namespace

double whitePoint(const Image* image, const Image* expected) {
    const Image* measure = expected ? expected : image;
    if (!measure) return 1.0;
    std::vector<double> brightness;
    for (std::size_t pixel = 0; pixel < pixelCount(*measure); ++pixel) {
        double max = 0.0;
        for (int c = 0; c < std::min(measure->channels, 3); ++c)
            if (const float value = measure->values[pixel * measure->channels + c]; std::isfinite(value))
                max = std::max(max, static_cast<double>(value));
        brightness.push_back(max);
    }
    if (brightness.empty()) return 1.0;
    const auto rank =
        brightness.begin() + static_cast<std::ptrdiff_t>(brightness.size() - 1 - brightness.size() / 1000);
    std::nth_element(brightness.begin(), rank, brightness.end());
    return *rank > 0.0 ? *rank : 1.0;
}

std::vector<std::uint8_t> displayed(const Image& image, double white) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t pixel = 0; pixel < pixelCount(image); ++pixel) {
        const float* value = &image.values[pixel * image.channels];
        Rgb colour = magenta;
        if (finite(image, pixel)) {
            for (int c = 0; c < 3; ++c) {
                const int channel = image.channels == 1 ? 0 : c;
                const double linear = channel < image.channels ? value[channel] / white : 0.0;
                colour[c] = srgb(std::clamp(linear, 0.0, 1.0));
            }
        }
        append(bytes, colour);
    }
    return bytes;
}

Image absoluteDifference(const Image& image, const Image& expected) {
    Image apart = image;
    for (std::size_t i = 0; i < apart.values.size(); ++i)
        apart.values[i] = std::abs(image.values[i] - expected.values[i]);
    return apart;
}

std::vector<std::uint8_t> heatMap(const Image& difference, double max) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t pixel = 0; pixel < pixelCount(difference); ++pixel) {
        double largest = 0.0;
        for (int c = 0; c < difference.channels; ++c)
            largest = std::max(largest, static_cast<double>(difference.values[pixel * difference.channels + c]));
        if (!finite(difference, pixel))
            append(bytes, magenta);
        else if (largest > 0.0)
            append(bytes, heat(largest / max));
        else
            append(bytes, {0.0, 0.0, 0.0});
    }
    return bytes;
}

}  // namespace tyndall::rig
