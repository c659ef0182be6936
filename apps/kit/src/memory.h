#pragma once

#include "device_core.h"

namespace headless {

struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize size = 0;
};

/// Memory that meets `requirements` and has all of `wanted`; counted in the core.
Result<Allocation> allocate(DeviceCore& core, const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted);
void release(DeviceCore& core, VkDeviceMemory memory, VkDeviceSize size);

}  // namespace headless
