#include <tyndall/barriers.h>
#include <tyndall/renderer.h>

#include <algorithm>

#include "composite_data.h"
#include "effect_contract.h"
#include "effects.h"
#include "renderer_impl.h"

namespace tyndall {
namespace {

/// The caller's build of an effect, or the built-in one.
Result<const permgen::Effect*> choose(const permgen::Effect* given, const permgen::Effect& builtIn,
                                      const EffectContract& contract, Shaders shaders) {
    if (!given) return &builtIn;
    if (auto checked = checkEffect(*given, contract, shaders); !checked) return tl::unexpected(checked.error());
    return given;
}

}  // namespace

Renderer::Impl::~Impl() {
    destroyPipelines(gpu, pipelines);
    destroyNeutralTextures(gpu, neutral);
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create(const DeviceContext& context) {
    const auto gpu = inspect(context);
    if (!gpu) return tl::unexpected(gpu.error());
    const auto slices = choose(context.slices, effects::slices::effect, slicesContract(), context.shaders);
    if (!slices) return tl::unexpected(slices.error());
    const auto raycast = choose(context.raycast, effects::raycast::effect, raycastContract(), context.shaders);
    if (!raycast) return tl::unexpected(raycast.error());
    const auto composite = choose(context.composite, effects::composite::effect, compositeContract(), Shaders::Frozen);
    if (!composite) return tl::unexpected(composite.error());
    const auto shadowMap = choose(context.shadowMap, effects::shadow_map::effect, shadowMapContract(), Shaders::Frozen);
    if (!shadowMap) return tl::unexpected(shadowMap.error());
    const auto shadowHierarchy =
        choose(context.shadowHierarchy, effects::shadow_hierarchy::effect, shadowHierarchyContract(), Shaders::Frozen);
    if (!shadowHierarchy) return tl::unexpected(shadowHierarchy.error());
    auto impl = std::make_unique<Impl>();
    impl->gpu = *gpu;
    impl->slices = *slices;
    impl->raycast = *raycast;
    for (const TermSet terms : allTermSets) {  // the contracts name them all
        impl->sliceTechniques[terms.index()] = permgen::find_technique(**slices, techniqueName(terms));
        impl->raycastTechniques[terms.index()] = permgen::find_technique(**raycast, techniqueName(terms));
    }
    impl->composite = *composite;
    impl->shadowMap = *shadowMap;
    impl->shadowHierarchy = *shadowHierarchy;
    return Renderer(std::move(impl));
}

const RendererCounters& Renderer::counters() const {
    return impl_->counters;
}

VkFormat accumulationFormat(Accumulation accumulation) {
    switch (accumulation) {
        case Accumulation::Rgba8:
        case Accumulation::Rgba8Routed:
            return VK_FORMAT_R8G8B8A8_UNORM;
        case Accumulation::Rgba16f:
            return VK_FORMAT_R16G16B16A16_SFLOAT;
        case Accumulation::Rgba32f:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
    }
    return VK_FORMAT_UNDEFINED;
}

Result<FrameData::Impl*> useFrame(const Gpu& gpu, FrameData::Impl* frame) {
    if (!frame) return invalidArgument("the frame data was moved from; make a new FrameData");
    if (!frame->gpu.device) frame->gpu = gpu;
    if (frame->gpu.device != gpu.device)
        return invalidArgument("the frame data belongs to another device; use one FrameData for each device");
    return frame;
}

Result<void> Renderer::upload(FrameData& frame, const Plan& plan) {
    const auto used = useFrame(impl_->gpu, frame.impl_.get());
    if (!used) return tl::unexpected(used.error());
    FrameData::Impl& data = **used;
    if (!plan.indices.empty() && *std::max_element(plan.indices.begin(), plan.indices.end()) >= plan.vertices.size())
        return invalidArgument("an index of the plan points beyond its vertices; use the plan as plan() made it");

    const Gpu& gpu = data.gpu;
    if (plan.groups.empty()) {
        if (auto reset = resetFrame(data, 0); !reset) return reset;
        data.plan = {};
        data.plan.valid = true;
        return {};
    }
    const auto vertices = std::as_bytes(std::span(plan.vertices));
    const auto indices = std::as_bytes(std::span(plan.indices));
    const VkDeviceSize room = frameBytes(gpu, vertices.size()) + frameBytes(gpu, indices.size()) +
                              frameBytes(gpu, sizeof screenTriangle) +
                              plan.constants.size() * frameBytes(gpu, sizeof(SliceConstants)) +
                              plan.raycasts.size() * frameBytes(gpu, sizeof(RaycastConstants)) +
                              plan.groups.size() * frameBytes(gpu, sizeof(CompositeConstants));
    if (auto reset = resetFrame(data, room); !reset) return reset;

    RendererCounters& counters = impl_->counters;
    UploadedPlan& uploaded = data.plan;
    uploaded.vertexCount = plan.vertices.size();
    uploaded.indexCount = plan.indices.size();
    uploaded.constants.resize(plan.constants.size());
    for (std::size_t i = 0; i < plan.constants.size(); ++i) {
        const auto range = placeValue(data, plan.constants[i], counters);
        if (!range) return tl::unexpected(range.error());
        uploaded.constants[i] = *range;
    }
    const auto triangle = placeValue(data, screenTriangle, counters);
    if (!triangle) return tl::unexpected(triangle.error());
    uploaded.screenTriangle = *triangle;
    counters.bytesUploaded += vertices.size() + indices.size();
    const auto placedIndices = place(data, indices);
    if (!placedIndices) return tl::unexpected(placedIndices.error());
    uploaded.indices = *placedIndices;
    const auto placedVertices = place(data, vertices);
    if (!placedVertices) return tl::unexpected(placedVertices.error());
    uploaded.vertices = *placedVertices;
    uploaded.valid = true;
    return {};
}

Result<void> checkRecording(const FrameData::Impl& frame, const Plan& plan, std::size_t group,
                            const ShaftTargets& targets) {
    if (group >= plan.groups.size())
        return invalidArgument("group " + std::to_string(group) + " was asked for, the plan has " +
                               std::to_string(plan.groups.size()) + "; count from 0");
    const UploadedPlan& uploaded = frame.plan;
    const CompositeGroup& asked = plan.groups[group];
    if (std::size_t{asked.firstPart} + asked.parts > plan.parts.size())
        return invalidArgument("a group has parts that the plan does not have; use the plan as plan() made it");
    if (!uploaded.valid || uploaded.vertexCount != plan.vertices.size() || uploaded.indexCount != plan.indices.size() ||
        uploaded.constants.size() != plan.constants.size())
        return invalidArgument("the frame does not hold this plan; call upload() with it first");
    if (targets.extent.width == 0 || targets.extent.height == 0)
        return invalidArgument("the targets are " + std::to_string(targets.extent.width) + "x" +
                               std::to_string(targets.extent.height) + "; each side needs at least one pixel");
    if (!targets.accumulation || !targets.accumulationView)
        return invalidArgument("the targets have no accumulation image; give the image and its view");
    return {};
}

Result<void> Renderer::record(VkCommandBuffer commands, FrameData& frame, const Plan& plan,
                              std::span<const LightTextures> textures, const ShaftTargets& targets) {
    for (std::size_t group = 0; group < plan.groups.size(); ++group) {
        if (auto added = recordAccumulation(commands, frame, plan, group, textures, targets); !added) return added;
        if (auto composited = recordComposite(commands, frame, plan, group, targets); !composited) return composited;
    }
    if (plan.groups.empty() && targets.accumulation) {
        // Nothing to draw, but the image must have the documented layout.
        VkImageMemoryBarrier2 barrier = imageBarrier(targets.accumulation, VK_IMAGE_ASPECT_COLOR_BIT);
        barrier.srcStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
        barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
        barrier.dstStageMask = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
        barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        recordBarrier(commands, barrier);
    }
    return {};
}

void bindVertices(VkCommandBuffer commands, VkBuffer buffer, VkDeviceSize offset, VkDeviceSize stride) {
    vkCmdBindVertexBuffers2(commands, 0, 1, &buffer, &offset, nullptr, &stride);
}

}  // namespace tyndall
