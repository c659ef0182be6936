#include "effect_renderer.h"

#include <fmt/format.h>
#include <headless/commands.h>
#include <kit/fail.h>
#include <tyndall/rendering.h>

#include <algorithm>
#include <set>

#include "texels.h"

namespace tyndall::rig {
namespace {

constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

template <class T>
Result<T> plain(Result<T> result) {
    if (!result) return tl::unexpected(result.error());
    if constexpr (std::is_void_v<T>)
        return {};
    else
        return std::move(*result);
}

Result<headless::Image> upload(const headless::Device& device, const Image& texels, std::string_view name) {
    headless::ImageInfo info;
    info.extent = {static_cast<std::uint32_t>(texels.width), static_cast<std::uint32_t>(texels.height)};
    info.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.name = name;
    auto image = plain(headless::Image::create(device, info));
    if (!image) return image;
    if (auto done = headless::upload(device, *image, std::as_bytes(std::span(texels.values))); !done)
        return tl::unexpected(done.error());
    return image;
}

/// The number of render targets that the pass writes, COLOR0 to COLOR3. Direct3D 9 leaves the others unchanged. Vulkan
/// would make them undefined, so they are not bound.
std::uint32_t targetsOf(const permgen::Pass& pass) {
    std::uint32_t count = 0;
    if (pass.pixel.module)
        for (const permgen::Attribute& attribute : pass.pixel.module->attributes)
            if (attribute.semantic.starts_with("COLOR")) count = std::max(count, attribute.location + 1);
    return std::min(count, 4u);
}

std::uint32_t targetsOf(const permgen::Technique& technique) {
    std::uint32_t count = 1;
    for (const permgen::Pass& pass : technique.passes) count = std::max(count, targetsOf(pass));
    return count;
}

/// Rendering into the first `count` of the targets, and into the depth buffer if there is one.
void beginRendering(VkCommandBuffer commands, std::span<const headless::Image> colours, const headless::Image* depth,
                    VkAttachmentLoadOp load, const std::array<float, 4>& clear) {
    std::vector<VkRenderingAttachmentInfo> attachments;
    for (const headless::Image& image : colours) {
        attachments.push_back(attachment(image.view(), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, load));
        std::copy(clear.begin(), clear.end(), attachments.back().clearValue.color.float32);
    }
    VkRenderingAttachmentInfo depthInfo{};
    if (depth) {
        depthInfo = attachment(depth->view(), VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, load);
        depthInfo.clearValue.depthStencil.depth = 1.0f;
    }
    const VkExtent2D extent = depth ? depth->extent() : colours.empty() ? VkExtent2D{1, 1} : colours[0].extent();
    tyndall::beginRendering(commands, extent, attachments, depth ? &depthInfo : nullptr);
}

}  // namespace

struct EffectRenderer::Targets {
    std::vector<headless::Image> colours;
    headless::Image depth;
};

Result<std::unique_ptr<EffectRenderer>> EffectRenderer::create(const headless::Device& device,
                                                               const permgen::Effect& effect, const Fixture& fixture) {
    std::unique_ptr<EffectRenderer> renderer(new EffectRenderer(device, effect, fixture));
    for (const auto step : {&EffectRenderer::makeBlocks, &EffectRenderer::makeTextures, &EffectRenderer::makeGeometry,
                            &EffectRenderer::makePipelines})
        if (auto made = (renderer.get()->*step)(); !made) return tl::unexpected(made.error());
    return renderer;
}

Result<void> EffectRenderer::makeBlocks() {
    const auto members = blockMembers(effect_);
    if (!members) return tl::unexpected(members.error());
    auto constants = fillConstants(effect_, *members, fixture_);
    if (!constants) return tl::unexpected(constants.error());
    constants_ = std::move(*constants);
    for (const auto& [name, bytes] : constants_.blocks) {
        const std::vector<std::byte> other = altered(*members, name, bytes);
        Block block;
        block.varies = other != bytes;
        for (const auto& [buffer, content] : {std::pair(&block.usual, &bytes), {&block.other, &other}}) {
            auto made = headless::Buffer::create(device_, *content, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, name);
            if (!made) return tl::unexpected(made.error());
            *buffer = std::move(*made);
        }
        blocks_.emplace(name, std::move(block));
    }
    return {};
}

Result<void> EffectRenderer::makeTextures() {
    const auto texels = rig::makeTextures(effect_, fixture_);
    if (!texels) return tl::unexpected(texels.error());
    for (const auto& [name, image] : *texels) {
        auto usual = upload(device_, image, name), other = upload(device_, altered(image), name + ", altered");
        if (!usual) return tl::unexpected(usual.error());
        if (!other) return tl::unexpected(other.error());
        textures_.emplace(name, Texture{std::move(*usual), std::move(*other)});
    }
    return {};
}

Result<void> EffectRenderer::makeGeometry() {
    const ExplicitGeometry geometry = geometryOf(fixture_);
    indexCount_ = static_cast<std::uint32_t>(geometry.indices.size());
    auto indices = headless::Buffer::create(device_, std::as_bytes(std::span(geometry.indices)),
                                            VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "indices");
    if (!indices) return tl::unexpected(indices.error());
    indices_ = std::move(*indices);
    std::set<const permgen::Module*> modules;
    for (const permgen::Technique& technique : effect_.techniques)
        for (const permgen::Pass& pass : technique.passes)
            if (pass.vertex.module) modules.insert(pass.vertex.module);
    for (const permgen::Module* module : modules) {
        auto stream = vertexStream(*module, geometry);
        if (!stream) return failWith(fixture_.path + ": " + stream.error().message);
        Stream made;
        made.stride = stream->stride;
        for (const VertexAttribute& attribute : stream->attributes)
            made.elements.push_back({attribute.semantic, attribute.offset, attribute.format});
        // The stride is dynamic state, so a buffer must be bound even if nothing is read from it.
        if (stream->bytes.empty()) stream->bytes.resize(16);
        auto buffer = headless::Buffer::create(device_, stream->bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "vertices");
        if (!buffer) return tl::unexpected(buffer.error());
        made.vertices = std::move(*buffer);
        streams_.emplace(module, std::move(made));
    }
    return {};
}

Result<void> EffectRenderer::makePipelines() {
    DeviceContext context{device_.physicalDevice(), device_.device(), VK_NULL_HANDLE, Shaders::Frozen};
    auto frozen = PassPipelines::create(context, effect_);
    if (!frozen) return tl::unexpected(frozen.error());
    frozen_ = std::make_unique<PassPipelines>(std::move(*frozen));
    context.shaders = Shaders::Specialized;
    auto specialized = PassPipelines::create(context, effect_);
    if (!specialized) return tl::unexpected(specialized.error());
    specialized_ = std::make_unique<PassPipelines>(std::move(*specialized));
    return {};
}

bool EffectRenderer::canVary(std::string_view resource) const {
    const auto block = blocks_.find(resource);
    return textures_.contains(resource) || (block != blocks_.end() && block->second.varies);
}

Result<EffectRenderer::Targets> EffectRenderer::makeTargets(const permgen::Technique& technique) const {
    Targets targets;
    headless::ImageInfo info;
    info.extent = {fixture_.width, fixture_.height};
    info.format = fixture_.format;
    info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    info.name = "target";
    for (std::uint32_t i = 0; i < targetsOf(technique); ++i) {
        auto image = headless::Image::create(device_, info);
        if (!image) return tl::unexpected(image.error());
        targets.colours.push_back(std::move(*image));
    }
    if (fixture_.depth) {
        info.format = depthFormat;
        info.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
        info.name = "depth";
        auto image = headless::Image::create(device_, info);
        if (!image) return tl::unexpected(image.error());
        targets.depth = std::move(*image);
    }
    return targets;
}

Result<void> EffectRenderer::recordPass(VkCommandBuffer commands, const Targets& targets, PassPipelines& pipelines,
                                        const permgen::Pass& pass, Variation variation) {
    if (!pass.vertex.module)
        return tl::unexpected(Error{ErrorCode::InvalidArgument, "the pass has no vertex shader; give it one"});
    const std::span colours(targets.colours.data(), targetsOf(pass));
    PassTarget target;
    for (std::size_t i = 0; i < colours.size(); ++i) target.colours[i] = fixture_.format;
    if (fixture_.depth) target.depth = depthFormat;
    const Stream& stream = streams_.at(pass.vertex.module);
    const auto pipeline = pipelines.get(pass, target, stream.elements);
    if (!pipeline) return tl::unexpected(pipeline.error());
    std::vector<NamedBuffer> buffers;
    for (const auto& [name, block] : blocks_)
        buffers.push_back({name, {(name == variation ? block.other : block.usual).handle(), 0, VK_WHOLE_SIZE}});
    std::vector<NamedImage> images;
    for (const auto& [name, texture] : textures_)
        images.push_back({name, (name == variation ? texture.other : texture.usual).view(),
                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});

    // Placeholder resources are made with the pipeline that needs them, and filled outside of rendering.
    pipelines.recordNeutralResources(commands);
    headless::fullBarrier(commands);
    beginRendering(commands, colours, fixture_.depth ? &targets.depth : nullptr, VK_ATTACHMENT_LOAD_OP_LOAD, {});
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline->handle);
    const auto pushed = pipelines.push(commands, *pipeline, buffers, images);
    if (pushed) recordDraw(commands, stream);
    vkCmdEndRendering(commands);
    if (!pushed) return tl::unexpected(pushed.error());
    return {};
}

