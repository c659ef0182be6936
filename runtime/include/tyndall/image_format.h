// Vulkan's formats of storage images.
#pragma once

#include <permgen/tables.h>
#include <vulkan/vulkan_core.h>

namespace tyndall {

/// The format that the view of a storage image must have; UNDEFINED for None.
VkFormat vulkanFormat(permgen::ImageFormat format);

}  // namespace tyndall
