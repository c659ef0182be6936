#include "neutral_textures.h"

#include "barriers.h"

namespace tyndall {
namespace {

constexpr VkFormat colourFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkFormat depthFormat = VK_FORMAT_D16_UNORM;  // sampled depth of 16 bits is there on every device

Result<void> create(const Gpu& gpu, NeutralTexture& texture) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = texture.depth ? depthFormat : colourFormat;
    info.extent = {1, 1, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    VkResult result = vkCreateImage(gpu.device, &info, nullptr, &texture.image);
    if (result != VK_SUCCESS) return vulkanError("vkCreateImage", result);
    const char* name = texture.depth ? "tyndall empty shadow map" : "tyndall white texture";
    setName(gpu, VK_OBJECT_TYPE_IMAGE, texture.image, name);

    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(gpu.device, texture.image, &requirements);
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.allocationSize = requirements.size;
    allocate.memoryTypeIndex = memoryType(gpu, requirements.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    if (allocate.memoryTypeIndex == UINT32_MAX)
        allocate.memoryTypeIndex = memoryType(gpu, requirements.memoryTypeBits, 0);
    result = vkAllocateMemory(gpu.device, &allocate, nullptr, &texture.memory);
    if (result != VK_SUCCESS) return vulkanError("vkAllocateMemory", result);
    setName(gpu, VK_OBJECT_TYPE_DEVICE_MEMORY, texture.memory, name);
    result = vkBindImageMemory(gpu.device, texture.image, texture.memory, 0);
    if (result != VK_SUCCESS) return vulkanError("vkBindImageMemory", result);

    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = texture.image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = info.format;
    view.subresourceRange = wholeImage(texture.depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT);
    result = vkCreateImageView(gpu.device, &view, nullptr, &texture.view);
    if (result != VK_SUCCESS) return vulkanError("vkCreateImageView", result);
    setName(gpu, VK_OBJECT_TYPE_IMAGE_VIEW, texture.view, name);
    return {};
}

void destroy(const Gpu& gpu, NeutralTexture& texture) {
    vkDestroyImageView(gpu.device, texture.view, nullptr);
    vkDestroyImage(gpu.device, texture.image, nullptr);
    vkFreeMemory(gpu.device, texture.memory, nullptr);
    texture = {};
}

void recordFill(VkCommandBuffer commands, const NeutralTexture& texture) {
    const VkImageAspectFlags aspect = texture.depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    const VkImageSubresourceRange range = wholeImage(aspect);
    // An earlier draw may still read it.
    VkImageMemoryBarrier2 barrier = imageBarrier(texture.image, aspect);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    recordBarrier(commands, barrier);
    if (texture.depth) {
        const VkClearDepthStencilValue nothing{0.0f, 0};
        vkCmdClearDepthStencilImage(commands, texture.image, barrier.newLayout, &nothing, 1, &range);
    } else {
        const VkClearColorValue white{{1.0f, 1.0f, 1.0f, 1.0f}};
        vkCmdClearColorImage(commands, texture.image, barrier.newLayout, &white, 1, &range);
    }
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    recordBarrier(commands, barrier);
}

}  // namespace

Result<const NeutralTexture*> neutralTexture(const Gpu& gpu, NeutralTextures& textures, Neutral which,
                                             std::uint64_t& created) {
    NeutralTexture& texture = textures.textures[static_cast<std::size_t>(which)];
    if (texture.view) return &texture;
    texture.depth = which == Neutral::NoShadow;
    if (auto made = create(gpu, texture); !made) {
        destroy(gpu, texture);
        return tl::unexpected(made.error());
    }
    ++created;
    return &texture;
}

void recordNeutralFill(VkCommandBuffer commands, const NeutralTextures& textures) {
    for (const NeutralTexture& texture : textures.textures)
        if (texture.view) recordFill(commands, texture);
}

void destroyNeutralTextures(const Gpu& gpu, NeutralTextures& textures) {
    for (NeutralTexture& texture : textures.textures) destroy(gpu, texture);
}

}  // namespace tyndall
