// Pipelines, made once for each (pass, target, layout of the vertices) when first asked for.
#pragma once

#include <tyndall/pass_pipelines.h>

#include <map>
#include <span>
#include <vector>

#include "gpu_context.h"
#include "pipeline_layouts.h"

namespace tyndall {

struct PipelineStore {
    struct Entry {
        std::vector<VkVertexInputAttributeDescription> attributes;
        PassPipeline pipeline;
    };
    std::map<const permgen::Pass*, PassLayout> layouts;
    std::map<std::pair<const permgen::Pass*, PassTarget>, std::vector<Entry>> pipelines;
};

/// The pipeline of `pass`, which is one of `effect`'s. A store sees one kind of `shaders` for each effect.
/// Vertices are one interleaved stream of `elements` whose stride is dynamic state, as are viewport and
/// scissor. `created` grows by one where it had to be made.
/// Errors: as PassPipelines::get().
Result<PassPipeline> pipelineFor(const Gpu& gpu, PipelineStore& store, const permgen::Effect& effect,
                                 const permgen::Pass& pass, Shaders shaders, const PassTarget& target,
                                 std::span<const VertexElement> elements, std::uint64_t& created);

void destroyPipelines(const Gpu& gpu, PipelineStore& store);

}  // namespace tyndall
