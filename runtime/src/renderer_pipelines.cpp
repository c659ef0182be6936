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

PipelineRequest shaftPipeline(const Renderer::Impl& impl, Method method, TermSet terms, const PassTarget& target) {
    const bool raycast = method == Method::Raycast;
    const permgen::Technique& technique = *(raycast ? impl.raycastTechniques : impl.sliceTechniques)[terms.index()];
    return {raycast ? impl.raycast : impl.slices, technique.passes.data(), impl.gpu.shaders, target,
            (raycast ? raycastContract() : slicesContract()).elements};
}

PipelineRequest compositePipeline(const Renderer::Impl& impl, Accumulation accumulation, bool blur, VkFormat colour) {
    const bool routed = accumulation == Accumulation::Rgba8Routed;
    const permgen::Technique* technique = permgen::find_technique(*impl.composite, compositeTechnique(routed, blur));
    return {
        impl.composite, technique->passes.data(), Shaders::Frozen, {.colours = {colour}}, compositeContract().elements};
}

PipelineRequest shadowHierarchyPipeline(const Renderer::Impl& impl, bool fromMap) {
    namespace hierarchy = effects::shadow_hierarchy;
    const std::string_view name = hierarchy::technique(*hierarchy::find_technique({.bFromMap = fromMap})).name;
    const permgen::Technique* technique = permgen::find_technique(*impl.shadowHierarchy, name);
    return {impl.shadowHierarchy,
            technique->passes.data(),
            Shaders::Frozen,
            {.colours = {shadowHierarchyFormat}},
            shadowHierarchyContract().elements};
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
