// The caller's device, with the properties and functions that the runtime uses.
#pragma once

#include <tyndall/renderer.h>
#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace tyndall {

struct Gpu {
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;
    Shaders shaders = Shaders::Frozen;  ///< of the slices
    VkPhysicalDeviceMemoryProperties memory{};
    VkDeviceSize uniformAlignment = 256;  ///< of uniform buffer offsets, bytes
    VkDeviceSize uniformRange = 16384;    ///< the longest uniform block, bytes
    PFN_vkCmdPushDescriptorSetKHR pushDescriptorSet = nullptr;
    PFN_vkSetDebugUtilsObjectNameEXT setObjectName = nullptr;  ///< null without VK_EXT_debug_utils
};

/// Errors: InvalidArgument for a null handle, UnsupportedDevice with the missing feature's name.
Result<Gpu> inspect(const DeviceContext& context);

/// "vkCreateBuffer failed: VK_ERROR_OUT_OF_HOST_MEMORY", as an error.
tl::unexpected<Error> vulkanError(const char* call, VkResult result);
tl::unexpected<Error> invalidArgument(std::string message);
tl::unexpected<Error> unsupported(std::string message);

/// "VkFormat 97" for messages: the number is the one in vulkan_core.h.
std::string formatName(VkFormat format);

/// The first memory type in `allowed` that has all flags of `wanted`; UINT32_MAX if there is none.
std::uint32_t memoryType(const Gpu& gpu, std::uint32_t allowed, VkMemoryPropertyFlags wanted);

void setName(const Gpu& gpu, VkObjectType type, std::uint64_t handle, std::string_view name);

/// Non-dispatchable handles are pointers on some platforms and integers on others.
template <class Handle>
void setName(const Gpu& gpu, VkObjectType type, Handle* handle, std::string_view name) {
    setName(gpu, type, static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(handle)), name);
}

}  // namespace tyndall
