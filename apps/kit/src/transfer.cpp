#include <headless/buffer.h>
#include <headless/commands.h>
#include <headless/image.h>

namespace headless {
namespace {

VkBufferImageCopy wholeImage(const Image& image) {
    VkBufferImageCopy copy{};
    copy.imageSubresource = {image.aspect(), 0, 0, 1};
    copy.imageExtent = {image.extent().width, image.extent().height, 1};
    return copy;
}

Result<std::size_t> imageBytes(const Image& image) {
    const std::uint32_t texel = texelBytes(image.format());
    if (texel == 0)
        return tl::unexpected(Error{
            ErrorCode::InvalidArgument,
            "image format " + std::to_string(image.format()) + " (as VkFormat) cannot be copied texel by texel here",
            VK_SUCCESS});
    return std::size_t{image.extent().width} * image.extent().height * texel;
}

}  // namespace

Result<void> upload(const Device& device, const Image& image, std::span<const std::byte> texels, VkImageLayout layout) {
    const auto expected = imageBytes(image);
    if (!expected) return tl::unexpected(expected.error());
    if (texels.size() != *expected)
        return tl::unexpected(Error{
            ErrorCode::InvalidArgument,
            "the image takes " + std::to_string(*expected) + " bytes, " + std::to_string(texels.size()) + " were given",
            VK_SUCCESS});
    auto staging = Buffer::create(device, texels, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "upload");
    if (!staging) return tl::unexpected(staging.error());
    auto done = submitAndWait(device, [&](VkCommandBuffer commands) {
        transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
        const VkBufferImageCopy copy = wholeImage(image);
        vkCmdCopyBufferToImage(commands, staging->handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                               &copy);
        transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, layout);
    });
    if (!done) return tl::unexpected(done.error());
    return {};
}

Result<std::vector<std::byte>> readback(const Device& device, const Image& image, VkImageLayout layout) {
    const auto size = imageBytes(image);
    if (!size) return tl::unexpected(size.error());
    auto staging = Buffer::create(device, *size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, MemoryKind::Host, "readback");
    if (!staging) return tl::unexpected(staging.error());
    auto done = submitAndWait(device, [&](VkCommandBuffer commands) {
        transition(commands, image, layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        const VkBufferImageCopy copy = wholeImage(image);
        vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging->handle(), 1,
                               &copy);
        transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, layout);
        // The fence does not make the copy visible to the host; this barrier does.
        VkMemoryBarrier2 toHost{};
        toHost.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
        toHost.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
        toHost.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
        toHost.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
        toHost.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
        VkDependencyInfo dependency{};
        dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
        dependency.memoryBarrierCount = 1;
        dependency.pMemoryBarriers = &toHost;
        vkCmdPipelineBarrier2(commands, &dependency);
    });
    if (!done) return tl::unexpected(done.error());
    return std::vector<std::byte>(staging->mapped().begin(), staging->mapped().end());
}

}  // namespace headless
