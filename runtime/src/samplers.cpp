#include "samplers.h"

#include <optional>
#include <string>

#include "d3d9/states.h"
#include "gpu_context.h"

namespace tyndall {
namespace {

std::optional<VkFilter> filter(std::uint32_t bits) {
    switch (static_cast<permgen::Filter>(bits)) {
        case permgen::Filter::Point:
            return VK_FILTER_NEAREST;
        case permgen::Filter::Linear:
            return VK_FILTER_LINEAR;
        case permgen::Filter::None:
            break;
    }
    return std::nullopt;
}

std::optional<permgen::Filter> mipFilter(std::uint32_t bits) {
    const auto filter = static_cast<permgen::Filter>(bits);
    return filter <= permgen::Filter::Linear ? std::optional(filter) : std::nullopt;
}

std::optional<VkSamplerAddressMode> addressMode(std::uint32_t bits) {
    switch (static_cast<permgen::Address>(bits)) {
        case permgen::Address::Wrap:
            return VK_SAMPLER_ADDRESS_MODE_REPEAT;
        case permgen::Address::Mirror:
            return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
        case permgen::Address::Clamp:
            return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
        case permgen::Address::Border:
            return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
    }
    return std::nullopt;
}

template <class Value>
bool assign(Value& target, std::optional<Value> value) {
    if (value) target = *value;
    return value.has_value();
}

/// False if the renderer does not support the value.
bool apply(const permgen::State& state, VkSamplerCreateInfo& info, permgen::Filter& mip) {
    using permgen::StateId;
    const permgen::d3d9::StateRow& row = permgen::d3d9::row_of(state.id);
    if (state.id == StateId::Texture || row.support == permgen::d3d9::Support::None) return true;
    if (state.kind == permgen::ValueKind::Words || state.kind == permgen::ValueKind::Expression) return false;
    if (row.support == permgen::d3d9::Support::Fixed) return state.bits == row.fixed;
    switch (state.id) {
        case StateId::MinFilter:
            return assign(info.minFilter, filter(state.bits));
        case StateId::MagFilter:
            return assign(info.magFilter, filter(state.bits));
        case StateId::MipFilter:
            return assign(mip, mipFilter(state.bits));
        case StateId::AddressU:
            return assign(info.addressModeU, addressMode(state.bits));
        case StateId::AddressV:
            return assign(info.addressModeV, addressMode(state.bits));
        case StateId::AddressW:
            return assign(info.addressModeW, addressMode(state.bits));
        default:
            return false;
    }
}

}  // namespace

Result<VkSamplerCreateInfo> samplerInfo(std::span<const permgen::State> states) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.borderColor = VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;  // Direct3D 9's default border
    permgen::Filter mip = permgen::Filter::None;
    for (const permgen::State& state : states) {
        const bool ofSampler = state.id != permgen::StateId::Unknown &&
                               permgen::d3d9::row_of(state.id).scope == permgen::d3d9::Scope::Sampler;
        if (!ofSampler)
            return invalidArgument("the sampler state " + std::string(state.name) +
                                   " is not one that the renderer knows; remove it from the sampler");
        if (!apply(state, info, mip))
            return invalidArgument("the sampler state " + std::string(state.name) + " cannot be " +
                                   std::string(state.value) +
                                   " here; give it one of Direct3D 9's values that Vulkan has too");
    }
    info.mipmapMode = mip == permgen::Filter::Linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.maxLod = mip == permgen::Filter::None ? 0.0f : VK_LOD_CLAMP_NONE;
    return info;
}

}  // namespace tyndall
