// The float image of all programs here.
#pragma once

#include <study/image.h>
#include <study/reference.h>

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace tyndall {

using study::Image;

/// Longest side of a picture: the smallest limit for render targets among today's Vulkan devices.
constexpr std::uint32_t longestSide = 16384;

/// An image with every value 0.
Image blankImage(int width, int height, int channels);

/// The reference's radiance in floats, RGB.
Image radianceOf(const study::ReferenceImage& reference);

std::size_t pixelCount(const Image& image);

/// The first three channels of a pixel, counted in reading order.
glm::vec3 rgbOf(const Image& image, std::size_t pixel);

/// The four channels of a pixel, counted in reading order.
glm::vec4 rgbaOf(const Image& image, std::size_t pixel);
void setRgba(Image& image, std::size_t pixel, const glm::vec4& value);

/// How many pixels hold NaN or infinity, and where the first one is.
struct BadPixels {
    std::size_t count = 0;
    int x = 0, y = 0;  ///< of the first such pixel, from the top left
};

BadPixels findBadPixels(const Image& image);

}  // namespace tyndall
