// A buffer with memory of its own.
#pragma once

#include <headless/device.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace headless {

enum class MemoryKind {
    Host,    ///< mapped for as long as the buffer lives, coherent
    Device,  ///< the GPU's own memory, not mapped
};

class Buffer {
public:
    /// Bounds: `size` from 1 byte. Errors: InvalidArgument, Vulkan.
    static Result<Buffer> create(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, MemoryKind kind,
                                 std::string_view name = {});
    /// A host buffer that holds `bytes`.
    static Result<Buffer> create(const Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage,
                                 std::string_view name = {});
    Buffer() = default;
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    ~Buffer();

    VkBuffer handle() const { return buffer_; }
    VkDeviceSize size() const { return size_; }
    /// The mapped bytes; empty in the GPU's own memory.
    std::span<std::byte> mapped() const { return mapped_; }

private:
    std::shared_ptr<DeviceCore> core_;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkDeviceSize size_ = 0;
    VkDeviceSize allocated_ = 0;
    std::span<std::byte> mapped_;
};

}  // namespace headless
