#include "compute_rays.h"

#include <tyndall/barriers.h>

#include <algorithm>
#include <cmath>

#include "effect_contract.h"
#include "effects.h"

namespace tyndall {
namespace {

namespace rays = effects::raycast_compute;

const permgen::Pass& passOf(Accumulation accumulation, TermSet terms) {
    return rays::technique(*rays::find_technique({.bHalf = accumulation == Accumulation::Rgba16f,
                                                  .bScrollingNoise = terms.contains(Term::Noise),
                                                  .bShadowMapping = terms.contains(Term::Shadow),
                                                  .bCookie = terms.contains(Term::Cookie),
                                                  .bScattering = terms.contains(Term::Scattering)}))
        .passes[0];
}

/// Each part adds to what the one before it wrote.
void waitForPart(VkCommandBuffer commands) {
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    recordBarrier(commands, barrier);
}

}  // namespace

bool isComputed(Method method, Accumulation accumulation, bool storage) {
    return method == Method::Raycast && storage &&
           (accumulation == Accumulation::Rgba16f || accumulation == Accumulation::Rgba32f);
}

Result<PassPipeline> raysPipeline(Renderer::Impl& impl, Accumulation accumulation, TermSet terms) {
    // Frozen: the shared module would want both formats of the image bound.
    return computePipelineFor(impl.gpu, impl.pipelines, rays::effect, passOf(accumulation, terms), Shaders::Frozen,
                              impl.counters.pipelinesCreated);
}

glm::vec4 tileOf(const Plan& plan, const PlannedPart& part, VkExtent2D extent) {
    const glm::vec2 size(extent.width, extent.height);
    glm::vec2 first(size), end(0.0f);
    for (std::uint32_t i = part.firstIndex; i < part.firstIndex + part.indexCount; ++i) {
        const glm::vec2 pixel = (0.5f * glm::vec2(plan.vertices[plan.indices[i]].position) + 0.5f) * size;
        first = glm::min(first, glm::floor(pixel));
        end = glm::max(end, glm::ceil(pixel));
    }
    return {glm::max(first, glm::vec2(0.0f)), glm::min(end, size)};
}

Result<void> computeRays(Renderer::Impl& impl, VkCommandBuffer commands, const ShaftTargets& targets) {
    VkImageMemoryBarrier2 barrier = imageBarrier(targets.accumulation, VK_IMAGE_ASPECT_COLOR_BIT);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    recordBarrier(commands, barrier);

    Result<void> done;
    bool first = true;
    for (const Renderer::Impl::PartDraw& draw : impl.draws) {
        if (!draw.computed || !done) continue;
        if (!first) waitForPart(commands);
        first = false;
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, draw.pipeline.handle);
        const NamedBuffer block{globalsBlock, {draw.constants.buffer, draw.constants.offset, draw.constantsSize}};
        const auto pushed = pushResources(impl.gpu, commands, *draw.pipeline.layout, std::span(&block, 1), draw.images);
        if (!pushed) {
            done = tl::unexpected(pushed.error());
            continue;
        }
        const auto groups = groupCounts(*draw.pipeline.layout->pass, {draw.threads.width, draw.threads.height, 1});
        vkCmdDispatch(commands, groups[0], groups[1], groups[2]);
        ++impl.counters.draws;
        impl.counters.descriptorsPushed += *pushed;
    }

    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    recordBarrier(commands, barrier);
    return done;
}

}  // namespace tyndall
