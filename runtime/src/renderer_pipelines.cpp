#include "renderer_pipelines.h"

#include "effect_contract.h"
#include "effects.h"

namespace tyndall {
namespace {

/// By name: the caller may have given a build of his own of the effect.
std::string_view compositeTechnique(bool routed, bool blur) {
    namespace composite = effects::composite;
    return composite::technique(*composite::find_technique({.bRouted = routed, .bBlur = blur})).name;
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
