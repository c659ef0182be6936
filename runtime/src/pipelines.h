// Pipelines, made once for each (pass, target, vertex layout), or each pass that computes: on first use, or several at
// a time before it.
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
    std::map<const permgen::Pass*, PassPipeline> computing;
};

/// The key of a pipeline. A store uses one kind of `shaders` for each effect. Vertices are one interleaved stream of
/// `elements` whose stride is dynamic state, as are viewport and scissor.
struct PipelineRequest {
    const permgen::Effect* effect = nullptr;
    const permgen::Pass* pass = nullptr;  ///< one of the effect's
    Shaders shaders = Shaders::Frozen;
    PassTarget target;
    std::span<const VertexElement> elements;
};

/// `created` grows by one if the pipeline had to be made.
/// Errors: see PassPipelines::get().
Result<PassPipeline> pipelineFor(const Gpu& gpu, PipelineStore& store, const PipelineRequest& request,
                                 std::uint64_t& created);

/// The pipeline that computes `pass`, one of the effect's; made on first use, when `created` grows by one.
/// Errors: see PassPipelines::get().
Result<PassPipeline> computePipelineFor(const Gpu& gpu, PipelineStore& store, const permgen::Effect& effect,
                                        const permgen::Pass& pass, Shaders shaders, std::uint64_t& created);

/// Makes those `requests` that the store lacks, each once, on the threads of `parallel` (empty: on this thread).
/// `created` grows by the number made.
/// Errors: the first that occurs, see pipelineFor(); InvalidArgument if `parallel` left jobs out. The store keeps the
/// pipelines that were made.
Result<void> makePipelines(const Gpu& gpu, PipelineStore& store, std::span<const PipelineRequest> requests,
                           const ParallelFor& parallel, std::uint64_t& created);

void destroyPipelines(const Gpu& gpu, PipelineStore& store);

}  // namespace tyndall
