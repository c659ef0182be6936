#include "back/link.h"

#include <gtest/gtest.h>

#include "back/build_program.h"
#include "small_effect.h"

namespace permgen {
namespace {

/// Replaces `from`, which must occur.
void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

/// small_effect() whose second technique reads TEXCOORD1, through the noise.
Lowered reading_effect() {
    Lowered effect = test::small_effect();
    effect.techniques[1].passes[0].pixel.constants[0].bits = 1;
    return effect;
}

Diagnostics build(Lowered effect) {
    Diagnostics diagnostics;
    const auto program = build_program(std::move(effect), {}, diagnostics);
    EXPECT_EQ(program.has_value(), !has_errors(diagnostics));
    return diagnostics;
}

TEST(Link, WhatIsReadIsWritten) {
    EXPECT_TRUE(build(reading_effect()).empty());
}

TEST(Link, AVaryingThatNobodyWritesIsAnErrorWhereItIsRead) {
    Lowered effect = reading_effect();
    replace(effect.modules[0].hlsl, "[[vk::location(1)]] float3 at : TEXCOORD1;", "float unused : SV_ClipDistance0;");
    replace(effect.modules[0].hlsl, "o.at = p + gOffset;", "o.unused = gOffset.x;");
    effect.modules[0].outputs[1] = {"SV_CLIPDISTANCE0", true, 0, 1, ScalarType::Float, {}};
    const Diagnostics diagnostics = build(effect);
    ASSERT_EQ(diagnostics.size(), 1u) << "only the technique that reads it is wrong";
    EXPECT_EQ(format(diagnostics[0]),
              "small.fx:41:60: error[PG060]: 'ps_main' reads TEXCOORD1, but 'vs_main' writes only TEXCOORD0; write "
              "TEXCOORD1 in the vertex shader, or set the switches so that it is not read");
}

TEST(Link, AnotherTypeIsAnError) {
    Lowered effect = reading_effect();
    replace(effect.modules[0].hlsl, "float3 at : TEXCOORD1", "int3 at : TEXCOORD1");
    effect.modules[0].outputs[1].type = ScalarType::Int;
    const Diagnostics diagnostics = build(effect);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].code, "PG061");
    EXPECT_NE(diagnostics[0].message.find("reads TEXCOORD1 as float3, but 'vs_main' writes it as int3"),
              std::string::npos);
}

TEST(Link, FewerComponentsThanAreReadIsAnError) {
    Lowered effect = reading_effect();
    replace(effect.modules[0].hlsl, "float3 at : TEXCOORD1", "float2 at : TEXCOORD1");
    replace(effect.modules[0].hlsl, "o.at = p + gOffset;", "o.at = p.xy + gOffset.xy;");
    effect.modules[0].outputs[1].components = 2;
    const Diagnostics diagnostics = build(effect);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].code, "PG061");
}

TEST(Link, MoreComponentsThanAreReadIsFine) {
    Lowered effect = reading_effect();
    replace(effect.modules[0].hlsl, "float3 at : TEXCOORD1", "float4 at : TEXCOORD1");
    replace(effect.modules[0].hlsl, "o.at = p + gOffset;", "o.at = float4(p + gOffset, 1.0);");
    effect.modules[0].outputs[1].components = 4;
    EXPECT_TRUE(build(effect).empty());
}

TEST(Link, APassWithOneStageIsNotChecked) {
    Lowered effect = reading_effect();
    effect.techniques[1].passes[0].vertex.module = -1;
    EXPECT_TRUE(build(effect).empty());
}

TEST(Build, WhatOnlyOneStageUsesIsLive) {
    Lowered effect = test::small_effect();
    effect.modules[1].hlsl = test::pixel_text("return bCookie ? tex2D(CookieSampler, uv.xy) : uv;\n");
    Diagnostics diagnostics;
    const auto program = build_program(effect, {}, diagnostics);
    ASSERT_TRUE(program);
    EXPECT_EQ(program->passes[0][0].live, (std::vector<std::size_t>{0})) << "the vertex shader's";
    EXPECT_EQ(program->passes[1][0].live, (std::vector<std::size_t>{0, 1})) << "and the pixel shader's";
}

TEST(Build, LiveIsBothStagesTogetherInOrderOfResources) {
    Diagnostics diagnostics;
    const auto program = build_program(reading_effect(), {}, diagnostics);
    ASSERT_TRUE(program);
    EXPECT_EQ(program->passes[0][0].live, (std::vector<std::size_t>{0}));
    EXPECT_EQ(program->passes[1][0].live, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(program->resource_sizes, (std::vector<std::uint32_t>{112, 0, 0}));
    EXPECT_EQ(program->members.size(), 4u);
}

}  // namespace
}  // namespace permgen
