#include <tyndall/pass_pipelines.h>

#include "frame_data.h"
#include "neutral_textures.h"
#include "pipelines.h"

namespace tyndall {

struct PassPipelines::Impl {
    Gpu gpu;
    const permgen::Effect* effect = nullptr;
    PipelineStore store;
    NeutralTextures textures;
    FrameData::Impl zeros;  ///< the uniform block for those that no pass reads
    StandIns standIns;
    std::uint64_t pipelinesCreated = 0, texturesCreated = 0;

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        destroyPipelines(gpu, store);
        destroyNeutralTextures(gpu, textures);
    }
};

namespace {

Result<VkDescriptorBufferInfo> zeros(PassPipelines::Impl& impl, std::uint32_t size) {
    // Offsets of storage buffers have a stricter alignment: 256 is the most that a device may ask for (Vulkan 1.3,
    // table 52).
    constexpr VkDeviceSize alignment = 256;
    const auto range = place(impl.zeros, std::vector<std::byte>(size + alignment));
    if (!range) return tl::unexpected(range.error());
    return VkDescriptorBufferInfo{range->buffer, (range->offset + alignment - 1) / alignment * alignment, size};
}

Result<void> makeStandIn(PassPipelines::Impl& impl, const permgen::Resource& resource) {
    if (resource.kind == permgen::ResourceKind::StorageImage) {
        const auto texture =
            neutralStorage(impl.gpu, impl.textures, resource.format, resource.dimension, impl.texturesCreated);
        if (!texture) return tl::unexpected(texture.error());
        impl.standIns.storageImages[{resource.format, resource.dimension}] = (*texture)->view;
        return {};
    }
    if (resource.kind == permgen::ResourceKind::CombinedImageSampler) {
        VkImageView& view = impl.standIns.images[static_cast<std::size_t>(resource.dimension)];
        if (view) return {};
        const auto texture =
            neutralTexture(impl.gpu, impl.textures, whiteTexture(resource.dimension), impl.texturesCreated);
        if (!texture) return tl::unexpected(texture.error());
        view = (*texture)->view;
        return {};
    }
    VkDescriptorBufferInfo& standIn =
        resource.kind == permgen::ResourceKind::StorageBuffer ? impl.standIns.storageBuffer : impl.standIns.buffer;
    if (standIn.range >= resource.size) return {};
    const auto range = zeros(impl, resource.size);
    if (!range) return tl::unexpected(range.error());
    standIn = *range;
    return {};
}

/// Makes what `pipeline` binds and does not read.
Result<PassPipeline> withStandIns(PassPipelines::Impl& impl, const permgen::Pass& pass, Result<PassPipeline> pipeline) {
    if (!pipeline) return pipeline;
    for (const permgen::Resource* resource : pipeline->layout->bound)
        if (!permgen::is_live(pass, resource->name))
            if (auto made = makeStandIn(impl, *resource); !made) return tl::unexpected(made.error());
    return pipeline;
}

}  // namespace

bool reads(const PassPipeline& pipeline, std::string_view resource) {
    return permgen::is_live(*pipeline.layout->pass, resource);
}

PassPipelines::PassPipelines(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PassPipelines::PassPipelines(PassPipelines&&) noexcept = default;
PassPipelines& PassPipelines::operator=(PassPipelines&&) noexcept = default;
PassPipelines::~PassPipelines() = default;

Result<PassPipelines> PassPipelines::create(const DeviceContext& context, const permgen::Effect& effect) {
    const auto gpu = inspect(context);
    if (!gpu) return tl::unexpected(gpu.error());
    auto impl = std::make_unique<Impl>();
    impl->gpu = impl->zeros.gpu = *gpu;
    impl->effect = &effect;
    return PassPipelines(std::move(impl));
}

Result<PassPipeline> PassPipelines::get(const permgen::Pass& pass, const PassTarget& target,
                                        std::span<const VertexElement> elements) {
    Impl& impl = *impl_;
    return withStandIns(impl, pass,
                        pipelineFor(impl.gpu, impl.store, {impl.effect, &pass, impl.gpu.shaders, target, elements},
                                    impl.pipelinesCreated));
}

Result<PassPipeline> PassPipelines::get(const permgen::Pass& pass) {
    Impl& impl = *impl_;
    return withStandIns(
        impl, pass,
        computePipelineFor(impl.gpu, impl.store, *impl.effect, pass, impl.gpu.shaders, impl.pipelinesCreated));
}

void PassPipelines::recordNeutralResources(VkCommandBuffer commands) const {
    recordNeutralFill(commands, impl_->textures);
}

Result<std::uint32_t> PassPipelines::push(VkCommandBuffer commands, const PassPipeline& pipeline,
                                          std::span<const NamedBuffer> buffers,
                                          std::span<const NamedImage> images) const {
    return pushResources(impl_->gpu, commands, *pipeline.layout, buffers, images, impl_->standIns);
}

std::size_t PassPipelines::count() const {
    return impl_->pipelinesCreated;
}

}  // namespace tyndall