void EffectRenderer::recordDraw(VkCommandBuffer commands, const Stream& stream) const {
    const VkBuffer vertices = stream.vertices.handle();
    const VkDeviceSize offset = 0, stride = stream.stride;
    vkCmdBindVertexBuffers2(commands, 0, 1, &vertices, &offset, nullptr, &stride);
    vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, indexCount_, 1, 0, 0, 0);
}

Result<void> EffectRenderer::record(VkCommandBuffer commands, const Targets& targets,
                                    const permgen::Technique& technique, std::size_t passes, Shaders shaders,
                                    Variation variation) {
    PassPipelines& pipelines = shaders == Shaders::Frozen ? *frozen_ : *specialized_;
    for (const headless::Image& image : targets.colours)
        headless::transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    if (fixture_.depth)
        headless::transition(commands, targets.depth, VK_IMAGE_LAYOUT_UNDEFINED,
                             VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    beginRendering(commands, targets.colours, fixture_.depth ? &targets.depth : nullptr, VK_ATTACHMENT_LOAD_OP_CLEAR,
                   fixture_.clear);
    vkCmdEndRendering(commands);
    for (std::size_t i = 0; i < passes; ++i)
        if (auto done = recordPass(commands, targets, pipelines, technique.passes[i], variation); !done) return done;
    return {};
}

Result<Image> EffectRenderer::readTargets(const Targets& targets) const {
    Image whole{static_cast<int>(fixture_.width), 0, 4, {}};
    for (const headless::Image& target : targets.colours) {
        const auto bytes = headless::readback(device_, target, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        if (!bytes) return tl::unexpected(bytes.error());
        const std::vector<float> values = decodeTexels(*bytes, fixture_.format);
        whole.values.insert(whole.values.end(), values.begin(), values.end());
        whole.height += static_cast<int>(fixture_.height);
    }
    return whole;
}

Result<Image> EffectRenderer::draw(const permgen::Technique& technique, std::size_t passes, Shaders shaders,
                                   Variation variation) {
    const auto targets = makeTargets(technique);
    if (!targets) return tl::unexpected(targets.error());
    const auto submitted = headless::submitAndWait(device_, [&](VkCommandBuffer commands) {
        return record(commands, *targets, technique, passes, shaders, variation);
    });
    if (!submitted) return tl::unexpected(submitted.error());
    return readTargets(*targets);
}

}  // namespace tyndall::rig
