// The Vulkan objects behind a Device, destroyed together with the last object made from it.
#pragma once

#include <headless/device.h>

#include <atomic>
#include <mutex>

#include "messages.h"

namespace headless {

struct DeviceCore {
    MessageLog log;  // first: the messenger writes into it until the instance is destroyed
    VkInstance instance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t queueFamily = 0;
    VkPhysicalDeviceProperties properties{};
    VkPhysicalDeviceMemoryProperties memoryProperties{};
    bool pipelineStatistics = false;
    PFN_vkSetDebugUtilsObjectNameEXT setObjectName = nullptr;

    std::mutex queueMutex;
    std::atomic<std::uint64_t> allocated{0};
    std::atomic<std::uint64_t> peakAllocated{0};

    DeviceCore() = default;
    DeviceCore(const DeviceCore&) = delete;
    DeviceCore& operator=(const DeviceCore&) = delete;
    ~DeviceCore();
};

/// "vkCreateImage failed: VK_ERROR_OUT_OF_DEVICE_MEMORY", as an error.
tl::unexpected<Error> vulkanError(const char* call, VkResult result);

}  // namespace headless
