// Draws the levels of a shadow hierarchy, each from the one before.
#include <tyndall/barriers.h>
#include <tyndall/renderer.h>
#include <tyndall/rendering.h>

#include "composite_data.h"
#include "effect_contract.h"
#include "renderer_pipelines.h"

namespace tyndall {
namespace {

Result<void> checkHierarchy(VkImageView map, std::uint32_t size, const ShadowHierarchy& hierarchy) {
    if (!map) return invalidArgument("a shadow hierarchy has no map to read; give the shadow map's view");
    if (size == 0) return invalidArgument("the shadow map of a hierarchy is 0 texels wide; give its size");
    if (!hierarchy.image || hierarchy.levels.size() != shadowHierarchyLevels(size))
        return invalidArgument("the hierarchy of a shadow map of " + std::to_string(size) + " texels has " +
                               std::to_string(hierarchy.levels.size()) + " levels; make an image of " +
                               std::to_string(shadowHierarchySide(size)) + " texels a side with " +
                               std::to_string(shadowHierarchyLevels(size)) + " levels, and give a view of each");
    for (const VkImageView level : hierarchy.levels)
        if (!level) return invalidArgument("a level of a shadow hierarchy has no view; give a view of each level");
    return {};
}

VkImageMemoryBarrier2 levelBarrier(VkImage image, std::uint32_t level, std::uint32_t levels) {
    VkImageMemoryBarrier2 barrier = imageBarrier(image, VK_IMAGE_ASPECT_COLOR_BIT);
    barrier.subresourceRange.baseMipLevel = level;
    barrier.subresourceRange.levelCount = levels;
    return barrier;
}

void beginLevels(VkCommandBuffer commands, const ShadowHierarchy& hierarchy) {
    // An earlier frame may still read the hierarchy.
    VkImageMemoryBarrier2 barrier =
        levelBarrier(hierarchy.image, 0, static_cast<std::uint32_t>(hierarchy.levels.size()));
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    recordBarrier(commands, barrier);
}

void finishLevel(VkCommandBuffer commands, VkImage image, std::uint32_t level) {
    VkImageMemoryBarrier2 barrier = levelBarrier(image, level, 1);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    recordBarrier(commands, barrier);
}

}  // namespace

Result<void> Renderer::recordShadowHierarchy(VkCommandBuffer commands, FrameData& frame, VkImageView map,
                                             std::uint32_t size, const ShadowHierarchy& hierarchy) {
    const auto used = useFrame(impl_->gpu, frame.impl_.get());
    if (!used) return tl::unexpected(used.error());
    if (auto checked = checkHierarchy(map, size, hierarchy); !checked) return checked;
    FrameData::Impl& data = **used;
    RendererCounters& counters = impl_->counters;
    const auto triangle = placeValue(data, screenTriangle, counters);
    if (!triangle) return tl::unexpected(triangle.error());

    beginLevels(commands, hierarchy);
    VkImageView source = map;
    std::uint32_t sourceSide = size, side = shadowHierarchySide(size);
    for (std::uint32_t level = 0; level < hierarchy.levels.size(); ++level) {
        const auto pipeline = pipelineFor(impl_->gpu, impl_->pipelines, shadowHierarchyPipeline(*impl_, level == 0),
                                          counters.pipelinesCreated);
        if (!pipeline) return tl::unexpected(pipeline.error());
        const auto constants = placeValue(data, glm::vec4(side, sourceSide, 0.0f, 0.0f), counters);
        if (!constants) return tl::unexpected(constants.error());
        const VkRenderingAttachmentInfo colour = attachment(
            hierarchy.levels[level], VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_DONT_CARE);
        beginRendering(commands, {side, side}, {&colour, 1}, nullptr);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle);
        bindVertices(commands, triangle->buffer, triangle->offset, sizeof(glm::vec2));
        const NamedBuffer block{globalsBlock, {constants->buffer, constants->offset, sizeof(glm::vec4)}};
        const NamedImage image{"SourceSampler", source, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        const auto pushed =
            pushResources(impl_->gpu, commands, *pipeline->layout, std::span(&block, 1), std::span(&image, 1));
        if (pushed) {
            vkCmdDraw(commands, 3, 1, 0, 0);
            ++counters.draws;
            counters.descriptorsPushed += *pushed;
        }
        vkCmdEndRendering(commands);
        if (!pushed) return tl::unexpected(pushed.error());
        finishLevel(commands, hierarchy.image, level);
        source = hierarchy.levels[level];
        sourceSide = side;
        side /= 2;
    }
    ++counters.shadowHierarchiesDrawn;
    return {};
}

}  // namespace tyndall
