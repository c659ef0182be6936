// Pipelines, made once for each (pass, target formats, comparison) when first asked for.
#pragma once

#include <compare>
#include <map>
#include <span>

#include "gpu_context.h"
#include "pipeline_layouts.h"

namespace tyndall {

struct VertexElement {
    std::string_view semantic;  ///< as permgen writes it: "TEXCOORD0"
    std::uint32_t offset;       ///< bytes from the vertex's start
    VkFormat format;
};

/// Where a pipeline draws. `compare` counts where the pass writes no ZFunc.
struct PipelineTarget {
    VkFormat colour = VK_FORMAT_UNDEFINED;
    VkFormat depth = VK_FORMAT_UNDEFINED;
    VkCompareOp compare = VK_COMPARE_OP_ALWAYS;
    auto operator<=>(const PipelineTarget&) const = default;
};

struct Pipeline {
    VkPipeline handle = VK_NULL_HANDLE;
    const PassLayout* layout = nullptr;
};

struct PipelineStore {
    std::map<const permgen::Pass*, PassLayout> layouts;
    std::map<std::pair<const permgen::Pass*, PipelineTarget>, Pipeline> pipelines;
};

/// The pipeline of the only pass of `technique`, which is one of `effect`'s. A store sees one kind of `shaders`
/// for each effect. Vertices are one interleaved stream of `elements` whose stride
/// is dynamic state, as are viewport and scissor. `created` grows by one where it had to be made.
/// Errors: InvalidArgument where a state or a vertex semantic is unknown, UnsupportedDevice where the
/// device cannot draw to a format, Vulkan.
Result<Pipeline> pipelineFor(const Gpu& gpu, PipelineStore& store, const permgen::Effect& effect,
                             const permgen::Technique& technique, Shaders shaders, const PipelineTarget& target,
                             std::span<const VertexElement> elements, std::uint64_t& created);

void destroyPipelines(const Gpu& gpu, PipelineStore& store);

}  // namespace tyndall
