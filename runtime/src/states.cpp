#include "states.h"

#include <optional>
#include <string>

#include "d3d9/states.h"
#include "gpu_context.h"

namespace tyndall {
namespace {

// States come with Direct3D 9's numbers (permgen/states.h). A number without a case below has no counterpart in Vulkan,
// or the renderer does not support it.

std::optional<VkBlendFactor> blendFactor(std::uint32_t bits) {
    switch (static_cast<permgen::Blend>(bits)) {
        case permgen::Blend::Zero:
            return VK_BLEND_FACTOR_ZERO;
        case permgen::Blend::One:
            return VK_BLEND_FACTOR_ONE;
        case permgen::Blend::SrcColor:
            return VK_BLEND_FACTOR_SRC_COLOR;
        case permgen::Blend::InvSrcColor:
            return VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR;
        case permgen::Blend::SrcAlpha:
            return VK_BLEND_FACTOR_SRC_ALPHA;
        case permgen::Blend::InvSrcAlpha:
            return VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        case permgen::Blend::DestAlpha:
            return VK_BLEND_FACTOR_DST_ALPHA;
        case permgen::Blend::InvDestAlpha:
            return VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
        case permgen::Blend::DestColor:
            return VK_BLEND_FACTOR_DST_COLOR;
        case permgen::Blend::InvDestColor:
            return VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR;
        case permgen::Blend::SrcAlphaSat:
            return VK_BLEND_FACTOR_SRC_ALPHA_SATURATE;
    }
    return std::nullopt;
}

// In the alpha channel Direct3D 9 treats a colour factor as the alpha factor.
VkBlendFactor forAlpha(VkBlendFactor factor) {
    switch (factor) {
        case VK_BLEND_FACTOR_SRC_COLOR:
            return VK_BLEND_FACTOR_SRC_ALPHA;
        case VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR:
            return VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        case VK_BLEND_FACTOR_DST_COLOR:
            return VK_BLEND_FACTOR_DST_ALPHA;
        case VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR:
            return VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
        default:
            return factor;
    }
}

std::optional<VkBlendOp> blendOp(std::uint32_t bits) {
    switch (static_cast<permgen::BlendOp>(bits)) {
        case permgen::BlendOp::Add:
            return VK_BLEND_OP_ADD;
        case permgen::BlendOp::Subtract:
            return VK_BLEND_OP_SUBTRACT;
        case permgen::BlendOp::RevSubtract:
            return VK_BLEND_OP_REVERSE_SUBTRACT;
        case permgen::BlendOp::Min:
            return VK_BLEND_OP_MIN;
        case permgen::BlendOp::Max:
            return VK_BLEND_OP_MAX;
    }
    return std::nullopt;
}

std::optional<VkCompareOp> compareOp(std::uint32_t bits) {
    switch (static_cast<permgen::Compare>(bits)) {
        case permgen::Compare::Never:
            return VK_COMPARE_OP_NEVER;
        case permgen::Compare::Less:
            return VK_COMPARE_OP_LESS;
        case permgen::Compare::Equal:
            return VK_COMPARE_OP_EQUAL;
        case permgen::Compare::LessEqual:
            return VK_COMPARE_OP_LESS_OR_EQUAL;
        case permgen::Compare::Greater:
            return VK_COMPARE_OP_GREATER;
        case permgen::Compare::NotEqual:
            return VK_COMPARE_OP_NOT_EQUAL;
        case permgen::Compare::GreaterEqual:
            return VK_COMPARE_OP_GREATER_OR_EQUAL;
        case permgen::Compare::Always:
            return VK_COMPARE_OP_ALWAYS;
    }
    return std::nullopt;
}

// CullMode names the winding that is culled; front faces are clockwise here.
std::optional<VkCullModeFlags> cullMode(std::uint32_t bits) {
    switch (static_cast<permgen::Cull>(bits)) {
        case permgen::Cull::None:
            return VK_CULL_MODE_NONE;
        case permgen::Cull::Cw:
            return VK_CULL_MODE_FRONT_BIT;
        case permgen::Cull::Ccw:
            return VK_CULL_MODE_BACK_BIT;
    }
    return std::nullopt;
}

std::optional<bool> onOrOff(std::uint32_t bits) {
    return bits <= 1 ? std::optional(bits == 1) : std::nullopt;
}

/// Red 1, green 2, blue 4, alpha 8: Vulkan's own bits.
std::optional<VkColorComponentFlags> channels(std::uint32_t bits) {
    return bits <= 15 ? std::optional<VkColorComponentFlags>(bits) : std::nullopt;
}

constexpr std::uint32_t solid = 3;  // D3DFILL_SOLID

/// The pass's blend settings, before the separate alpha settings apply.
struct BlendAsWritten {
    bool separateAlpha = false;
    VkBlendFactor source = VK_BLEND_FACTOR_ONE, destination = VK_BLEND_FACTOR_ZERO;
    VkBlendFactor sourceAlpha = VK_BLEND_FACTOR_ONE, destinationAlpha = VK_BLEND_FACTOR_ZERO;
    VkBlendOp operation = VK_BLEND_OP_ADD, operationAlpha = VK_BLEND_OP_ADD;
};

template <class Target, class Value>
bool assign(Target& target, std::optional<Value> value) {
    if (value) target = *value;
    return value.has_value();
}

/// False if the renderer does not support the value.
bool apply(const permgen::State& state, PassStates& pass, BlendAsWritten& blend) {
    using permgen::StateId;
    const permgen::d3d9::StateRow& row = permgen::d3d9::row_of(state.id);
    if (row.support == permgen::d3d9::Support::None || row.scope == permgen::d3d9::Scope::Sampler) return true;
    if (state.kind == permgen::ValueKind::Words || state.kind == permgen::ValueKind::Expression) return false;
    if (row.support == permgen::d3d9::Support::Fixed) return state.bits == row.fixed;
    switch (state.id) {
        case StateId::AlphaBlendEnable:
            return assign(pass.blend.blendEnable, onOrOff(state.bits));
        case StateId::SeparateAlphaBlendEnable:
            return assign(blend.separateAlpha, onOrOff(state.bits));
        case StateId::SrcBlend:
            return assign(blend.source, blendFactor(state.bits));
        case StateId::DestBlend:
            return assign(blend.destination, blendFactor(state.bits));
        case StateId::SrcBlendAlpha:
            return assign(blend.sourceAlpha, blendFactor(state.bits));
        case StateId::DestBlendAlpha:
            return assign(blend.destinationAlpha, blendFactor(state.bits));
        case StateId::BlendOp:
            return assign(blend.operation, blendOp(state.bits));
        case StateId::BlendOpAlpha:
            return assign(blend.operationAlpha, blendOp(state.bits));
        case StateId::ColorWriteEnable:
            return assign(pass.blend.colorWriteMask, channels(state.bits));
        case StateId::ZEnable:
            return assign(pass.depthTest, onOrOff(state.bits));
        case StateId::ZWriteEnable:
            return assign(pass.depthWrite, onOrOff(state.bits));
        case StateId::ZFunc:
            return assign(pass.depthCompare, compareOp(state.bits));
        case StateId::CullMode:
            return assign(pass.cull, cullMode(state.bits));
        case StateId::FillMode:
            return state.bits == solid;
        default:
            return false;
    }
}

}  // namespace

Result<PassStates> passStates(std::span<const permgen::State> states) {
    PassStates pass;
    pass.blend.colorWriteMask = 15;
    BlendAsWritten blend;
    for (const permgen::State& state : states) {
        if (state.id == permgen::StateId::Unknown)
            return invalidArgument("the state " + std::string(state.name) +
                                   " is not one that the renderer knows; remove it from the pass");
        if (!apply(state, pass, blend))
            return invalidArgument("the state " + std::string(state.name) + " cannot be " + std::string(state.value) +
                                   " here; give it one of Direct3D 9's values that Vulkan has too");
    }
    pass.blend.srcColorBlendFactor = blend.source;
    pass.blend.dstColorBlendFactor = blend.destination;
    pass.blend.colorBlendOp = blend.operation;
    pass.blend.srcAlphaBlendFactor = forAlpha(blend.separateAlpha ? blend.sourceAlpha : blend.source);
    pass.blend.dstAlphaBlendFactor = forAlpha(blend.separateAlpha ? blend.destinationAlpha : blend.destination);
    pass.blend.alphaBlendOp = blend.separateAlpha ? blend.operationAlpha : blend.operation;
    return pass;
}

}  // namespace tyndall
