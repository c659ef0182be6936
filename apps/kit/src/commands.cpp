#include <headless/commands.h>
#include <tyndall/barriers.h>

#include <chrono>

#include "device_core.h"

namespace headless {
namespace {

/// The pool and fence of one submission.
struct OneShot {
    VkDevice device;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
    explicit OneShot(VkDevice owner) : device(owner) {}
    OneShot(const OneShot&) = delete;
    OneShot& operator=(const OneShot&) = delete;
    ~OneShot() {
        vkDestroyFence(device, fence, nullptr);
        vkDestroyCommandPool(device, pool, nullptr);
    }
};

}  // namespace

Result<double> submitAndWait(const Device& device, const std::function<Result<void>(VkCommandBuffer)>& record) {
    OneShot once(device.device());
    VkCommandPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    poolInfo.queueFamilyIndex = device.queueFamily();
    VkResult result = vkCreateCommandPool(once.device, &poolInfo, nullptr, &once.pool);
    if (result != VK_SUCCESS) return vulkanError("vkCreateCommandPool", result);
    VkFenceCreateInfo fenceInfo{};
    fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    result = vkCreateFence(once.device, &fenceInfo, nullptr, &once.fence);
    if (result != VK_SUCCESS) return vulkanError("vkCreateFence", result);

    VkCommandBufferAllocateInfo allocateInfo{};
    allocateInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocateInfo.commandPool = once.pool;
    allocateInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocateInfo.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    result = vkAllocateCommandBuffers(once.device, &allocateInfo, &commands);
    if (result != VK_SUCCESS) return vulkanError("vkAllocateCommandBuffers", result);

    VkCommandBufferBeginInfo beginInfo{};
    beginInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    beginInfo.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    result = vkBeginCommandBuffer(commands, &beginInfo);
    if (result != VK_SUCCESS) return vulkanError("vkBeginCommandBuffer", result);
    if (auto recorded = record(commands); !recorded) return tl::unexpected(recorded.error());
    result = vkEndCommandBuffer(commands);
    if (result != VK_SUCCESS) return vulkanError("vkEndCommandBuffer", result);

    VkCommandBufferSubmitInfo commandInfo{};
    commandInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commandInfo.commandBuffer = commands;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commandInfo;
    const auto start = std::chrono::steady_clock::now();
    {
        const std::lock_guard lock(device.core()->queueMutex);
        result = vkQueueSubmit2(device.queue(), 1, &submit, once.fence);
    }
    if (result != VK_SUCCESS) return vulkanError("vkQueueSubmit2", result);
    result = vkWaitForFences(once.device, 1, &once.fence, VK_TRUE, UINT64_MAX);
    if (result != VK_SUCCESS) return vulkanError("vkWaitForFences", result);
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void transition(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, VkImageLayout from,
                VkImageLayout to) {
    VkImageMemoryBarrier2 barrier = tyndall::imageBarrier(image, aspect);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    tyndall::recordBarrier(commands, barrier);
}

void transition(VkCommandBuffer commands, const Image& image, VkImageLayout from, VkImageLayout to) {
    VkImageAspectFlags aspect = image.aspect();
    // Both aspects of a combined format change layout together.
    if (image.format() == VK_FORMAT_D16_UNORM_S8_UINT || image.format() == VK_FORMAT_D24_UNORM_S8_UINT ||
        image.format() == VK_FORMAT_D32_SFLOAT_S8_UINT)
        aspect |= VK_IMAGE_ASPECT_STENCIL_BIT;
    transition(commands, image.handle(), aspect, from, to);
}

void fullBarrier(VkCommandBuffer commands) {
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    tyndall::recordBarrier(commands, barrier);
}

}  // namespace headless
