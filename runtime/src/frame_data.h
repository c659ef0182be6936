// Host-visible memory for a frame's vertices, indices and constants, allocated front to back.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gpu_context.h"

namespace tyndall {

struct FrameRange {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
};

/// The results of upload() that record() needs.
struct UploadedPlan {
    FrameRange vertices, indices, screenTriangle;
    bool valid = false;                 ///< false: upload() has not been called, or failed
    std::vector<FrameRange> constants;  ///< one for each of the plan's
    std::size_t vertexCount = 0, indexCount = 0;
};

struct FrameData::Impl {
    struct Block {
        VkBuffer buffer = VK_NULL_HANDLE;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        VkDeviceSize size = 0;       ///< maximum of bytes to allocate
        VkDeviceSize allocated = 0;  ///< bytes of device memory
        std::byte* mapped = nullptr;
    };

    Gpu gpu;  ///< of the renderer that used it first
    std::vector<Block> blocks;
    VkDeviceSize used = 0;  ///< of the last block
    UploadedPlan plan;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl();
};

/// Frees all ranges and makes room for `bytes` in one block.
Result<void> resetFrame(FrameData::Impl& frame, VkDeviceSize bytes);

/// Maximum of bytes that `size` bytes take, including alignment.
VkDeviceSize frameBytes(const Gpu& gpu, VkDeviceSize size);

/// Copies `bytes`, which may be empty, to memory that the GPU reads.
Result<FrameRange> place(FrameData::Impl& frame, std::span<const std::byte> bytes);

}  // namespace tyndall
