#include <fmt/format.h>
#include <rig/compare.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/gtc/packing.hpp>
#include <limits>

namespace tyndall::rig {
namespace {

constexpr double floatShare = 2e-5;
constexpr double byteMax = 3.0, byteUsual = 1.0, byteRareShare = 0.001;
/// Far more than the rounding error of a division by 255 in binary32, far less than a step of 1/255.
constexpr double byteSlack = 1e-4;

using study::PixelIndex;

PixelIndex placeOf(const Image& image, std::size_t i) {
    const std::size_t pixel = i / image.channels;
    return {static_cast<int>(pixel % image.width), static_cast<int>(pixel / image.width),
            static_cast<int>(i % image.channels)};
}

std::string words(const Image& image, std::size_t i) {
    const PixelIndex at = placeOf(image, i);
    return fmt::format("pixel ({}, {}), channel {}", at.x, at.y, at.channel);
}

/// Maps binary16 to integers: neighbours differ by 1, and both zeros are 0.
int halfOrdinal(float value) {
    const std::uint16_t bits = glm::packHalf1x16(value);
    const int magnitude = bits & 0x7fff;
    return (bits & 0x8000) != 0 ? -magnitude : magnitude;
}

std::string whyNotExact(const Image& image, const Image& expected) {
    const Difference apart = difference(image, expected);
    if (apart.differing == 0) return {};
    return fmt::format(
        "{} of {} values are not the same bits; the largest difference is {:.6g} at ({}, {}), channel {}",
        apart.differing, image.values.size(), apart.largest, apart.at.x, apart.at.y, apart.at.channel);
}

std::string whyNotFloat(const Image& image, const Image& expected) {
    std::array<double, 4> brightest{};
    for (std::size_t i = 0; i < expected.values.size(); ++i) {
        double& max = brightest[i % expected.channels];
        max = std::max(max, std::abs(static_cast<double>(expected.values[i])));
    }
    std::size_t beyond = 0, worst = 0;
    double excess = 0.0;
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        const double apart = std::abs(static_cast<double>(image.values[i]) - expected.values[i]);
        const double allowed = floatShare * brightest[i % image.channels];
        if (apart <= allowed) continue;
        ++beyond;
        const double share = apart / std::max(allowed, std::numeric_limits<double>::min());
        if (share > excess) {
            excess = share;
            worst = i;
        }
    }
    if (beyond == 0) return {};
    return fmt::format(
        "{} of {} values are off by more than {:.0e} of their channel's largest ({:.6g}); the worst is {:.9g} instead "
        "of {:.9g} at {}",
        beyond, image.values.size(), floatShare, brightest[worst % image.channels], image.values[worst],
        expected.values[worst], words(image, worst));
}

std::string whyNotHalf(const Image& image, const Image& expected) {
    std::size_t beyond = 0, worst = 0;
    int maxApart = 1;
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        const int apart = std::abs(halfOrdinal(image.values[i]) - halfOrdinal(expected.values[i]));
        beyond += apart > 1;
        if (apart > maxApart) {
            maxApart = apart;
            worst = i;
        }
    }
    if (beyond == 0) return {};
    return fmt::format(
        "{} of {} values are more than 1 half ULP off; the worst, by {}, is {:.6g} instead of {:.6g} at {}", beyond,
        image.values.size(), maxApart, image.values[worst], expected.values[worst], words(image, worst));
}

std::string whyNotByte(const Image& image, const Image& expected) {
    const std::size_t pixels = static_cast<std::size_t>(image.width) * image.height;
    std::size_t unusual = 0, worst = 0;
    double maxApart = 0.0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        double here = 0.0;
        for (int c = 0; c < image.channels; ++c) {
            const std::size_t i = pixel * image.channels + c;
            const double apart = 255.0 * std::abs(static_cast<double>(image.values[i]) - expected.values[i]);
            here = std::max(here, apart);
            if (apart > maxApart) {
                maxApart = apart;
                worst = i;
            }
        }
        unusual += here > byteUsual + byteSlack;
    }
    if (maxApart > byteMax + byteSlack)
        return fmt::format("a value is {:.3g}/255 off, the maximum is {}/255: {:.6g} instead of {:.6g} at {}", maxApart,
                           byteMax, image.values[worst], expected.values[worst], words(image, worst));
    if (static_cast<double>(unusual) > byteRareShare * static_cast<double>(pixels))
        return fmt::format(
            "{} of {} pixels are off by more than {}/255, {:.1f} % are allowed; the worst by {:.3g}/255 at {}", unusual,
            pixels, byteUsual, 100.0 * byteRareShare, maxApart, words(image, worst));
    return {};
}

}  // namespace

Difference difference(const Image& image, const Image& expected) {
    Difference apart;
    for (std::size_t i = 0; i < image.values.size(); ++i)
        apart.differing +=
            std::bit_cast<std::uint32_t>(image.values[i]) != std::bit_cast<std::uint32_t>(expected.values[i]);
    if (const auto metrics = study::compare(image, expected)) {
        apart.largest = metrics->maximumAbsolute;
        apart.at = metrics->worst.place;
        apart.relativeL2 = metrics->relativeL2;
    }
    return apart;
}

std::string whyNotFinite(const Image& image) {
    const study::NonFinite found = study::countNonFinite(image);
    if (found.count() == 0) return {};
    return fmt::format("{} values are NaN and {} are infinite, the first at ({}, {}), channel {}", found.nan,
                       found.infinite, found.first->x, found.first->y, found.first->channel);
}

std::string whyDifferent(const Image& image, const Image& expected, Tolerance tolerance) {
    if (const std::string reason = whyNotFinite(image); !reason.empty()) return reason;
    if (const std::string reason = whyNotFinite(expected); !reason.empty())
        return "the expected image itself is not finite: " + reason;
    if (!image.sameShape(expected))
        return fmt::format("the image has {} x {} pixels of {} channels, but {} x {} of {} are expected", image.width,
                           image.height, image.channels, expected.width, expected.height, expected.channels);
    switch (tolerance) {
        case Tolerance::Exact:
            return whyNotExact(image, expected);
        case Tolerance::Float:
            return whyNotFloat(image, expected);
        case Tolerance::Half:
            return whyNotHalf(image, expected);
        case Tolerance::Byte:
            return whyNotByte(image, expected);
    }
    return "there is no such tolerance";
}

}  // namespace tyndall::rig
