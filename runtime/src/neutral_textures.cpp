#include "neutral_textures.h"

#include <tyndall/barriers.h>
#include <tyndall/image_format.h>

namespace tyndall {
namespace {

constexpr VkFormat colourFormat = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkFormat depthFormat = VK_FORMAT_D16_UNORM;  // every device can sample it
constexpr VkPipelineStageFlags2 readers =
    VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;

struct Shape {
    VkImageType image;
    VkImageViewType view;
    std::uint32_t layers;
    const char* name;
};

constexpr std::array<Shape, 5> shapes{{
    {VK_IMAGE_TYPE_2D, VK_IMAGE_VIEW_TYPE_2D, 1, "tyndall white texture"},
    {VK_IMAGE_TYPE_2D, VK_IMAGE_VIEW_TYPE_2D, 1, "tyndall empty shadow map"},
    {VK_IMAGE_TYPE_1D, VK_IMAGE_VIEW_TYPE_1D, 1, "tyndall white 1D texture"},
    {VK_IMAGE_TYPE_3D, VK_IMAGE_VIEW_TYPE_3D, 1, "tyndall white 3D texture"},
    {VK_IMAGE_TYPE_2D, VK_IMAGE_VIEW_TYPE_CUBE, 6, "tyndall white cube texture"},
}};

Result<void> create(const Gpu& gpu, NeutralTexture& texture, const Shape& shape, VkFormat format,
                    VkImageUsageFlags usage) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.flags = shape.view == VK_IMAGE_VIEW_TYPE_CUBE ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0;
    info.imageType = shape.image;
    info.format = format;
    info.extent = {1, 1, 1};
    info.mipLevels = 1;
    info.arrayLayers = shape.layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    VkResult result = vkCreateImage(gpu.device, &info, nullptr, &texture.image);
    if (result != VK_SUCCESS) return vulkanError("vkCreateImage", result);
    setName(gpu, VK_OBJECT_TYPE_IMAGE, texture.image, shape.name);

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
    setName(gpu, VK_OBJECT_TYPE_DEVICE_MEMORY, texture.memory, shape.name);
    result = vkBindImageMemory(gpu.device, texture.image, texture.memory, 0);
    if (result != VK_SUCCESS) return vulkanError("vkBindImageMemory", result);

    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = texture.image;
    view.viewType = shape.view;
    view.format = info.format;
    view.subresourceRange = wholeImage(format == depthFormat ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT);
    result = vkCreateImageView(gpu.device, &view, nullptr, &texture.view);
    if (result != VK_SUCCESS) return vulkanError("vkCreateImageView", result);
    setName(gpu, VK_OBJECT_TYPE_IMAGE_VIEW, texture.view, shape.name);
    return {};
}

void destroy(const Gpu& gpu, NeutralTexture& texture) {
    vkDestroyImageView(gpu.device, texture.view, nullptr);
    vkDestroyImage(gpu.device, texture.image, nullptr);
    vkFreeMemory(gpu.device, texture.memory, nullptr);
    texture = {};
}

void recordFill(VkCommandBuffer commands, const NeutralTexture& texture, bool depth) {
    const VkImageAspectFlags aspect = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    const VkImageSubresourceRange range = wholeImage(aspect);
    // An earlier draw or dispatch may still read it.
    VkImageMemoryBarrier2 barrier = imageBarrier(texture.image, aspect);
    barrier.srcStageMask = readers | VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    recordBarrier(commands, barrier);
    if (depth) {
        const VkClearDepthStencilValue nothing{0.0f, 0};
        vkCmdClearDepthStencilImage(commands, texture.image, barrier.newLayout, &nothing, 1, &range);
    } else {
        const VkClearColorValue white{{1.0f, 1.0f, 1.0f, 1.0f}};
        vkCmdClearColorImage(commands, texture.image, barrier.newLayout, &white, 1, &range);
    }
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_CLEAR_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.dstStageMask = readers;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    recordBarrier(commands, barrier);
}

}  // namespace

Neutral whiteTexture(permgen::ImageDimension dimension) {
    switch (dimension) {
        case permgen::ImageDimension::One:
            return Neutral::White1d;
        case permgen::ImageDimension::Three:
            return Neutral::White3d;
        case permgen::ImageDimension::Cube:
            return Neutral::WhiteCube;
        case permgen::ImageDimension::None:
        case permgen::ImageDimension::Two:
            break;
    }
    return Neutral::White;
}

Result<const NeutralTexture*> neutralTexture(const Gpu& gpu, NeutralTextures& textures, Neutral which,
                                             std::uint64_t& created) {
    NeutralTexture& texture = textures.textures[static_cast<std::size_t>(which)];
    if (texture.view) return &texture;
    const Shape& shape = shapes[static_cast<std::size_t>(which)];
    const VkFormat format = which == Neutral::NoShadow ? depthFormat : colourFormat;
    if (auto made = create(gpu, texture, shape, format, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
        !made) {
        destroy(gpu, texture);
        return tl::unexpected(made.error());
    }
    ++created;
    return &texture;
}

Result<const NeutralTexture*> neutralStorage(const Gpu& gpu, NeutralTextures& textures, permgen::ImageFormat format,
                                             permgen::ImageDimension dimension, std::uint64_t& created) {
    NeutralTexture& texture = textures.storage[{format, dimension}];
    if (texture.view) return &texture;
    Shape shape = shapes[static_cast<std::size_t>(whiteTexture(dimension))];
    shape.name = "tyndall storage image";
    if (auto made = create(gpu, texture, shape, vulkanFormat(format), VK_IMAGE_USAGE_STORAGE_BIT); !made) {
        destroy(gpu, texture);
        return tl::unexpected(made.error());
    }
    ++created;
    return &texture;
}

void recordNeutralFill(VkCommandBuffer commands, const NeutralTextures& textures) {
    for (std::size_t i = 0; i < textures.textures.size(); ++i)
        if (textures.textures[i].view)
            recordFill(commands, textures.textures[i], i == static_cast<std::size_t>(Neutral::NoShadow));
    for (const auto& [key, texture] : textures.storage) {
        if (!texture.view) continue;
        VkImageMemoryBarrier2 barrier = imageBarrier(texture.image, VK_IMAGE_ASPECT_COLOR_BIT);
        // No shader reads or writes it, but synchronization validation counts the binding as both.
        barrier.srcStageMask = barrier.dstStageMask = readers;
        barrier.srcAccessMask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
        barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
        barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
        recordBarrier(commands, barrier);
    }
}

void destroyNeutralTextures(const Gpu& gpu, NeutralTextures& textures) {
    for (NeutralTexture& texture : textures.textures) destroy(gpu, texture);
    for (auto& [key, texture] : textures.storage) destroy(gpu, texture);
    textures.storage.clear();
}

}  // namespace tyndall
