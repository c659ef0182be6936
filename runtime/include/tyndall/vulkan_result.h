// Vulkan's results by name, for messages.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>

namespace tyndall {

/// "VK_ERROR_DEVICE_LOST": the name, for results of the calls made here; others as "VkResult 7".
std::string resultName(VkResult result);

}  // namespace tyndall
