// Vulkan's results by name, for messages.
#pragma once

#include <vulkan/vulkan_core.h>

#include <string>

namespace tyndall {

/// The result's name, such as "VK_ERROR_DEVICE_LOST". A result that no call of the runtime is expected to return has
/// its number instead, such as "VkResult -13".
std::string resultName(VkResult result);

}  // namespace tyndall
