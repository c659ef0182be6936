#include "effect_contract.h"

#include <tyndall/plan.h>
#include <tyndall/raycast_data.h>
#include <tyndall/slice_data.h>

#include <algorithm>
#include <array>
#include <string>

#include "composite_data.h"
#include "compute_rays.h"
#include "effects.h"
#include "gpu_context.h"

namespace tyndall {
namespace {

/// All techniques of a built-in effect.
template <std::size_t Count>
constexpr std::array<std::string_view, Count> techniqueNames(const permgen::Effect& effect) {
    std::array<std::string_view, Count> names;
    for (std::size_t i = 0; i < Count; ++i) names[i] = effect.techniques[i].name;
    return names;
}

constexpr BlockMember sliceMembers[] = {
    {"gClipFromView", offsetof(SliceConstants, clipFromView), 64},
    {"gLightFromView", offsetof(SliceConstants, lightFromView), 64},
    {"gBoundsMin", offsetof(SliceConstants, boundsMin), 16},
    {"gBoundsMax", offsetof(SliceConstants, boundsMax), 16},
    {"gClipPlanes", offsetof(SliceConstants, clipPlanes), 128},
    {"gCookieScale", offsetof(SliceConstants, cookieScale), 16},
    {"gAttenuation", offsetof(SliceConstants, attenuation), 16},
    {"gDust", offsetof(SliceConstants, dust), 16},
    {"gNoise1", offsetof(SliceConstants, noise1), 16},
    {"gNoise2", offsetof(SliceConstants, noise2), 16},
    {"gColour", offsetof(SliceConstants, colour), 16},
    {"gWeight", offsetof(SliceConstants, weight), 16},
    {"gShadow", offsetof(SliceConstants, shadow), 16},
    {"gScattering", offsetof(SliceConstants, scattering), 16},
    {"gEye", offsetof(SliceConstants, eye), 16},
};
constexpr std::string_view sliceSamplers[] = {"CookieSampler", "ScrollingNoiseSampler", "ShadowMapSampler"};
constexpr auto sliceTechniques = techniqueNames<effects::slices::technique_count>(effects::slices::effect);
constexpr VertexElement sliceElements[] = {
    {"POSITION0", offsetof(SliceVertex, position), VK_FORMAT_R32G32B32_SFLOAT},
    {"TEXCOORD0", offsetof(SliceVertex, thickness), VK_FORMAT_R32_SFLOAT},
    {"COLOR0", offsetof(SliceVertex, channelMask), VK_FORMAT_R8G8B8A8_UNORM},
};
constexpr EffectContract slices{"slices.fx",   sliceMembers, sizeof(SliceConstants), sliceSamplers, sliceTechniques,
                                sliceElements, true};

constexpr BlockMember raycastMembers[] = {
    {"gOrigin", offsetof(RaycastConstants, origin), 48},
    {"gDirection", offsetof(RaycastConstants, direction), 48},
    {"gPlanes", offsetof(RaycastConstants, planes), 288},
    {"gVolume", offsetof(RaycastConstants, volume), 16},
    {"gDepths", offsetof(RaycastConstants, depths), 16},
    {"gSurface", offsetof(RaycastConstants, surface), 16},
    {"gPixel", offsetof(RaycastConstants, pixel), 16},
    {"gTexels", offsetof(RaycastConstants, texels), 16},
    {"gCookieScale", offsetof(RaycastConstants, cookieScale), 16},
    {"gAttenuation", offsetof(RaycastConstants, attenuation), 16},
    {"gDust", offsetof(RaycastConstants, dust), 16},
    {"gNoise1", offsetof(RaycastConstants, noise1), 16},
    {"gNoise2", offsetof(RaycastConstants, noise2), 16},
    {"gColour", offsetof(RaycastConstants, colour), 16},
    {"gWeight", offsetof(RaycastConstants, weight), 16},
    {"gShadow", offsetof(RaycastConstants, shadow), 16},
    {"gScattering", offsetof(RaycastConstants, scattering), 16},
    {"gChannels", offsetof(RaycastConstants, channels), 16},
};
constexpr std::string_view raycastSamplers[] = {"CookieSampler", "ScrollingNoiseSampler", "ShadowMapSampler",
                                                "ShadowHierarchySampler", "SceneDepthSampler"};
constexpr auto raycastTechniques = techniqueNames<effects::raycast::technique_count>(effects::raycast::effect);
constexpr EffectContract raycast{
    "raycast.fx", raycastMembers, sizeof(RaycastConstants), raycastSamplers, raycastTechniques, sliceElements, true};

// Its effect is never the caller's: only this library dispatches it.
constexpr BlockMember rayTileMembers[] = {{"gTile", offsetof(ComputedRays, tile), 16}};
constexpr EffectContract computedRays{"raycast_compute.fx", rayTileMembers, sizeof(ComputedRays), {}, {}, {}, false};

constexpr BlockMember compositeMembers[] = {
    {"gTint", offsetof(CompositeConstants, tint), 16},
    {"gTexel", offsetof(CompositeConstants, texel), 16},
    {"gDepth", offsetof(CompositeConstants, depth), 16},
};
constexpr std::string_view compositeSamplers[] = {"AccumulationSampler", "SceneDepthSampler"};
constexpr auto compositeTechniques = techniqueNames<effects::composite::technique_count>(effects::composite::effect);
constexpr VertexElement screenElements[] = {{"POSITION0", 0, VK_FORMAT_R32G32_SFLOAT}};
constexpr EffectContract composite{"composite.fx",
                                   compositeMembers,
                                   sizeof(CompositeConstants),
                                   compositeSamplers,
                                   compositeTechniques,
                                   screenElements,
                                   true};

constexpr BlockMember shadowMapMembers[] = {{"gClipFromMesh", 0, sizeof(glm::mat4)}};
constexpr auto shadowMapTechniques = techniqueNames<effects::shadow_map::technique_count>(effects::shadow_map::effect);
constexpr VertexElement occluderElements[] = {{"POSITION0", 0, VK_FORMAT_R32G32B32_SFLOAT}};
constexpr EffectContract shadowMap{
    "shadow_map.fx", shadowMapMembers, sizeof(glm::mat4), {}, shadowMapTechniques, occluderElements, false};

constexpr BlockMember shadowHierarchyMembers[] = {{"gLevel", 0, sizeof(glm::vec4)}};
constexpr std::string_view shadowHierarchySamplers[] = {"SourceSampler"};
constexpr auto shadowHierarchyTechniques =
    techniqueNames<effects::shadow_hierarchy::technique_count>(effects::shadow_hierarchy::effect);
constexpr EffectContract shadowHierarchy{"shadow_hierarchy.fx",
                                         shadowHierarchyMembers,
                                         sizeof(glm::vec4),
                                         shadowHierarchySamplers,
                                         shadowHierarchyTechniques,
                                         screenElements,
                                         true};

// These loops look up by value. Under -fsanitize=undefined GCC 12 does not compare an address with null in a constant
// expression, so a static_assert cannot use permgen::find_member() and find_resource() there.

constexpr bool isPlaced(const permgen::Effect& effect, const BlockMember& expected) {
    for (const permgen::Member& member : effect.members)
        if (member.name == expected.name) return member.offset == expected.offset && member.size == expected.size;
    return false;
}

/// The first constant whose position breaks the contract; empty if there is none.
constexpr std::string_view misplaced(const permgen::Effect& effect, const EffectContract& contract) {
    for (const BlockMember& expected : contract.members)
        if (!isPlaced(effect, expected)) return expected.name;
    return {};
}

/// Whether the block holds only the members of the contract.
constexpr bool blockFits(const permgen::Effect& effect, const EffectContract& contract) {
    for (const permgen::Resource& resource : effect.resources)
        if (resource.name == globalsBlock)
            return resource.size == contract.blockSize && effect.members.size() == contract.members.size();
    return false;
}

static_assert(misplaced(effects::slices::effect, slices).empty(), "slices.fx moved a constant");
static_assert(blockFits(effects::slices::effect, slices), "slices.fx and SliceConstants differ in size");
static_assert(misplaced(effects::raycast::effect, raycast).empty(), "raycast.fx moved a constant");
static_assert(blockFits(effects::raycast::effect, raycast), "raycast.fx and RaycastConstants differ in size");
static_assert(misplaced(effects::raycast_compute::effect, raycast).empty(), "raycast_compute.fx moved a constant");
static_assert(misplaced(effects::raycast_compute::effect, computedRays).empty(), "raycast_compute.fx moved its tile");
static_assert(effects::raycast_compute::effect.members.size() == std::size(raycastMembers) + 1,
              "raycast_compute.fx has constants that ComputedRays lacks");
static_assert(misplaced(effects::composite::effect, composite).empty(), "composite.fx moved a constant");
static_assert(blockFits(effects::composite::effect, composite), "composite.fx and CompositeConstants differ in size");
static_assert(misplaced(effects::shadow_map::effect, shadowMap).empty(), "shadow_map.fx moved its constant");
static_assert(blockFits(effects::shadow_map::effect, shadowMap), "shadow_map.fx holds more than one matrix");
static_assert(misplaced(effects::shadow_hierarchy::effect, shadowHierarchy).empty(),
              "shadow_hierarchy.fx moved its constant");
static_assert(blockFits(effects::shadow_hierarchy::effect, shadowHierarchy),
              "shadow_hierarchy.fx holds more than one vector");

Result<void> checkResources(const permgen::Effect& effect, const EffectContract& contract, const std::string& whose) {
    if (const std::string_view name = misplaced(effect, contract); !name.empty())
        return invalidArgument(whose + "has no constant " + std::string(name) +
                               " where this library writes it; declare its constants as " + std::string(contract.file) +
                               " of this version does");
    if (!blockFits(effect, contract))
        return invalidArgument(whose + "has constants that this library does not write; declare them as " +
                               std::string(contract.file) + " of this version does");
    for (const permgen::Resource& resource : effect.resources) {
        if (resource.name == globalsBlock) continue;
        const bool known = std::ranges::find(contract.samplers, resource.name) != contract.samplers.end();
        if (!known || resource.dimension != permgen::ImageDimension::Two)
            return invalidArgument(whose + "reads " + std::string(resource.name) +
                                   ", which this library has nothing to bind to; remove it");
    }
    return {};
}

Result<void> checkTechnique(const permgen::Technique& technique, const EffectContract& contract, Shaders shaders,
                            const std::string& whose) {
    const std::string name = std::string(technique.name);
    if (technique.passes.size() != 1)
        return invalidArgument(whose + "has " + std::to_string(technique.passes.size()) + " passes in " + name +
                               "; this library draws one");
    const permgen::Pass& pass = technique.passes[0];
    if (!pass.vertex.module || (contract.pixels && !pass.pixel.module))
        return invalidArgument(whose + "lacks a shader in " + name + "; give the pass one");
    const bool thawed = pass.vertex.frozen.empty() || (pass.pixel.module && pass.pixel.frozen.empty());
    if (shaders == Shaders::Frozen && thawed)
        return invalidArgument(whose + "has no frozen modules; compile it with permgen's --freeze");
    for (const permgen::Attribute& attribute : pass.vertex.module->attributes) {
        const auto known = [&](const VertexElement& element) { return element.semantic == attribute.semantic; };
        if (std::ranges::none_of(contract.elements, known))
            return invalidArgument(whose + "reads " + std::string(attribute.semantic) + " in " + name +
                                   ", which the vertices do not have");
    }
    return {};
}

}  // namespace

const EffectContract& slicesContract() {
    return slices;
}
const EffectContract& raycastContract() {
    return raycast;
}
const EffectContract& compositeContract() {
    return composite;
}
const EffectContract& shadowMapContract() {
    return shadowMap;
}
const EffectContract& shadowHierarchyContract() {
    return shadowHierarchy;
}

Result<void> checkEffect(const permgen::Effect& effect, const EffectContract& contract, Shaders shaders) {
    const std::string whose =
        "the effect " + std::string(effect.name) + ", given for " + std::string(contract.file) + ", ";
    if (auto checked = checkResources(effect, contract, whose); !checked) return checked;
    for (const std::string_view name : contract.techniques) {
        const permgen::Technique* technique = permgen::find_technique(effect, name);
        if (!technique) return invalidArgument(whose + "has no technique " + std::string(name) + "; give it one");
        if (auto checked = checkTechnique(*technique, contract, shaders, whose); !checked) return checked;
    }
    return {};
}

}  // namespace tyndall
