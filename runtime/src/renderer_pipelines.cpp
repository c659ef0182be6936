#include "renderer_pipelines.h"

#include "effect_contract.h"

namespace tyndall {
namespace {

std::string_view compositeTechnique(bool routed, bool blur) {
    if (routed) return blur ? "routed_blur_technique" : "routed_noblur_technique";
    return blur ? "plain_blur_technique" : "plain_noblur_technique";
}

}  // namespace

PassTarget accumulationTarget(Accumulation accumulation, VkFormat depth, VkCompareOp compare) {
    return {.colours = {accumulationFormat(accumulation)}, .depth = depth, .compare = compare};
}

PipelineRequest slicePipeline(const Renderer::Impl& impl, TermSet terms, const PassTarget& target) {
    const permgen::Technique& technique = *impl.sliceTechniques[terms.index()];
    return {impl.slices, technique.passes.data(), impl.gpu.shaders, target, slicesContract().elements};
}

PipelineRequest compositePipeline(const Renderer::Impl& impl, Accumulation accumulation, bool blur, VkFormat colour) {
    const bool routed = accumulation == Accumulation::Rgba8Routed;
    const permgen::Technique* technique = permgen::find_technique(*impl.composite, compositeTechnique(routed, blur));
    return {
        impl.composite, technique->passes.data(), Shaders::Frozen, {.colours = {colour}}, compositeContract().elements};
}

PipelineRequest shadowMapPipeline(const Renderer::Impl& impl, VkFormat map) {
    const EffectContract& contract = shadowMapContract();
    const permgen::Technique* technique = permgen::find_technique(*impl.shadowMap, contract.techniques[0]);
    return {impl.shadowMap,
            technique->passes.data(),
            Shaders::Frozen,
            {.depth = map, .compare = VK_COMPARE_OP_GREATER},
            contract.elements};
}

}  // namespace tyndall
