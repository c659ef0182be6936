// Makes a Renderer's pipelines before recording.
#include "compute_rays.h"
#include "renderer_pipelines.h"

namespace tyndall {

Result<void> Renderer::prepare(const PipelineNeeds& needs, const ParallelFor& parallel) {
    Impl& impl = *impl_;
    std::vector<PipelineRequest> requests;
    const PassTarget target = accumulationTarget(needs.accumulation, needs.depthFormat, needs.depthCompare);
    const bool computed = isComputed(needs.method, needs.accumulation, needs.storage);
    for (const TermSet terms : needs.terms) {
        if (!computed) {
            requests.push_back(shaftPipeline(impl, needs.method, terms, target));
            continue;
        }
        const std::uint64_t before = impl.counters.pipelinesCreated;
        if (const auto made = raysPipeline(impl, needs.accumulation, terms); !made) return tl::unexpected(made.error());
        impl.counters.pipelinesPrepared += impl.counters.pipelinesCreated - before;
    }
    if (!needs.terms.empty() && needs.colourFormat != VK_FORMAT_UNDEFINED)
        requests.push_back(compositePipeline(impl, needs.accumulation, needs.blur, needs.colourFormat));
    if (needs.shadowMapFormat != VK_FORMAT_UNDEFINED)
        requests.push_back(shadowMapPipeline(impl, needs.shadowMapFormat));
    if (needs.method == Method::Raycast)
        for (const bool fromMap : {true, false}) requests.push_back(shadowHierarchyPipeline(impl, fromMap));

    std::uint64_t made = 0;
    auto outcome = makePipelines(impl.gpu, impl.pipelines, requests, parallel, made);
    impl.counters.pipelinesCreated += made;
    impl.counters.pipelinesPrepared += made;
    return outcome;
}

}  // namespace tyndall
