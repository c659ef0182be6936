#include "frame_data.h"

#include <algorithm>
#include <cstring>

namespace tyndall {
namespace {

constexpr VkDeviceSize smallestBlock = 64 * 1024;

void destroy(const Gpu& gpu, FrameData::Impl::Block& block) {
    vkDestroyBuffer(gpu.device, block.buffer, nullptr);
    vkFreeMemory(gpu.device, block.memory, nullptr);
    block = {};
}

Result<FrameData::Impl::Block> createBlock(const Gpu& gpu, VkDeviceSize size) {
    FrameData::Impl::Block block;
    block.size = size;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
                 VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    VkResult result = vkCreateBuffer(gpu.device, &info, nullptr, &block.buffer);
    if (result != VK_SUCCESS) return vulkanError("vkCreateBuffer", result);

    VkMemoryRequirements requirements;
    vkGetBufferMemoryRequirements(gpu.device, block.buffer, &requirements);
    constexpr VkMemoryPropertyFlags mapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    // Every device has a coherent type for buffers (Vulkan 1.3, 11.6 "Device Memory").
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.allocationSize = block.allocated = requirements.size;
    allocate.memoryTypeIndex = memoryType(gpu, requirements.memoryTypeBits, mapped);
    result = vkAllocateMemory(gpu.device, &allocate, nullptr, &block.memory);
    const char* call = "vkAllocateMemory";
    if (result == VK_SUCCESS) {
        call = "vkBindBufferMemory";
        result = vkBindBufferMemory(gpu.device, block.buffer, block.memory, 0);
    }
    void* address = nullptr;
    if (result == VK_SUCCESS) {
        call = "vkMapMemory";
        result = vkMapMemory(gpu.device, block.memory, 0, VK_WHOLE_SIZE, 0, &address);
    }
    if (result != VK_SUCCESS) {
        destroy(gpu, block);
        return vulkanError(call, result);
    }
    block.mapped = static_cast<std::byte*>(address);
    setName(gpu, VK_OBJECT_TYPE_BUFFER, block.buffer, "tyndall frame data");
    setName(gpu, VK_OBJECT_TYPE_DEVICE_MEMORY, block.memory, "tyndall frame data");
    return block;
}

/// Uniform buffer offsets have the strictest alignment of all data here.
VkDeviceSize alignment(const Gpu& gpu) {
    return std::max<VkDeviceSize>(16, gpu.uniformAlignment);
}

Result<void> addBlock(FrameData::Impl& frame, VkDeviceSize bytes) {
    auto block = createBlock(frame.gpu, std::max(bytes, smallestBlock));
    if (!block) return tl::unexpected(block.error());
    frame.blocks.push_back(*block);
    frame.used = 0;
    return {};
}

}  // namespace

FrameData::Impl::~Impl() {
    for (Block& block : blocks) destroy(gpu, block);
}

FrameData::FrameData() : impl_(std::make_unique<Impl>()) {}
FrameData::FrameData(FrameData&&) noexcept = default;
FrameData& FrameData::operator=(FrameData&&) noexcept = default;
FrameData::~FrameData() = default;

VkDeviceSize FrameData::memory() const {
    VkDeviceSize bytes = 0;
    if (impl_)
        for (const Impl::Block& block : impl_->blocks) bytes += block.allocated;
    return bytes;
}

VkDeviceSize frameBytes(const Gpu& gpu, VkDeviceSize size) {
    const VkDeviceSize unit = alignment(gpu);
    return (size + unit - 1) / unit * unit;
}

Result<void> resetFrame(FrameData::Impl& frame, VkDeviceSize bytes) {
    frame.plan.valid = false;
    frame.used = 0;
    VkDeviceSize held = 0;
    for (const FrameData::Impl::Block& block : frame.blocks) held += block.size;
    if (bytes == 0 && frame.blocks.empty()) return {};
    if (frame.blocks.size() == 1 && held >= bytes) return {};
    for (FrameData::Impl::Block& block : frame.blocks) destroy(frame.gpu, block);
    frame.blocks.clear();
    return addBlock(frame, std::max(held, bytes));
}

Result<FrameRange> place(FrameData::Impl& frame, std::span<const std::byte> bytes) {
    const VkDeviceSize size = frameBytes(frame.gpu, bytes.size());
    if (frame.blocks.empty() || frame.blocks.back().size - frame.used < size)
        if (auto added = addBlock(frame, size); !added) return tl::unexpected(added.error());
    const FrameData::Impl::Block& block = frame.blocks.back();
    const FrameRange range{block.buffer, frame.used};
    if (!bytes.empty()) std::memcpy(block.mapped + frame.used, bytes.data(), bytes.size());
    frame.used += size;
    return range;
}

}  // namespace tyndall
