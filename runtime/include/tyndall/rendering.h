// Begins rendering into attachments.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <span>

namespace tyndall {

/// An attachment that is stored at the end; if `load` clears, it starts at zero.
inline VkRenderingAttachmentInfo attachment(VkImageView view, VkImageLayout layout, VkAttachmentLoadOp load) {
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = view;
    info.imageLayout = layout;
    info.loadOp = load;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    return info;
}

/// Begins rendering over the whole of `extent` and sets viewport and scissor. `depth` may be null.
inline void beginRendering(VkCommandBuffer commands, VkExtent2D extent,
                           std::span<const VkRenderingAttachmentInfo> colours, const VkRenderingAttachmentInfo* depth) {
    VkRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    rendering.renderArea = {{0, 0}, extent};
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(colours.size());
    rendering.pColorAttachments = colours.data();
    rendering.pDepthAttachment = depth;
    vkCmdBeginRendering(commands, &rendering);
    const VkViewport viewport{0.0f, 0.0f, static_cast<float>(extent.width), static_cast<float>(extent.height),
                              0.0f, 1.0f};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
}

}  // namespace tyndall
