// Pipelines, layouts, samplers and push descriptors for the passes of any effect that permgen compiled:
//
//   auto pipelines = PassPipelines::create({physicalDevice, device}, water::effect);
//   auto calm = pipelines->get(technique->passes[0], {.colours = {format}}, vertexElements);
//   pipelines->recordNeutralResources(commands);                // outside of rendering
//   vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, calm->handle);
//   const std::array buffers{NamedBuffer{"Globals", constants}};
//   const std::array images{NamedImage{"RippleSampler", view, layout}};
//   pipelines->push(commands, *calm, buffers, images);
//
// A pass that computes has neither target nor vertices:
//
//   auto sums = pipelines->get(technique->passes[1]);
//   vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, sums->handle);
//   const std::array images{NamedImage{"Picture", view, VK_IMAGE_LAYOUT_GENERAL}};
//   pipelines->push(commands, *sums, buffers, images);
//   const auto groups = groupCounts(technique->passes[1], {width, height, 1});
//   vkCmdDispatch(commands, groups[0], groups[1], groups[2]);
//
// Barriers between passes are the caller's. Viewport, scissor and the stride of vertices (vkCmdBindVertexBuffers2) are
// dynamic state. Not thread-safe.
#pragma once

#include <tyndall/device.h>
#include <tyndall/result.h>

#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace tyndall {

/// One element of an interleaved vertex.
struct VertexElement {
    std::string_view semantic;  ///< as permgen writes it: "TEXCOORD0"
    std::uint32_t offset;       ///< bytes from the vertex's start
    VkFormat format;
};

/// The attachments and dynamic state of a pipeline.
struct PassTarget {
    std::array<VkFormat, 4> colours{};                  ///< COLOR0 to COLOR3; those at the end may be UNDEFINED
    VkFormat depth = VK_FORMAT_UNDEFINED;               ///< UNDEFINED: no depth test; overrides the pass
    VkCompareOp compare = VK_COMPARE_OP_LESS_OR_EQUAL;  ///< of depths, if the pass has no ZFunc
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    bool dynamicCulling = false;  ///< cull mode and front face are dynamic state; overrides the pass
    auto operator<=>(const PassTarget&) const = default;
};

/// The buffer of a uniform block or of a storage buffer, by its name in the effect.
struct NamedBuffer {
    std::string_view block;
    VkDescriptorBufferInfo buffer;
};

/// The image of a sampler or of a storage image, by its name in the effect. A storage image's view has the format
/// vulkanFormat(resource.format), one mip level, and the layout GENERAL.
struct NamedImage {
    std::string_view sampler;
    VkImageView view;
    VkImageLayout layout;
};

struct PassLayout;  ///< the library's own

/// Lives as long as the PassPipelines that made it.
struct PassPipeline {
    VkPipeline handle = VK_NULL_HANDLE;
    const PassLayout* layout = nullptr;
};

/// Whether `pipeline` reads the resource of that name: permgen::is_live() of its pass.
bool reads(const PassPipeline& pipeline, std::string_view resource);

/// The counts for vkCmdDispatch() that give each of `threads` a thread; those of the last groups may lie beyond.
/// `pass` computes.
constexpr std::array<std::uint32_t, 3> groupCounts(const permgen::Pass& pass, std::array<std::uint32_t, 3> threads) {
    for (std::size_t axis = 0; axis < threads.size(); ++axis) {
        const std::uint32_t size = pass.compute.module->group_size[axis];
        threads[axis] = threads[axis] / size + (threads[axis] % size ? 1 : 0);
    }
    return threads;
}

class PassPipelines {
public:
    struct Impl;  ///< the library's own

    /// `effect` must outlive it. context.shaders chooses between each pass's frozen modules and the shared,
    /// specialized ones.
    /// Errors: InvalidArgument for a null handle, UnsupportedDevice with the missing feature's name.
    static Result<PassPipelines> create(const DeviceContext& context, const permgen::Effect& effect);
    PassPipelines(PassPipelines&&) noexcept;
    PassPipelines& operator=(PassPipelines&&) noexcept;
    ~PassPipelines();  ///< the GPU must have finished with everything recorded

    /// The pipeline that draws `pass`, a pass of the effect; made on first use. It uses those `elements` that the
    /// pass's vertex shader reads.
    /// Errors: InvalidArgument if a state is unknown, a semantic has no element, frozen modules are wanted and permgen
    /// made none, or more than 32 resources are bound; UnsupportedDevice if the device cannot draw to a format; Vulkan.
    Result<PassPipeline> get(const permgen::Pass& pass, const PassTarget& target,
                             std::span<const VertexElement> elements);

    /// The pipeline that computes `pass`, a pass of the effect; made on first use. The device needs the features that
    /// the storage images' formats ask for (docs/permgen.md).
    /// Errors: InvalidArgument as above; UnsupportedDevice if the thread group or an image's format is beyond the
    /// device; Vulkan.
    Result<PassPipeline> get(const permgen::Pass& pass);

    /// Fills the neutral resources for those that a specialized module declares and its pass does not read. Record it
    /// before drawing or computing with such pipelines, outside of rendering, in every submission that uses them.
    /// Records nothing if there is nothing to fill.
    void recordNeutralResources(VkCommandBuffer commands) const;

    /// Pushes those `buffers` and `images` that `pipeline` binds. Returns the number of descriptors. Errors:
    /// InvalidArgument naming a resource that the pass uses and that got no buffer or image.
    Result<std::uint32_t> push(VkCommandBuffer commands, const PassPipeline& pipeline,
                               std::span<const NamedBuffer> buffers, std::span<const NamedImage> images) const;

    /// Number of pipelines made so far.
    std::size_t count() const;

private:
    explicit PassPipelines(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace tyndall
