// Makes a Renderer's pipelines ahead of recording.
#include "renderer_pipelines.h"

namespace tyndall {

Result<void> Renderer::prepare(const PipelineNeeds& needs, const ParallelFor& parallel) {
    Impl& impl = *impl_;
    std::vector<PipelineRequest> requests;
    const PassTarget target = accumulationTarget(needs.accumulation, needs.depthFormat, needs.depthCompare);
    for (const std::string_view technique : needs.techniques) {
        const auto request = slicePipeline(impl, technique, target);
        if (!request) return tl::unexpected(request.error());
        requests.push_back(*request);
    }
    if (!requests.empty() && needs.colourFormat != VK_FORMAT_UNDEFINED)
        requests.push_back(compositePipeline(impl, needs.accumulation, needs.blur, needs.colourFormat));
    if (needs.shadowMapFormat != VK_FORMAT_UNDEFINED)
        requests.push_back(shadowMapPipeline(impl, needs.shadowMapFormat));

    std::uint64_t made = 0;
    auto outcome = makePipelines(impl.gpu, impl.pipelines, requests, parallel, made);
    impl.counters.pipelinesCreated += made;
    impl.counters.pipelinesPrepared += made;
    return outcome;
}

}  // namespace tyndall
