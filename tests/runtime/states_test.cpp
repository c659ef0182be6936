// Direct3D 9's states and sampler states as Vulkan's, one row for each value.
#include "states.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "d3d9/states.h"
#include "samplers.h"

namespace tyndall {
namespace {

using permgen::State;
using permgen::StateId;
using permgen::ValueKind;

/// A state as an effect writes it; typed by permgen's own table.
struct Written {
    std::string_view name, value;
};

State typedOne(const Written& written) {
    const permgen::d3d9::StateRow* row = permgen::d3d9::find_state(written.name);
    if (!row) return {written.name, written.value};
    State state{row->name, written.value, row->id, 0, row->kind, 0};
    if (const permgen::d3d9::NamedValue* value = permgen::d3d9::find_value(*row, written.value))
        state.bits = value->bits;
    else
        state.bits = static_cast<std::uint32_t>(std::stoul(std::string(written.value), nullptr, 0));
    return state;
}

std::vector<State> typed(const std::vector<Written>& written) {
    std::vector<State> states;
    for (const Written& state : written) states.push_back(typedOne(state));
    return states;
}

PassStates mustRead(const std::vector<Written>& states) {
    const auto pass = passStates(typed(states));
    if (!pass) throw std::runtime_error(pass.error().message);
    return *pass;
}

TEST(States, DefaultsAreDirect3D9s) {
    const PassStates pass = mustRead({});
    EXPECT_EQ(pass.blend.blendEnable, VK_FALSE);
    EXPECT_EQ(pass.blend.colorWriteMask, 15u);
    EXPECT_TRUE(pass.depthTest);
    EXPECT_TRUE(pass.depthWrite);
    EXPECT_FALSE(pass.depthCompare);
    EXPECT_EQ(pass.cull, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
}

struct FactorRow {
    const char* word;
    VkBlendFactor colour, alpha;
};

class BlendFactors : public testing::TestWithParam<FactorRow> {};

TEST_P(BlendFactors, ReachColourAndAlphaOfTheRightSide) {
    const FactorRow row = GetParam();
    const PassStates source = mustRead({{"SrcBlend", row.word}});
    EXPECT_EQ(source.blend.srcColorBlendFactor, row.colour);
    EXPECT_EQ(source.blend.srcAlphaBlendFactor, row.alpha);
    EXPECT_EQ(source.blend.dstColorBlendFactor, VK_BLEND_FACTOR_ZERO);
    const PassStates destination = mustRead({{"DestBlend", row.word}});
    EXPECT_EQ(destination.blend.dstColorBlendFactor, row.colour);
    EXPECT_EQ(destination.blend.dstAlphaBlendFactor, row.alpha);
    EXPECT_EQ(destination.blend.srcColorBlendFactor, VK_BLEND_FACTOR_ONE);
}

INSTANTIATE_TEST_SUITE_P(
    , BlendFactors,
    testing::Values(FactorRow{"ZERO", VK_BLEND_FACTOR_ZERO, VK_BLEND_FACTOR_ZERO},
                    FactorRow{"ONE", VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ONE},
                    FactorRow{"SRCCOLOR", VK_BLEND_FACTOR_SRC_COLOR, VK_BLEND_FACTOR_SRC_ALPHA},
                    FactorRow{"INVSRCCOLOR", VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA},
                    FactorRow{"SRCALPHA", VK_BLEND_FACTOR_SRC_ALPHA, VK_BLEND_FACTOR_SRC_ALPHA},
                    FactorRow{"INVSRCALPHA", VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA, VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA},
                    FactorRow{"DESTALPHA", VK_BLEND_FACTOR_DST_ALPHA, VK_BLEND_FACTOR_DST_ALPHA},
                    FactorRow{"INVDESTALPHA", VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA, VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA},
                    FactorRow{"DESTCOLOR", VK_BLEND_FACTOR_DST_COLOR, VK_BLEND_FACTOR_DST_ALPHA},
                    FactorRow{"INVDESTCOLOR", VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR, VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA},
                    FactorRow{"SRCALPHASAT", VK_BLEND_FACTOR_SRC_ALPHA_SATURATE, VK_BLEND_FACTOR_SRC_ALPHA_SATURATE}),
    [](const auto& row) { return row.param.word; });

TEST(States, BlendOperations) {
    const std::vector<std::pair<const char*, VkBlendOp>> rows{{"ADD", VK_BLEND_OP_ADD},
                                                              {"SUBTRACT", VK_BLEND_OP_SUBTRACT},
                                                              {"REVSUBTRACT", VK_BLEND_OP_REVERSE_SUBTRACT},
                                                              {"MIN", VK_BLEND_OP_MIN},
                                                              {"MAX", VK_BLEND_OP_MAX}};
    for (const auto& [word, operation] : rows) {
        const PassStates pass = mustRead({{"BlendOp", word}});
        EXPECT_EQ(pass.blend.colorBlendOp, operation) << word;
        EXPECT_EQ(pass.blend.alphaBlendOp, operation) << word;
    }
}

TEST(States, AlphaHasItsOwnBlendOnlyWhereAsked) {
    const std::vector<Written> alpha{{"SrcBlend", "ONE"},
                                     {"SrcBlendAlpha", "ZERO"},
                                     {"DestBlend", "ONE"},
                                     {"DestBlendAlpha", "ZERO"},
                                     {"BlendOpAlpha", "MAX"}};
    EXPECT_EQ(mustRead(alpha).blend.srcAlphaBlendFactor, VK_BLEND_FACTOR_ONE);
    std::vector<Written> separate = alpha;
    separate.push_back({"SeparateAlphaBlendEnable", "TRUE"});
    const PassStates pass = mustRead(separate);
    EXPECT_EQ(pass.blend.srcAlphaBlendFactor, VK_BLEND_FACTOR_ZERO);
    EXPECT_EQ(pass.blend.dstAlphaBlendFactor, VK_BLEND_FACTOR_ZERO);
    EXPECT_EQ(pass.blend.alphaBlendOp, VK_BLEND_OP_MAX);
    EXPECT_EQ(pass.blend.srcColorBlendFactor, VK_BLEND_FACTOR_ONE);
    EXPECT_EQ(pass.blend.colorBlendOp, VK_BLEND_OP_ADD);
}

TEST(States, DepthComparisons) {
    const std::vector<std::pair<const char*, VkCompareOp>> rows{{"NEVER", VK_COMPARE_OP_NEVER},
                                                                {"LESS", VK_COMPARE_OP_LESS},
                                                                {"EQUAL", VK_COMPARE_OP_EQUAL},
                                                                {"LESSEQUAL", VK_COMPARE_OP_LESS_OR_EQUAL},
                                                                {"GREATER", VK_COMPARE_OP_GREATER},
                                                                {"NOTEQUAL", VK_COMPARE_OP_NOT_EQUAL},
                                                                {"GREATEREQUAL", VK_COMPARE_OP_GREATER_OR_EQUAL},
                                                                {"ALWAYS", VK_COMPARE_OP_ALWAYS}};
    for (const auto& [word, compare] : rows) EXPECT_EQ(mustRead({{"ZFunc", word}}).depthCompare, compare) << word;
}

TEST(States, Switches) {
    EXPECT_EQ(mustRead({{"AlphaBlendEnable", "TRUE"}}).blend.blendEnable, VK_TRUE);
    EXPECT_TRUE(mustRead({{"ZEnable", "FALSE"}, {"ZEnable", "TRUE"}}).depthTest) << "the later setting counts";
    EXPECT_FALSE(mustRead({{"ZEnable", "FALSE"}}).depthTest);
    EXPECT_FALSE(mustRead({{"ZWriteEnable", "FALSE"}}).depthWrite);
}

TEST(States, CullModeNamesTheWindingThatIsDropped) {
    EXPECT_EQ(mustRead({{"CullMode", "NONE"}}).cull, VkCullModeFlags{VK_CULL_MODE_NONE});
    EXPECT_EQ(mustRead({{"CullMode", "CW"}}).cull, VkCullModeFlags{VK_CULL_MODE_FRONT_BIT});
    EXPECT_EQ(mustRead({{"CullMode", "CCW"}}).cull, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
}

TEST(States, ColourMasksAreVulkansBits) {
    for (std::uint32_t mask = 0; mask <= 15; ++mask)
        EXPECT_EQ(mustRead({{"ColorWriteEnable", std::to_string(mask)}}).blend.colorWriteMask, mask);
    EXPECT_EQ(mustRead({{"ColorWriteEnable", "ALPHA"}}).blend.colorWriteMask,
              VkColorComponentFlags{VK_COLOR_COMPONENT_A_BIT});
}

std::string describe(const permgen::d3d9::StateRow& row, std::string_view value) {
    return std::string(row.name) + " = " + std::string(value);
}

bool accepts(const permgen::d3d9::StateRow& row, std::uint32_t bits, ValueKind kind) {
    const std::vector<State> states{{row.name, "?", row.id, 0, kind, bits}};
    if (row.scope == permgen::d3d9::Scope::Sampler) return samplerInfo(states).has_value();
    return passStates(states).has_value();
}

// The table defines the supported states; permgen warns of the rest.
TEST(StateTable, SaysWhatTheRendererDoes) {
    using permgen::d3d9::Support;
    for (const permgen::d3d9::StateRow& row : permgen::d3d9::states) {
        if (row.id == StateId::VertexShader || row.id == StateId::PixelShader) continue;  // never a pass's state
        for (const permgen::d3d9::NamedValue& value : row.values) {
            const bool drawn =
                row.support == Support::None || (row.support == Support::Fixed ? value.bits == row.fixed : value.drawn);
            EXPECT_EQ(accepts(row, value.bits, row.kind), drawn) << describe(row, value.name);
        }
        if (row.support == Support::Fixed) {
            EXPECT_TRUE(accepts(row, row.fixed, row.kind)) << row.name;
            EXPECT_FALSE(accepts(row, row.fixed ^ 1u, row.kind)) << row.name;
        }
        const bool mayBeComputed = row.support == Support::None || row.kind == ValueKind::Object;
        EXPECT_EQ(accepts(row, row.fixed, ValueKind::Expression), mayBeComputed) << row.name;
    }
}

struct BadRow {
    const char* name;
    Written state;
    const char* says;
};

class BadStates : public testing::TestWithParam<BadRow> {};

TEST_P(BadStates, AreNamed) {
    const auto pass = passStates(typed({{"AlphaBlendEnable", "TRUE"}, GetParam().state}));
    ASSERT_FALSE(pass);
    EXPECT_EQ(pass.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(pass.error().message.find(GetParam().says), std::string::npos) << pass.error().message;
}

INSTANTIATE_TEST_SUITE_P(, BadStates,
                         testing::Values(BadRow{"UnknownName", {"SrcBlnd", "ONE"}, "the state SrcBlnd is not"},
                                         BadRow{"EmptyName", {"", "ONE"}, "is not one"},
                                         BadRow{"UnknownFactor", {"SrcBlend", "99"}, "SrcBlend cannot be 99"},
                                         BadRow{"SwitchedToSeven", {"ZEnable", "7"}, "ZEnable cannot be 7"},
                                         BadRow{"UseW", {"ZEnable", "USEW"}, "ZEnable cannot be USEW"},
                                         BadRow{"Wireframe", {"FillMode", "WIREFRAME"}, "FillMode cannot be"},
                                         BadRow{"Stencil", {"StencilEnable", "TRUE"}, "StencilEnable cannot be"},
                                         BadRow{"AlphaTest", {"AlphaTestEnable", "TRUE"}, "AlphaTestEnable cannot be"},
                                         BadRow{"MaskTooLarge", {"ColorWriteEnable", "16"}, "cannot be 16"}),
                         [](const auto& row) { return row.param.name; });

TEST(SamplerStates, DefaultsAreDirect3D9s) {
    const auto info = samplerInfo({});
    ASSERT_TRUE(info);
    EXPECT_EQ(info->minFilter, VK_FILTER_NEAREST);
    EXPECT_EQ(info->magFilter, VK_FILTER_NEAREST);
    EXPECT_EQ(info->maxLod, 0.0f);
    EXPECT_EQ(info->addressModeU, VK_SAMPLER_ADDRESS_MODE_REPEAT);
    EXPECT_EQ(info->addressModeW, VK_SAMPLER_ADDRESS_MODE_REPEAT);
}

TEST(SamplerStates, EachWordReachesItsField) {
    std::vector<State> states = typed({{"MinFilter", "LINEAR"},
                                       {"MipFilter", "LINEAR"},
                                       {"AddressU", "CLAMP"},
                                       {"AddressV", "MIRROR"},
                                       {"AddressW", "BORDER"}});
    states.push_back({"Texture", "tex", StateId::Texture, 0, ValueKind::Object, 0});
    const auto info = samplerInfo(states);
    ASSERT_TRUE(info) << info.error().message;
    EXPECT_EQ(info->minFilter, VK_FILTER_LINEAR);
    EXPECT_EQ(info->magFilter, VK_FILTER_NEAREST);
    EXPECT_EQ(info->mipmapMode, VK_SAMPLER_MIPMAP_MODE_LINEAR);
    EXPECT_EQ(info->maxLod, VK_LOD_CLAMP_NONE);
    EXPECT_EQ(info->addressModeU, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
    EXPECT_EQ(info->addressModeV, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT);
    EXPECT_EQ(info->addressModeW, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER);
}

TEST(SamplerStates, TheMagnifyingFilterIsNotTheMinifyingOne) {
    const auto info = samplerInfo(typed(std::vector<Written>{{"MagFilter", "LINEAR"}}));
    ASSERT_TRUE(info);
    EXPECT_EQ(info->magFilter, VK_FILTER_LINEAR);
    EXPECT_EQ(info->minFilter, VK_FILTER_NEAREST);
}

TEST(SamplerStates, BadOnesAreNamed) {
    const auto message = [](const Written& state) {
        return samplerInfo(typed(std::vector<Written>{state})).error().message;
    };
    EXPECT_NE(message({"MinFilter", "ANISOTROPIC"}).find("MinFilter cannot be ANISOTROPIC"), std::string::npos);
    EXPECT_NE(message({"AddressU", "MIRRORONCE"}).find("AddressU cannot be MIRRORONCE"), std::string::npos);
    EXPECT_NE(message({"MiniFilter", "X"}).find("MiniFilter is not one"), std::string::npos);
    EXPECT_NE(message({"CullMode", "NONE"}).find("CullMode is not one"), std::string::npos);
}

}  // namespace
}  // namespace tyndall
