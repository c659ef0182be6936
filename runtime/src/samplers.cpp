#include "samplers.h"

#include <string>

#include "d3d9_words.h"
#include "gpu_context.h"

namespace tyndall {
namespace {

constexpr auto filters = std::to_array<Word<VkFilter>>({
    {"POINT", VK_FILTER_NEAREST},
    {"LINEAR", VK_FILTER_LINEAR},
});

enum class Mip { None, Point, Linear };

constexpr auto mipFilters = std::to_array<Word<Mip>>({
    {"NONE", Mip::None},
    {"POINT", Mip::Point},
    {"LINEAR", Mip::Linear},
});

constexpr auto addressModes = std::to_array<Word<VkSamplerAddressMode>>({
    {"WRAP", VK_SAMPLER_ADDRESS_MODE_REPEAT},
    {"MIRROR", VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT},
    {"CLAMP", VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE},
    {"BORDER", VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER},
});

template <class Value>
bool assign(Value& target, std::optional<Value> value) {
    if (value) target = *value;
    return value.has_value();
}

}  // namespace

Result<VkSamplerCreateInfo> samplerInfo(std::span<const permgen::State> states) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.borderColor = VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;  // Direct3D 9's default border
    Mip mip = Mip::None;
    for (const permgen::State& state : states) {
        const auto is = [&](std::string_view name) { return sameWord(state.name, name); };
        bool known = false;
        if (is("MinFilter"))
            known = assign(info.minFilter, lookUp(filters, state.value));
        else if (is("MagFilter"))
            known = assign(info.magFilter, lookUp(filters, state.value));
        else if (is("MipFilter"))
            known = assign(mip, lookUp(mipFilters, state.value));
        else if (is("AddressU"))
            known = assign(info.addressModeU, lookUp(addressModes, state.value));
        else if (is("AddressV"))
            known = assign(info.addressModeV, lookUp(addressModes, state.value));
        else if (is("AddressW"))
            known = assign(info.addressModeW, lookUp(addressModes, state.value));
        else if (is("Texture"))
            known = true;
        else
            return invalidArgument("the sampler state " + std::string(state.name) +
                                   " is not one that the renderer knows; remove it from the sampler");
        if (!known)
            return invalidArgument("the sampler state " + std::string(state.name) + " cannot be " +
                                   std::string(state.value) +
                                   " here; give it one of Direct3D 9's values that Vulkan has too");
    }
    info.mipmapMode = mip == Mip::Linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.maxLod = mip == Mip::None ? 0.0f : VK_LOD_CLAMP_NONE;
    return info;
}

}  // namespace tyndall
