// Draws a light's shadow map: depth only.
#include <tyndall/renderer.h>
#include <tyndall/rendering.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "effect_contract.h"
#include "renderer_pipelines.h"

namespace tyndall {
namespace {

Result<void> checkShadowMap(const Light& light, std::span<const Occluder> occluders, VkImageView map,
                            std::uint32_t size) {
    const std::string whose = "the shadow map of light '" + light.name + "'";
    if (!map) return invalidArgument(whose + " has no view; give a depth view to draw to");
    if (size == 0) return invalidArgument(whose + " is 0 texels wide; give it at least one");
    const auto isAngle = [](double angle) { return angle > 0.0 && angle < std::numbers::pi; };
    if (!isAngle(light.fov.x) || !isAngle(light.fov.y))
        return invalidArgument(whose + " needs a field of view above 0 and below 180 degrees both ways");
    if (!(light.nearPlane > 0.0) || !(light.farPlane > light.nearPlane) || !std::isfinite(light.farPlane))
        return invalidArgument(whose + " needs 0 < near < far, both finite");
    for (const Occluder& occluder : occluders) {
        if (occluder.indexCount == 0) continue;
        if (!occluder.vertices || !occluder.indices)
            return invalidArgument("an occluder in " + whose + " has no vertex or index buffer; give both");
        if (occluder.vertexStride < 12 || occluder.vertexStride % 4 != 0)
            return invalidArgument("an occluder in " + whose + " has vertices " +
                                   std::to_string(occluder.vertexStride) +
                                   " bytes apart; they must be 12 or more, in steps of 4");
    }
    return {};
}

/// Handles that cannot be dispatched are pointers on some platforms and integers on others.
std::uint64_t number(VkBuffer buffer) {
    return std::bit_cast<std::uint64_t>(buffer);
}

}  // namespace

ShadowCaster shadowCaster(const Occluder& occluder) {
    if (occluder.indexCount == 0) return {occluder.worldFromMesh, {}};
    return {occluder.worldFromMesh,
            {number(occluder.vertices), occluder.vertexOffset, occluder.vertexStride, number(occluder.indices),
             occluder.indexOffset, occluder.indexCount}};
}

Result<void> Renderer::recordShadowMap(VkCommandBuffer commands, FrameData& frame, const Light& light,
                                       std::span<const Occluder> occluders, VkImageView map, VkFormat format,
                                       std::uint32_t size) {
    const auto data = useFrame(impl_->gpu, frame.impl_.get());
    if (!data) return tl::unexpected(data.error());
    if (auto checked = checkShadowMap(light, occluders, map, size); !checked) return checked;
    RendererCounters& counters = impl_->counters;
    const auto pipeline =
        pipelineFor(impl_->gpu, impl_->pipelines, shadowMapPipeline(*impl_, format), counters.pipelinesCreated);
    if (!pipeline) return tl::unexpected(pipeline.error());

    // Cleared to 0, the far plane: depth is reversed.
    const VkRenderingAttachmentInfo depth =
        attachment(map, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
    beginRendering(commands, {size, size}, {}, &depth);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle);

    const glm::dmat4 clipFromWorld = lightClipFromWorld(light);
    Result<void> drawn;
    for (const Occluder& occluder : occluders) {
        if (occluder.indexCount == 0) continue;
        const glm::mat4 clipFromMesh(clipFromWorld * occluder.worldFromMesh);
        const auto constants = placeValue(**data, clipFromMesh, counters);
        const auto pushed = constants.and_then([&](const FrameRange& range) {
            const NamedBuffer block{globalsBlock, {range.buffer, range.offset, sizeof clipFromMesh}};
            return pushResources(impl_->gpu, commands, *pipeline->layout, std::span(&block, 1), {});
        });
        if (!pushed) {
            drawn = tl::unexpected(pushed.error());
            break;
        }
        bindVertices(commands, occluder.vertices, occluder.vertexOffset, occluder.vertexStride);
        vkCmdBindIndexBuffer(commands, occluder.indices, occluder.indexOffset, VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexed(commands, occluder.indexCount, 1, 0, 0, 0);
        ++counters.draws;
        counters.descriptorsPushed += *pushed;
    }
    vkCmdEndRendering(commands);
    ++counters.shadowMapsDrawn;
    return drawn;
}

}  // namespace tyndall
