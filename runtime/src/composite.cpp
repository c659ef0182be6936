// Adds an accumulated group to the picture.
#include <tyndall/barriers.h>
#include <tyndall/rendering.h>

#include "composite_data.h"
#include "effect_contract.h"
#include "renderer_pipelines.h"

namespace tyndall {
namespace {

/// The blur uses reversed depth; this converts a depth that is not reversed.
bool isReversed(VkCompareOp compare) {
    return compare != VK_COMPARE_OP_LESS && compare != VK_COMPARE_OP_LESS_OR_EQUAL;
}

CompositeConstants constantsFor(const Plan& plan, const CompositeGroup& group, const ShaftTargets& targets) {
    CompositeConstants constants{};
    constants.tint = glm::vec4(glm::vec3(glm::dvec3(group.tint) / plan.scale), 0.0f);
    constants.texel = {1.0f / static_cast<float>(targets.extent.width),
                       1.0f / static_cast<float>(targets.extent.height), 0.0f, 0.0f};
    constants.depth =
        isReversed(targets.depthCompare) ? glm::vec4(0.0f, 1.0f, 0.0f, 0.0f) : glm::vec4(1.0f, -1.0f, 0.0f, 0.0f);
    return constants;
}

void beginComposite(VkCommandBuffer commands, const ShaftTargets& targets) {
    // The scene's pass, or the previous group's composite, wrote the picture that is blended into.
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    recordBarrier(commands, barrier);

    const VkRenderingAttachmentInfo colour =
        attachment(targets.colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_LOAD);
    beginRendering(commands, targets.extent, {&colour, 1}, nullptr);
}

}  // namespace

Result<void> Renderer::recordComposite(VkCommandBuffer commands, FrameData& frame, const Plan& plan, std::size_t group,
                                       const ShaftTargets& targets) {
    const auto used = useFrame(impl_->gpu, frame.impl_.get());
    if (!used) return tl::unexpected(used.error());
    FrameData::Impl& data = **used;
    if (auto checked = checkRecording(data, plan, group, targets); !checked) return checked;
    if (!targets.colour) return invalidArgument("the targets have no colour view; give one to composite into");
    if (targets.blur && !targets.depth)
        return invalidArgument("the blur needs the scene's depth, which the targets lack; give it or switch blur off");
    if (!(plan.scale > 0.0)) return invalidArgument("the plan's scale is not above 0; use the plan as plan() made it");

    RendererCounters& counters = impl_->counters;
    const auto pipeline = pipelineFor(impl_->gpu, impl_->pipelines,
                                      compositePipeline(*impl_, plan.accumulation, targets.blur, targets.colourFormat),
                                      counters.pipelinesCreated);
    if (!pipeline) return tl::unexpected(pipeline.error());
    const auto constants = placeValue(data, constantsFor(plan, plan.groups[group], targets), counters);
    if (!constants) return tl::unexpected(constants.error());

    const std::array<NamedImage, 2> images{{
        {"AccumulationSampler", targets.accumulationView, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
        {"SceneDepthSampler", targets.depth, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL},
    }};
    beginComposite(commands, targets);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle);
    const FrameRange& triangle = data.plan.screenTriangle;
    bindVertices(commands, triangle.buffer, triangle.offset, sizeof(glm::vec2));
    const NamedBuffer block{globalsBlock, {constants->buffer, constants->offset, sizeof(CompositeConstants)}};
    const auto pushed = pushResources(impl_->gpu, commands, *pipeline->layout, std::span(&block, 1), images);
    if (pushed) {
        vkCmdDraw(commands, 3, 1, 0, 0);
        ++counters.draws;
        counters.descriptorsPushed += *pushed;
    }
    vkCmdEndRendering(commands);
    if (!pushed) return tl::unexpected(pushed.error());
    return {};
}

}  // namespace tyndall
