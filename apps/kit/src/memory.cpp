#include "memory.h"

#include <optional>

namespace headless {
namespace {

std::optional<std::uint32_t> memoryType(const VkPhysicalDeviceMemoryProperties& properties, std::uint32_t allowed,
                                        VkMemoryPropertyFlags wanted) {
    for (std::uint32_t type = 0; type < properties.memoryTypeCount; ++type)
        if ((allowed & (1u << type)) && (properties.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
    return std::nullopt;
}

}  // namespace

Result<Allocation> allocate(DeviceCore& core, const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted) {
    const auto type = memoryType(core.memoryProperties, requirements.memoryTypeBits, wanted);
    if (!type)
        return tl::unexpected(
            Error{ErrorCode::UnsupportedDevice, "the device has no memory of the requested kind", VK_SUCCESS});
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = requirements.size;
    info.memoryTypeIndex = *type;
    Allocation allocation{VK_NULL_HANDLE, requirements.size};
    const VkResult result = vkAllocateMemory(core.device, &info, nullptr, &allocation.memory);
    if (result != VK_SUCCESS) return vulkanError("vkAllocateMemory", result);

    const std::uint64_t now = core.allocated += requirements.size;
    std::uint64_t peak = core.peakAllocated;
    while (peak < now && !core.peakAllocated.compare_exchange_weak(peak, now)) {
    }
    return allocation;
}

void release(DeviceCore& core, VkDeviceMemory memory, VkDeviceSize size) {
    if (!memory) return;
    vkFreeMemory(core.device, memory, nullptr);
    core.allocated -= size;
}

}  // namespace headless
