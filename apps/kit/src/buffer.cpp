#include <headless/buffer.h>

#include <algorithm>
#include <utility>

#include "device_core.h"
#include "memory.h"

namespace headless {

Result<Buffer> Buffer::create(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, MemoryKind kind,
                              std::string_view name) {
    if (size == 0)
        return tl::unexpected(Error{ErrorCode::InvalidArgument, "a buffer needs at least one byte, not 0", VK_SUCCESS});
    Buffer buffer;
    buffer.core_ = device.core();
    buffer.size_ = size;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = usage;
    VkDevice handle = device.device();
    VkResult result = vkCreateBuffer(handle, &info, nullptr, &buffer.buffer_);
    if (result != VK_SUCCESS) return vulkanError("vkCreateBuffer", result);

    VkMemoryRequirements requirements;
    vkGetBufferMemoryRequirements(handle, buffer.buffer_, &requirements);
    const VkMemoryPropertyFlags wanted =
        kind == MemoryKind::Host ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                 : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
    auto memory = allocate(*buffer.core_, requirements, wanted);
    if (!memory) return tl::unexpected(memory.error());
    buffer.memory_ = memory->memory;
    buffer.allocated_ = memory->size;
    result = vkBindBufferMemory(handle, buffer.buffer_, buffer.memory_, 0);
    if (result != VK_SUCCESS) return vulkanError("vkBindBufferMemory", result);
    if (kind == MemoryKind::Host) {
        void* address = nullptr;
        result = vkMapMemory(handle, buffer.memory_, 0, VK_WHOLE_SIZE, 0, &address);
        if (result != VK_SUCCESS) return vulkanError("vkMapMemory", result);
        buffer.mapped_ = {static_cast<std::byte*>(address), static_cast<std::size_t>(size)};
    }
    device.setName(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(buffer.buffer_), name);
    return buffer;
}

Result<Buffer> Buffer::create(const Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage,
                              std::string_view name) {
    auto buffer = create(device, bytes.size(), usage, MemoryKind::Host, name);
    if (buffer) std::copy(bytes.begin(), bytes.end(), buffer->mapped().begin());
    return buffer;
}

Buffer::Buffer(Buffer&& other) noexcept {
    *this = std::move(other);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(core_, other.core_);
    std::swap(buffer_, other.buffer_);
    std::swap(memory_, other.memory_);
    std::swap(size_, other.size_);
    std::swap(allocated_, other.allocated_);
    std::swap(mapped_, other.mapped_);
    return *this;
}

Buffer::~Buffer() {
    if (!core_) return;
    vkDestroyBuffer(core_->device, buffer_, nullptr);
    release(*core_, memory_, allocated_);
}

}  // namespace headless
