#include "physical_device.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace headless {
namespace {

bool hasExtension(VkPhysicalDevice device, const char* name) {
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(), [&](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

std::optional<std::uint32_t> graphicsFamily(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    for (std::uint32_t family = 0; family < count; ++family)
        if (families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT) return family;
    return std::nullopt;
}

/// What the device lacks; empty if it lacks nothing.
std::string lacks(VkPhysicalDevice device, const VkPhysicalDeviceProperties& properties, const DeviceOptions& options) {
    if (properties.apiVersion < VK_API_VERSION_1_3) return "Vulkan 1.3";
    VkPhysicalDeviceVulkan13Features features13{};
    features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &features13;
    vkGetPhysicalDeviceFeatures2(device, &features);
    if (!features13.dynamicRendering) return "the feature dynamicRendering";
    if (!features13.synchronization2) return "the feature synchronization2";
    if (!features.features.shaderClipDistance) return "the feature shaderClipDistance";
    if (options.pushDescriptors && !hasExtension(device, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME))
        return "the extension VK_KHR_push_descriptor";
    if (!graphicsFamily(device)) return "a graphics queue";
    if (!options.deviceName.empty() && !std::strstr(properties.deviceName, options.deviceName.c_str()))
        return "the wanted name '" + options.deviceName + "'";
    return {};
}

/// Smaller is better.
int rank(VkPhysicalDeviceType type, bool preferSoftware) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 3;
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return preferSoftware ? 0 : 4;
        default:
            return 5;
    }
}

}  // namespace

Result<void> choosePhysicalDevice(DeviceCore& core, const DeviceOptions& options) {
    std::uint32_t count = 0;
    const VkResult counted = vkEnumeratePhysicalDevices(core.instance, &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    const VkResult listed = vkEnumeratePhysicalDevices(core.instance, &count, devices.data());
    if (counted == VK_ERROR_INITIALIZATION_FAILED || listed == VK_ERROR_INITIALIZATION_FAILED || count == 0)
        return tl::unexpected(Error{ErrorCode::UnsupportedDevice,
                                    "there is no Vulkan device; install a driver, e.g. Mesa's lavapipe, which needs "
                                    "no GPU, and check VK_DRIVER_FILES and VK_ICD_FILENAMES",
                                    VK_SUCCESS});
    if (counted != VK_SUCCESS) return vulkanError("vkEnumeratePhysicalDevices", counted);
    if (listed != VK_SUCCESS) return vulkanError("vkEnumeratePhysicalDevices", listed);

    std::string reasons;
    int best = 100;
    for (VkPhysicalDevice device : devices) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(device, &properties);
        const std::string lack = lacks(device, properties, options);
        if (!lack.empty()) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(properties.deviceName) + " lacks " + lack;
            continue;
        }
        const int order = rank(properties.deviceType, options.preferSoftware);
        if (order >= best) continue;
        best = order;
        core.physicalDevice = device;
        core.properties = properties;
    }
    if (core.physicalDevice == VK_NULL_HANDLE)
        return tl::unexpected(
            Error{ErrorCode::UnsupportedDevice, "no Vulkan device is suitable: " + reasons, VK_SUCCESS});

    core.queueFamily = *graphicsFamily(core.physicalDevice);
    vkGetPhysicalDeviceMemoryProperties(core.physicalDevice, &core.memoryProperties);
    VkPhysicalDeviceFeatures features;
    vkGetPhysicalDeviceFeatures(core.physicalDevice, &features);
    core.pipelineStatistics = features.pipelineStatisticsQuery == VK_TRUE;
    return {};
}

}  // namespace headless
