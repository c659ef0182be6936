#include "states.h"

#include <charconv>
#include <string>

#include "d3d9_words.h"
#include "gpu_context.h"

namespace tyndall {
namespace {

constexpr auto blendFactors = std::to_array<Word<VkBlendFactor>>({
    {"ZERO", VK_BLEND_FACTOR_ZERO},
    {"ONE", VK_BLEND_FACTOR_ONE},
    {"SRCCOLOR", VK_BLEND_FACTOR_SRC_COLOR},
    {"INVSRCCOLOR", VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR},
    {"SRCALPHA", VK_BLEND_FACTOR_SRC_ALPHA},
    {"INVSRCALPHA", VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA},
    {"DESTALPHA", VK_BLEND_FACTOR_DST_ALPHA},
    {"INVDESTALPHA", VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA},
    {"DESTCOLOR", VK_BLEND_FACTOR_DST_COLOR},
    {"INVDESTCOLOR", VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR},
    {"SRCALPHASAT", VK_BLEND_FACTOR_SRC_ALPHA_SATURATE},
});

// For the alpha channel Direct3D 9 reads a colour factor as the alpha one.
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

constexpr auto blendOps = std::to_array<Word<VkBlendOp>>({
    {"ADD", VK_BLEND_OP_ADD},
    {"SUBTRACT", VK_BLEND_OP_SUBTRACT},
    {"REVSUBTRACT", VK_BLEND_OP_REVERSE_SUBTRACT},
    {"MIN", VK_BLEND_OP_MIN},
    {"MAX", VK_BLEND_OP_MAX},
});

constexpr auto compareOps = std::to_array<Word<VkCompareOp>>({
    {"NEVER", VK_COMPARE_OP_NEVER},
    {"LESS", VK_COMPARE_OP_LESS},
    {"EQUAL", VK_COMPARE_OP_EQUAL},
    {"LESSEQUAL", VK_COMPARE_OP_LESS_OR_EQUAL},
    {"GREATER", VK_COMPARE_OP_GREATER},
    {"NOTEQUAL", VK_COMPARE_OP_NOT_EQUAL},
    {"GREATEREQUAL", VK_COMPARE_OP_GREATER_OR_EQUAL},
    {"ALWAYS", VK_COMPARE_OP_ALWAYS},
});

// CullMode names the winding that is dropped; front faces are clockwise here.
constexpr auto cullModes = std::to_array<Word<VkCullModeFlags>>({
    {"NONE", VK_CULL_MODE_NONE},
    {"CW", VK_CULL_MODE_FRONT_BIT},
    {"CCW", VK_CULL_MODE_BACK_BIT},
});

constexpr auto channels = std::to_array<Word<VkColorComponentFlags>>({
    {"RED", VK_COLOR_COMPONENT_R_BIT},
    {"GREEN", VK_COLOR_COMPONENT_G_BIT},
    {"BLUE", VK_COLOR_COMPONENT_B_BIT},
    {"ALPHA", VK_COLOR_COMPONENT_A_BIT},
});

// Parts of the fixed-function pipeline that Vulkan does not have, or that no pass here asks for: effects
// switch them off by habit.
constexpr std::array mayBeOff{std::string_view("AlphaTestEnable"), std::string_view("StencilEnable"),
                              std::string_view("FogEnable"),       std::string_view("Lighting"),
                              std::string_view("SpecularEnable"),  std::string_view("ScissorTestEnable"),
                              std::string_view("SRGBWriteEnable")};

/// A number whose bits are red 1, green 2, blue 4, alpha 8 (Vulkan's own bits), or words joined by '|'.
std::optional<VkColorComponentFlags> readChannels(std::string_view value) {
    VkColorComponentFlags mask = 0;
    const bool hexadecimal = value.starts_with("0x") || value.starts_with("0X");
    const std::string_view digits = hexadecimal ? value.substr(2) : value;
    const auto number = std::from_chars(digits.data(), digits.data() + digits.size(), mask, hexadecimal ? 16 : 10);
    if (number.ec == std::errc{} && number.ptr == digits.data() + digits.size())
        return mask <= 15 ? std::optional(mask) : std::nullopt;

    mask = 0;
    while (true) {
        const std::size_t bar = value.find('|');
        std::string_view word = value.substr(0, bar);
        while (!word.empty() && word.front() == ' ') word.remove_prefix(1);
        while (!word.empty() && word.back() == ' ') word.remove_suffix(1);
        const auto channel = lookUp(channels, word);
        if (!channel) return std::nullopt;
        mask |= *channel;
        if (bar == std::string_view::npos) return mask;
        value.remove_prefix(bar + 1);
    }
}

/// What was written, before alpha's own settings take the colour's place.
struct BlendAsWritten {
    bool separateAlpha = false;
    VkBlendFactor source = VK_BLEND_FACTOR_ONE, destination = VK_BLEND_FACTOR_ZERO;
    VkBlendFactor sourceAlpha = VK_BLEND_FACTOR_ONE, destinationAlpha = VK_BLEND_FACTOR_ZERO;
    VkBlendOp operation = VK_BLEND_OP_ADD, operationAlpha = VK_BLEND_OP_ADD;
};

template <class Value>
bool assign(Value& target, std::optional<Value> value) {
    if (value) target = *value;
    return value.has_value();
}

enum class Applied { Yes, UnknownName, UnknownValue };

Applied apply(const permgen::State& state, PassStates& pass, BlendAsWritten& blend) {
    const auto is = [&](std::string_view name) { return sameWord(state.name, name); };
    const auto known = [](bool value) { return value ? Applied::Yes : Applied::UnknownValue; };
    const std::string_view value = state.value;

    if (is("AlphaBlendEnable")) {
        const auto enabled = readBool(value);
        if (enabled) pass.blend.blendEnable = *enabled ? VK_TRUE : VK_FALSE;
        return known(enabled.has_value());
    }
    if (is("SeparateAlphaBlendEnable")) return known(assign(blend.separateAlpha, readBool(value)));
    if (is("SrcBlend")) return known(assign(blend.source, lookUp(blendFactors, value)));
    if (is("DestBlend")) return known(assign(blend.destination, lookUp(blendFactors, value)));
    if (is("SrcBlendAlpha")) return known(assign(blend.sourceAlpha, lookUp(blendFactors, value)));
    if (is("DestBlendAlpha")) return known(assign(blend.destinationAlpha, lookUp(blendFactors, value)));
    if (is("BlendOp")) return known(assign(blend.operation, lookUp(blendOps, value)));
    if (is("BlendOpAlpha")) return known(assign(blend.operationAlpha, lookUp(blendOps, value)));
    if (is("ColorWriteEnable")) return known(assign(pass.blend.colorWriteMask, readChannels(value)));
    if (is("ZEnable")) return known(assign(pass.depthTest, readBool(value)));
    if (is("ZWriteEnable")) return known(assign(pass.depthWrite, readBool(value)));
    if (is("ZFunc")) {
        pass.depthCompare = lookUp(compareOps, value);
        return known(pass.depthCompare.has_value());
    }
    if (is("CullMode")) return known(assign(pass.cull, lookUp(cullModes, value)));
    if (is("FillMode")) return known(sameWord(value, "SOLID"));
    for (const std::string_view name : mayBeOff)
        if (is(name)) return known(readBool(value) == false);
    return Applied::UnknownName;
}

}  // namespace

Result<PassStates> passStates(std::span<const permgen::State> states) {
    PassStates pass;
    pass.blend.colorWriteMask = 15;
    BlendAsWritten blend;
    for (const permgen::State& state : states) {
        switch (apply(state, pass, blend)) {
            case Applied::Yes:
                break;
            case Applied::UnknownName:
                return invalidArgument("the state " + std::string(state.name) +
                                       " is not one that the renderer knows; remove it from the pass");
            case Applied::UnknownValue:
                return invalidArgument("the state " + std::string(state.name) + " cannot be " +
                                       std::string(state.value) +
                                       " here; give it one of Direct3D 9's values that "
                                       "Vulkan has too");
        }
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
