// A picture in memory: linear radiance, three channels, rows top to bottom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace tyndall {

/// Longest side of a picture: what Vulkan devices of today offer at least for render targets.
constexpr std::uint32_t longestSide = 16384;

struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<glm::vec3> pixels;
};

/// How many pixels hold NaN or infinity, and where the first one is.
struct BadPixels {
    std::size_t count = 0;
    std::uint32_t x = 0, y = 0;  ///< of the first, from the top left
};

BadPixels findBadPixels(const Picture& picture);

}  // namespace tyndall
