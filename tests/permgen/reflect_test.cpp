#include "back/reflect.h"

#include <gtest/gtest.h>

#include <spirv/unified1/spirv.hpp>

#include "back/compile.h"

namespace permgen {
namespace {

Reflection reflection_of(Stage stage, const std::string& hlsl) {
    const CompileResult compiled = compile_hlsl(stage, "entry", hlsl);
    EXPECT_FALSE(compiled.code.empty()) << compiled.log;
    ReflectResult result = reflect(compiled.code);
    EXPECT_EQ(result.reason, "");
    return result.reflection.value_or(Reflection{});
}

const std::string block =
    "[[vk::binding(3, 1)]] cbuffer Globals { float4x4 m; float3x3 n; float4 list[5]; float2 a; float b; int c; "
    "float last[3]; float2x4 r; };\n";

TEST(Reflect, BlocksAreDescribedByTheirDecorations) {
    const Reflection reflection = reflection_of(
        Stage::Pixel,
        block + "float4 entry() : SV_Target0 { return m[0] + list[4] + a.x + b + c + n[0].x + last[2] + r[1]; }\n");
    ASSERT_EQ(reflection.resources.size(), 1u);
    const ReflectedResource& globals = reflection.resources[0];
    EXPECT_EQ(globals.name, "Globals");
    EXPECT_EQ(globals.kind, ResourceKind::UniformBuffer);
    EXPECT_EQ(globals.dimension, ImageDimension::None);
    EXPECT_EQ(globals.set, 1u);
    EXPECT_EQ(globals.binding, 3u);
    // HLSL keeps matrices by columns; each column (four of a float2x4) and each array element takes 16 bytes; a float2,
    // float and int fill one more.
    EXPECT_EQ(globals.size, 64u + 48u + 80u + 16u + 48u + 64u);
    const std::vector<ReflectedMember> expected = {
        {"Globals", "m", 0, 64},  {"Globals", "n", 64, 48}, {"Globals", "list", 112, 80}, {"Globals", "a", 192, 8},
        {"Globals", "b", 200, 4}, {"Globals", "c", 204, 4}, {"Globals", "last", 208, 48}, {"Globals", "r", 256, 64}};
    EXPECT_EQ(reflection.members, expected);
}

TEST(Reflect, SamplersHaveADimension) {
    const Reflection reflection = reflection_of(
        Stage::Pixel,
        "[[vk::binding(4)]] samplerCUBE d; [[vk::binding(3)]] sampler3D c; [[vk::binding(2)]] sampler2D b;\n"
        "[[vk::binding(1)]] sampler1D a;\n"
        "float4 entry([[vk::location(0)]] float3 t : TEXCOORD0) : SV_Target0\n"
        "{ return tex1D(a, t.x) + tex2D(b, t.xy) + tex3D(c, t) + texCUBE(d, t); }\n");
    ASSERT_EQ(reflection.resources.size(), 4u);
    const ImageDimension dimensions[] = {ImageDimension::One, ImageDimension::Two, ImageDimension::Three,
                                         ImageDimension::Cube};
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_EQ(reflection.resources[i].binding, i + 1);
        EXPECT_EQ(reflection.resources[i].dimension, dimensions[i]);
        EXPECT_EQ(reflection.resources[i].name, std::string(1, static_cast<char>('a' + i)));
        EXPECT_EQ(reflection.resources[i].kind, ResourceKind::CombinedImageSampler);
    }
}

TEST(Reflect, InterfacesAreSortedByLocation) {
    const Reflection reflection = reflection_of(
        Stage::Vertex,
        "struct O { [[vk::location(5)]] float2 b : TEXCOORD1; [[vk::location(2)]] float a : TEXCOORD0;\n"
        "  float4 p : SV_Position; float4 c0 : SV_ClipDistance0; float4 c1 : SV_ClipDistance1; };\n"
        "O entry([[vk::location(4)]] int2 i : BLENDINDICES0, [[vk::location(0)]] float3x4 m : TEXCOORD0,\n"
        "        uint id : SV_VertexID)\n"
        "{ O o; o.p = m[0] + m[1] + m[2] + i.x + id; o.a = 1.0; o.b = 2.0; o.c0 = o.p; o.c1 = o.p; return o; }\n");
    EXPECT_EQ(reflection.entry, "entry");
    EXPECT_EQ(reflection.stage, Stage::Vertex);
    ASSERT_EQ(reflection.inputs.size(), 5u);
    for (std::uint32_t row = 0; row < 3; ++row) {
        EXPECT_EQ(reflection.inputs[row].location, row);
        EXPECT_EQ(reflection.inputs[row].components, 4u);
    }
    EXPECT_EQ(reflection.inputs[3].location, 4u);
    EXPECT_EQ(reflection.inputs[3].type, ScalarType::Int);
    EXPECT_EQ(reflection.inputs[3].components, 2u);
    EXPECT_TRUE(reflection.inputs[4].builtin);
    EXPECT_EQ(reflection.inputs[4].builtin_kind, spv::BuiltInVertexIndex);

    ASSERT_EQ(reflection.outputs.size(), 4u);
    EXPECT_EQ(reflection.outputs[0].location, 2u);
    EXPECT_EQ(reflection.outputs[0].components, 1u);
    EXPECT_EQ(reflection.outputs[1].location, 5u);
    EXPECT_EQ(reflection.outputs[1].components, 2u);
    EXPECT_EQ(reflection.outputs[2].builtin_kind, spv::BuiltInPosition);
    EXPECT_EQ(reflection.outputs[3].builtin_kind, spv::BuiltInClipDistance);
    EXPECT_EQ(reflection.outputs[3].components, 8u) << "two float4 are eight distances";
}

TEST(Reflect, SwitchesHaveTypeAndDefault) {
    const Reflection reflection =
        reflection_of(Stage::Pixel,
                      "[[vk::constant_id(7)]] const float f = 1.5; [[vk::constant_id(2)]] const bool b = true;\n"
                      "[[vk::constant_id(3)]] const int i = -2; [[vk::constant_id(4)]] const uint u = 9;\n"
                      "float4 g(float a, bool c, int d, uint e) { return c ? a * d : a * e; }\n"
                      "float4 entry() : SV_Target0 { return g(f, b, i, u); }\n");
    ASSERT_EQ(reflection.constants.size(), 4u);
    const std::tuple<std::uint32_t, ScalarType, std::uint32_t> expected[] = {{2, ScalarType::Bool, 1},
                                                                             {3, ScalarType::Int, 0xfffffffeu},
                                                                             {4, ScalarType::Uint, 9},
                                                                             {7, ScalarType::Float, 0x3fc00000u}};
    for (std::size_t i = 0; i < 4; ++i) {
        const ReflectedConstant& constant = reflection.constants[i];
        EXPECT_EQ(std::tuple(constant.id, constant.type, constant.default_bits), expected[i]);
    }
}

TEST(Reflect, WhatTheTablesCannotSayIsRefused) {
    const CompileResult compiled = compile_hlsl(
        Stage::Pixel, "entry", "RWBuffer<float> texels; float4 entry() : SV_Target0 { return texels[0]; }\n");
    ASSERT_FALSE(compiled.code.empty()) << compiled.log;
    EXPECT_EQ(reflect(compiled.code).reason, "'texels' is not of a 1D, 2D, 3D or cube image");
}

TEST(Reflect, WhatIsNoModuleIsRefused) {
    EXPECT_EQ(reflect({}).reason, "it is not a SPIR-V module");
    const std::vector<std::uint32_t> junk(12, 0x12345678u);
    EXPECT_EQ(reflect(junk).reason, "it is not a SPIR-V module");
    const CompileResult compiled = compile_hlsl(Stage::Pixel, "entry", "float4 entry() : SV_Target0 { return 1.0; }\n");
    auto cut = compiled.code;
    cut.back() = 9u << 16 | spv::OpNop;  // an instruction longer than what is left
    EXPECT_EQ(reflect(cut).reason, "it is not a SPIR-V module");
}

}  // namespace
}  // namespace permgen
