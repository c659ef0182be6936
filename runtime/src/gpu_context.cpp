#include "gpu_context.h"

#include <tyndall/vulkan_result.h>

namespace tyndall {
Result<Gpu> inspect(const DeviceContext& context) {
    if (!context.physicalDevice || !context.device)
        return invalidArgument("the device context has a null handle; give physicalDevice and device");

    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(context.physicalDevice, &properties);
    const std::string name = properties.deviceName;
    if (properties.apiVersion < VK_API_VERSION_1_3) return unsupported(name + " lacks Vulkan 1.3");
    VkPhysicalDeviceVulkan13Features features13{};
    features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &features13;
    vkGetPhysicalDeviceFeatures2(context.physicalDevice, &features);
    if (!features13.dynamicRendering) return unsupported(name + " lacks the feature dynamicRendering");
    if (!features13.synchronization2) return unsupported(name + " lacks the feature synchronization2");
    if (!features.features.shaderClipDistance) return unsupported(name + " lacks the feature shaderClipDistance");
    if (properties.limits.maxClipDistances < 8)
        return unsupported(name + " offers fewer than 8 clip distances (maxClipDistances)");

    Gpu gpu;
    gpu.physicalDevice = context.physicalDevice;
    gpu.device = context.device;
    gpu.pipelineCache = context.pipelineCache;
    gpu.shaders = context.shaders;
    vkGetPhysicalDeviceMemoryProperties(context.physicalDevice, &gpu.memory);
    gpu.uniformAlignment = properties.limits.minUniformBufferOffsetAlignment;
    gpu.uniformRange = properties.limits.maxUniformBufferRange;
    gpu.pushDescriptorSet = reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
        vkGetDeviceProcAddr(context.device, "vkCmdPushDescriptorSetKHR"));
    if (!gpu.pushDescriptorSet)
        return unsupported(
            "the extension VK_KHR_push_descriptor is not enabled on the device; enable it with the "
            "device's creation");
    gpu.setObjectName = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
        vkGetDeviceProcAddr(context.device, "vkSetDebugUtilsObjectNameEXT"));
    return gpu;
}

tl::unexpected<Error> vulkanError(const char* call, VkResult result) {
    return tl::unexpected(Error{ErrorCode::Vulkan, std::string(call) + " failed: " + resultName(result), call, result});
}

tl::unexpected<Error> invalidArgument(std::string message) {
    return tl::unexpected(Error{ErrorCode::InvalidArgument, std::move(message)});
}

tl::unexpected<Error> unsupported(std::string message) {
    return tl::unexpected(Error{ErrorCode::UnsupportedDevice, std::move(message)});
}

std::string formatName(VkFormat format) {
    return "VkFormat " + std::to_string(format);
}

std::uint32_t memoryType(const Gpu& gpu, std::uint32_t allowed, VkMemoryPropertyFlags wanted) {
    for (std::uint32_t type = 0; type < gpu.memory.memoryTypeCount; ++type)
        if ((allowed & (1u << type)) && (gpu.memory.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
    return UINT32_MAX;
}

void setName(const Gpu& gpu, VkObjectType type, std::uint64_t handle, std::string_view name) {
    if (!gpu.setObjectName) return;
    const std::string text(name);
    VkDebugUtilsObjectNameInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = text.c_str();
    gpu.setObjectName(gpu.device, &info);
}

}  // namespace tyndall
