// Adds a group's lights up in the accumulation target: slices and rays that are drawn, then rays that are computed.
#include <tyndall/barriers.h>
#include <tyndall/rendering.h>

#include <algorithm>

#include "compute_rays.h"
#include "effect_contract.h"
#include "renderer_pipelines.h"

namespace tyndall {
namespace {

struct LightSampler {
    std::string_view name;
    VkImageView LightTextures::*view;
    Neutral neutral;
};

constexpr std::array<LightSampler, 4> lightSamplers{{
    {"CookieSampler", &LightTextures::cookie, Neutral::White},
    {"ScrollingNoiseSampler", &LightTextures::noise, Neutral::White},
    {"ShadowMapSampler", &LightTextures::shadowMap, Neutral::NoShadow},
    {"ShadowHierarchySampler", &LightTextures::shadowHierarchy, Neutral::NoShadow},
}};

Result<void> checkPart(const Plan& plan, const PlannedPart& part, std::size_t textures) {
    if (part.light >= plan.lights.size() || !plan.lights[part.light].drawn)
        return invalidArgument("a part of the plan names light " + std::to_string(part.light) +
                               ", which it does not draw; use the plan as plan() made it");
    const PlannedLight& light = plan.lights[part.light];
    if (light.light >= textures)
        return invalidArgument("light " + std::to_string(light.light) + " has no entry in textures; give one for " +
                               "each light that was planned");
    if (part.constants >= (part.method == Method::Raycast ? plan.raycasts.size() : plan.constants.size()))
        return invalidArgument("light " + std::to_string(light.light) +
                               " uses constants that the plan does not have; use the plan as plan() made it");
    if (std::size_t{part.firstIndex} + part.indexCount > plan.indices.size())
        return invalidArgument("light " + std::to_string(light.light) +
                               " uses indices that the plan does not have; use the plan as plan() made it");
    return {};
}

/// What raycast.fx reads of the caller's images.
Result<RaycastConstants> withImages(const Plan& plan, const PlannedPart& part, const LightTextures& given,
                                    const ShaftTargets& targets) {
    const auto sizeOf = [](VkImageView view, VkExtent2D size) { return view ? size : VkExtent2D{1, 1}; };
    const VkExtent2D cookie = sizeOf(given.cookie, given.cookieSize), noise = sizeOf(given.noise, given.noiseSize);
    const std::string whose = "light " + std::to_string(plan.lights[part.light].light) + ", drawn by raycast, ";
    if ((part.terms.contains(Term::Cookie) && cookie.width * cookie.height == 0) ||
        (part.terms.contains(Term::Noise) && noise.width * noise.height == 0))
        return invalidArgument(whose + "has a texture of unknown size; give cookieSize and noiseSize with the views");
    if (part.terms.contains(Term::Shadow) && given.shadowMap && !given.shadowHierarchy)
        return invalidArgument(whose +
                               "has a shadow map without a hierarchy; record one with recordShadowHierarchy() and "
                               "give its view");
    RaycastConstants constants = plan.raycasts[part.constants];
    constants.texels = glm::uvec4(cookie.width, cookie.height, noise.width, noise.height);
    constants.pixel.x = 2.0f / static_cast<float>(targets.extent.width);
    constants.pixel.y = 2.0f / static_cast<float>(targets.extent.height);
    constants.surface.z = targets.depth ? 1.0f : 0.0f;
    return constants;
}

/// The part's uniform block. Sets the draw's threads if it is computed.
Result<FrameRange> constantsOf(Renderer::Impl& impl, FrameData::Impl& frame, const Plan& plan, const PlannedPart& part,
                               const LightTextures& given, const ShaftTargets& targets,
                               Renderer::Impl::PartDraw& draw) {
    if (part.method == Method::Slices) return frame.plan.constants[part.constants];
    const auto constants = withImages(plan, part, given, targets);
    if (!constants) return tl::unexpected(constants.error());
    if (!draw.computed) return placeValue(frame, *constants, impl.counters);
    const glm::vec4 tile = tileOf(plan, part, targets.extent);
    draw.threads = {static_cast<std::uint32_t>(tile.z - tile.x), static_cast<std::uint32_t>(tile.w - tile.y)};
    return placeValue(frame, ComputedRays{*constants, tile}, impl.counters);
}

/// Fills impl.draws. `neutral` becomes true if a light lacks a texture that its technique reads.
Result<void> resolve(Renderer::Impl& impl, FrameData::Impl& frame, const Plan& plan, std::span<const PlannedPart> parts,
                     std::span<const LightTextures> textures, const ShaftTargets& targets, bool& neutral) {
    const PassTarget target = accumulationTarget(
        plan.accumulation, targets.depth ? targets.depthFormat : VK_FORMAT_UNDEFINED, targets.depthCompare);
    impl.draws.clear();
    TermSet terms;  // of the previous part: parts are sorted by technique
    Method method = Method::Slices;
    PassPipeline pipeline;
    for (const PlannedPart& part : parts) {
        if (auto checked = checkPart(plan, part, textures.size()); !checked) return checked;
        if (part.terms != terms || part.method != method || !pipeline.handle) {
            const auto made =
                isComputed(part.method, plan.accumulation, targets.storage)
                    ? raysPipeline(impl, plan.accumulation, part.terms)
                    : pipelineFor(impl.gpu, impl.pipelines, shaftPipeline(impl, part.method, part.terms, target),
                                  impl.counters.pipelinesCreated);
            if (!made) return tl::unexpected(made.error());
            pipeline = *made;
            terms = part.terms;
            method = part.method;
        }
        const LightTextures& given = textures[plan.lights[part.light].light];
        Renderer::Impl::PartDraw draw;
        draw.part = &part;
        draw.pipeline = pipeline;
        draw.computed = isComputed(part.method, plan.accumulation, targets.storage);
        const auto constants = constantsOf(impl, frame, plan, part, given, targets, draw);
        if (!constants) return tl::unexpected(constants.error());
        draw.constants = *constants;
        draw.constantsSize = draw.computed                    ? sizeof(ComputedRays)
                             : part.method == Method::Raycast ? sizeof(RaycastConstants)
                                                              : sizeof(SliceConstants);
        NamedImage& depth = draw.images[lightSamplers.size()];
        depth = {"SceneDepthSampler", targets.depth, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL};
        draw.images.back() = {plan.accumulation == Accumulation::Rgba16f ? "HalfTarget" : "FloatTarget",
                              targets.accumulationView, VK_IMAGE_LAYOUT_GENERAL};
        for (std::size_t i = 0; i < lightSamplers.size(); ++i) {
            const LightSampler& sampler = lightSamplers[i];
            draw.images[i] = {sampler.name, given.*sampler.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            if (draw.images[i].view || !binds(*pipeline.layout, sampler.name)) continue;
            const auto texture =
                neutralTexture(impl.gpu, impl.neutral, sampler.neutral, impl.counters.neutralTexturesCreated);
            if (!texture) return tl::unexpected(texture.error());
            draw.images[i].view = (*texture)->view;
            neutral = true;
        }
        if (!targets.depth && binds(*pipeline.layout, "SceneDepthSampler")) {
            const auto texture =
                neutralTexture(impl.gpu, impl.neutral, Neutral::NoShadow, impl.counters.neutralTexturesCreated);
            if (!texture) return tl::unexpected(texture.error());
            depth = {"SceneDepthSampler", (*texture)->view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            neutral = true;
        }
        impl.draws.push_back(draw);
    }
    return {};
}

void beginAccumulation(VkCommandBuffer commands, const ShaftTargets& targets) {
    // The previous group's composite may still read the image, and an earlier frame's pass may still write it.
    VkImageMemoryBarrier2 barrier = imageBarrier(targets.accumulation, VK_IMAGE_ASPECT_COLOR_BIT);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    if (targets.storage) {
        barrier.srcStageMask |= VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
        barrier.srcAccessMask |= VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    }
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    recordBarrier(commands, barrier);

    const VkRenderingAttachmentInfo colour =
        attachment(targets.accumulationView, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
    VkRenderingAttachmentInfo depth =
        attachment(targets.depth, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL, VK_ATTACHMENT_LOAD_OP_LOAD);
    depth.storeOp = VK_ATTACHMENT_STORE_OP_NONE;  // STORE would count as a write
    beginRendering(commands, targets.extent, {&colour, 1}, targets.depth ? &depth : nullptr);
}

/// `computes`: rays are still to be added.
void endAccumulation(VkCommandBuffer commands, const ShaftTargets& targets, bool computes) {
    vkCmdEndRendering(commands);
    if (computes) return;
    VkImageMemoryBarrier2 barrier = imageBarrier(targets.accumulation, VK_IMAGE_ASPECT_COLOR_BIT);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    recordBarrier(commands, barrier);
}

/// With resolved images, the only possible error is a new resource in an effect.
Result<void> drawLights(Renderer::Impl& impl, VkCommandBuffer commands) {
    VkPipeline bound = VK_NULL_HANDLE;
    for (const Renderer::Impl::PartDraw& draw : impl.draws) {
        if (draw.computed) continue;
        if (draw.pipeline.handle != bound) {
            bound = draw.pipeline.handle;
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, bound);
        }
        const NamedBuffer block{globalsBlock, {draw.constants.buffer, draw.constants.offset, draw.constantsSize}};
        const auto pushed = pushResources(impl.gpu, commands, *draw.pipeline.layout, std::span(&block, 1), draw.images);
        if (!pushed) return tl::unexpected(pushed.error());
        vkCmdDrawIndexed(commands, draw.part->indexCount, 1, draw.part->firstIndex, 0, 0);
        ++impl.counters.draws;
        impl.counters.descriptorsPushed += *pushed;
        impl.counters.slicesDrawn += static_cast<std::uint64_t>(draw.part->slices);
    }
    return {};
}

}  // namespace

Result<void> Renderer::recordAccumulation(VkCommandBuffer commands, FrameData& frame, const Plan& plan,
                                          std::size_t group, std::span<const LightTextures> textures,
                                          const ShaftTargets& targets) {
    const auto data = useFrame(impl_->gpu, frame.impl_.get());
    if (!data) return tl::unexpected(data.error());
    if (auto checked = checkRecording(**data, plan, group, targets); !checked) return checked;
    const UploadedPlan& uploaded = (*data)->plan;

    bool neutral = false;
    const CompositeGroup& planned = plan.groups[group];
    const auto parts = std::span(plan.parts).subspan(planned.firstPart, planned.parts);
    if (auto resolved = resolve(*impl_, **data, plan, parts, textures, targets, neutral); !resolved) return resolved;

    if (neutral) recordNeutralFill(commands, impl_->neutral);
    beginAccumulation(commands, targets);
    bindVertices(commands, uploaded.vertices.buffer, uploaded.vertices.offset, sizeof(SliceVertex));
    vkCmdBindIndexBuffer(commands, uploaded.indices.buffer, uploaded.indices.offset, VK_INDEX_TYPE_UINT32);
    auto drawn = drawLights(*impl_, commands);
    const bool computes = std::ranges::any_of(impl_->draws, &Renderer::Impl::PartDraw::computed);
    endAccumulation(commands, targets, computes);
    if (drawn && computes) return computeRays(*impl_, commands, targets);
    return drawn;
}

}  // namespace tyndall
