// Direct3D 9's states and sampler states in Vulkan's words, one row for each word.
#include "states.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "samplers.h"

namespace tyndall {
namespace {

using permgen::State;

PassStates mustRead(std::vector<State> states) {
    const auto pass = passStates(states);
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
    const std::vector<State> alpha{{"SrcBlend", "ONE"},
                                   {"SrcBlendAlpha", "ZERO"},
                                   {"DestBlend", "ONE"},
                                   {"DestBlendAlpha", "ZERO"},
                                   {"BlendOpAlpha", "MAX"}};
    EXPECT_EQ(mustRead(alpha).blend.srcAlphaBlendFactor, VK_BLEND_FACTOR_ONE);
    std::vector<State> separate = alpha;
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

TEST(States, SwitchesReadWordsAndNumbersInAnyCase) {
    for (const char* on : {"TRUE", "true", "1"}) {
        EXPECT_EQ(mustRead({{"AlphaBlendEnable", on}}).blend.blendEnable, VK_TRUE) << on;
        EXPECT_TRUE(mustRead({{"ZEnable", "FALSE"}, {"ZENABLE", on}}).depthTest) << on;
    }
    for (const char* off : {"FALSE", "False", "0"}) {
        EXPECT_FALSE(mustRead({{"ZEnable", off}}).depthTest) << off;
        EXPECT_FALSE(mustRead({{"ZWriteEnable", off}}).depthWrite) << off;
    }
}

TEST(States, CullModeNamesTheWindingThatIsDropped) {
    EXPECT_EQ(mustRead({{"CullMode", "NONE"}}).cull, VkCullModeFlags{VK_CULL_MODE_NONE});
    EXPECT_EQ(mustRead({{"CullMode", "CW"}}).cull, VkCullModeFlags{VK_CULL_MODE_FRONT_BIT});
    EXPECT_EQ(mustRead({{"CullMode", "CCW"}}).cull, VkCullModeFlags{VK_CULL_MODE_BACK_BIT});
}

TEST(States, ColourMasksAreNumbersOrWords) {
    const std::vector<std::pair<const char*, VkColorComponentFlags>> rows{
        {"0", 0},     {"7", 7},        {"15", 15},
        {"0x0F", 15}, {"0xa", 10},     {"RED", 1},
        {"ALPHA", 8}, {"RED|BLUE", 5}, {"RED | GREEN | BLUE", 7}};
    for (const auto& [value, mask] : rows)
        EXPECT_EQ(mustRead({{"ColorWriteEnable", value}}).blend.colorWriteMask, mask) << value;
}

struct BadRow {
    const char* name;
    State state;
    const char* says;
};

class BadStates : public testing::TestWithParam<BadRow> {};

TEST_P(BadStates, AreNamed) {
    const std::vector<State> states{{"AlphaBlendEnable", "TRUE"}, GetParam().state};
    const auto pass = passStates(states);
    ASSERT_FALSE(pass);
    EXPECT_EQ(pass.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(pass.error().message.find(GetParam().says), std::string::npos) << pass.error().message;
}

INSTANTIATE_TEST_SUITE_P(, BadStates,
                         testing::Values(BadRow{"UnknownName", {"SrcBlnd", "ONE"}, "the state SrcBlnd is not"},
                                         BadRow{"EmptyName", {"", "ONE"}, "is not one"},
                                         BadRow{"UnknownFactor", {"SrcBlend", "TWO"}, "SrcBlend cannot be TWO"},
                                         BadRow{"EmptyValue", {"DestBlend", ""}, "DestBlend cannot be"},
                                         BadRow{"SwitchedToSeven", {"ZEnable", "7"}, "ZEnable cannot be 7"},
                                         BadRow{"UseW", {"ZEnable", "USEW"}, "ZEnable cannot be USEW"},
                                         BadRow{"Wireframe", {"FillMode", "WIREFRAME"}, "FillMode cannot be"},
                                         BadRow{"Stencil", {"StencilEnable", "TRUE"}, "StencilEnable cannot be"},
                                         BadRow{"MaskTooLarge", {"ColorWriteEnable", "16"}, "cannot be 16"},
                                         BadRow{"MaskEndless", {"ColorWriteEnable", "99999999999"}, "cannot be 9"},
                                         BadRow{"MaskDangling", {"ColorWriteEnable", "RED|"}, "cannot be RED|"}),
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
    const std::vector<State> states{{"MinFilter", "LINEAR"}, {"MipFilter", "LINEAR"}, {"AddressU", "CLAMP"},
                                    {"AddressV", "MIRROR"},  {"AddressW", "BORDER"},  {"Texture", "<tex>"}};
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
    const std::vector<State> states{{"MagFilter", "LINEAR"}};
    const auto info = samplerInfo(states);
    ASSERT_TRUE(info);
    EXPECT_EQ(info->magFilter, VK_FILTER_LINEAR);
    EXPECT_EQ(info->minFilter, VK_FILTER_NEAREST);
}

TEST(SamplerStates, BadOnesAreNamed) {
    const std::vector<State> filter{{"MinFilter", "CUBIC"}}, address{{"AddressU", "AROUND"}}, name{{"MiniFilter", "X"}};
    EXPECT_NE(samplerInfo(filter).error().message.find("MinFilter cannot be CUBIC"), std::string::npos);
    EXPECT_NE(samplerInfo(address).error().message.find("AddressU cannot be AROUND"), std::string::npos);
    EXPECT_NE(samplerInfo(name).error().message.find("MiniFilter"), std::string::npos);
}

}  // namespace
}  // namespace tyndall
