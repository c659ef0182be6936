// Pipelines, made once for each (pass, target, layout of the vertices): when first asked for, or several at a time
// ahead of that.
#pragma once

#include <tyndall/parallel.h>
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

/// What tells pipelines apart. A store sees one kind of `shaders` for each effect. Vertices are one interleaved
/// stream of `elements` whose stride is dynamic state, as are viewport and scissor.
struct PipelineRequest {
    const permgen::Effect* effect = nullptr;
    const permgen::Pass* pass = nullptr;  ///< one of the effect's
    Shaders shaders = Shaders::Frozen;
    PassTarget target;
    std::span<const VertexElement> elements;
};

/// `created` grows by one where the pipeline had to be made.
/// Errors: as PassPipelines::get().
Result<PassPipeline> pipelineFor(const Gpu& gpu, PipelineStore& store, const PipelineRequest& request,
                                 std::uint64_t& created);

/// Makes those of `requests` that the store lacks, each once, on the threads of `parallel` (which may be empty:
/// on this one). `created` grows by the number made.
/// Errors: the first that occurs, as pipelineFor(); InvalidArgument where `parallel` left jobs out. What
/// could be made is then in the store all the same.
Result<void> makePipelines(const Gpu& gpu, PipelineStore& store, std::span<const PipelineRequest> requests,
                           const ParallelFor& parallel, std::uint64_t& created);

void destroyPipelines(const Gpu& gpu, PipelineStore& store);

}  // namespace tyndall
