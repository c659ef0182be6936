// Texels of a render target as floats.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tyndall::rig {

/// Formats: R32G32B32A32_SFLOAT, R16G16B16A16_SFLOAT or R8G8B8A8_UNORM; four floats per texel.
std::vector<float> decodeTexels(std::span<const std::byte> bytes, VkFormat format);

}  // namespace tyndall::rig
