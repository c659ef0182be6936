// Compute shaders in an effect's text: their group, inputs, resources and generated entry point.
#include <gtest/gtest.h>

#include "front/lex.h"
#include "lowered_text.h"

namespace permgen {
namespace {

using test::LoweredEffect;

constexpr const char* shared_module = R"(
float4 tint;
RWTexture2D<float4> image;
cbuffer Rare { float gain; };
sampler2D cookie;
RWStructuredBuffer<float2> a, b : register(u3);
ByteAddressBuffer words;
[numthreads(8, 4, 2)]
void cs(uint3 id : SV_DispatchThreadID, uniform bool bright, uniform int steps) { image[id.xy] = bright ? steps : tint; }
technique one { pass p { ComputeShader = compile cs_5_0 cs(true, 2); } }
technique two { pass p { computeshader = compile CS_5_1 cs(false, -3); } }
)";

TEST(ComputeFront, TwoTechniquesShareOneModule) {
    const LoweredEffect result(shared_module);
    ASSERT_EQ(result.messages(), "");
    ASSERT_EQ(result.lowered.modules.size(), 1u);
    const LoweredModule& module = result.lowered.modules[0];
    EXPECT_EQ(module.stage, Stage::Compute);
    EXPECT_EQ(module.group_size, (std::array<std::uint32_t, 3>{8, 4, 2}));
    EXPECT_NE(module.hlsl.find("[numthreads(8, 4, 2)]\nvoid permgen_cs("), std::string::npos) << module.hlsl;
    EXPECT_EQ(module.hlsl.find("numthreads"), module.hlsl.rfind("numthreads"));
    ASSERT_EQ(module.axes.size(), 2u);
    for (const LoweredTechnique& technique : result.lowered.techniques) {
        EXPECT_EQ(technique.passes[0].compute.module, 0);
        EXPECT_EQ(technique.passes[0].vertex.module, -1);
        EXPECT_EQ(technique.passes[0].pixel.module, -1);
    }
    EXPECT_EQ(result.lowered.techniques[1].passes[0].compute.constants[1].bits, static_cast<std::uint32_t>(-3));
}

TEST(ComputeFront, StorageComesBehindTheOtherBindings) {
    const LoweredEffect result(shared_module);
    const char* names[] = {"Globals", "cookie", "Rare", "image", "a", "b", "words"};
    ASSERT_EQ(result.lowered.resources.size(), std::size(names));
    for (std::uint32_t i = 0; i < std::size(names); ++i) {
        EXPECT_EQ(result.lowered.resources[i].name, names[i]);
        EXPECT_EQ(result.lowered.resources[i].binding, i);
    }
    EXPECT_EQ(result.lowered.resources[3].kind, ResourceKind::StorageImage);
    EXPECT_EQ(result.lowered.resources[3].format, ImageFormat::Rgba32f);
    EXPECT_TRUE(result.lowered.resources[5].writable);
    EXPECT_FALSE(result.lowered.resources[6].writable);
}

TEST(ComputeFront, ProfilesWithOtherLimitsMakeOtherModules) {
    const LoweredEffect result(
        "RWStructuredBuffer<uint> a; [numthreads(64, 1, 1)] void cs(uint i : SV_GroupIndex) { a[i] = 1; }\n"
        "technique one { pass p { ComputeShader = compile cs_4_1 cs(); } pass q { ComputeShader = compile cs_5_0 cs(); "
        "} }");
    ASSERT_EQ(result.messages(), "");
    EXPECT_EQ(result.lowered.modules.size(), 2u);
}

struct InputCase {
    const char* name;
    const char* parameter;
    const char* semantic;
    unsigned components;
};
void PrintTo(const InputCase& input, std::ostream* out) {
    *out << input.name;
}

class ComputeInput : public testing::TestWithParam<InputCase> {};

TEST_P(ComputeInput, IsASystemValue) {
    const LoweredEffect result(std::string("struct Ids { uint3 group : SV_GroupID; uint index : SV_GroupIndex; };\n"
                                           "[numthreads(1, 1, 1)] void cs(") +
                               GetParam().parameter +
                               ") {}\ntechnique t { pass p { ComputeShader = compile cs_5_0 cs(); } }");
    ASSERT_EQ(result.messages(), "");
    const auto& inputs = result.lowered.modules.at(0).inputs;
    ASSERT_FALSE(inputs.empty());
    EXPECT_TRUE(inputs[0].builtin);
    EXPECT_EQ(inputs[0].semantic, GetParam().semantic);
    EXPECT_EQ(inputs[0].components, GetParam().components);
    EXPECT_EQ(inputs[0].type, ScalarType::Uint);
}

INSTANTIATE_TEST_SUITE_P(Lower, ComputeInput,
                         testing::Values(InputCase{"Thread", "uint3 i : SV_DispatchThreadID", "SV_DISPATCHTHREADID", 3},
                                         InputCase{"Two", "uint2 i : sv_dispatchthreadid", "SV_DISPATCHTHREADID", 3},
                                         InputCase{"Int", "int3 i : SV_GroupThreadID", "SV_GROUPTHREADID", 3},
                                         InputCase{"Struct", "Ids ids", "SV_GROUPID", 3},
                                         InputCase{"Index", "uint i : SV_GroupIndex", "SV_GROUPINDEX", 1}),
                         [](const auto& input) { return std::string(input.param.name); });

struct FormatCase {
    const char* type;
    ImageFormat format;
    ImageDimension dimension;
};

TEST(ComputeFront, TheElementGivesTheFormat) {
    for (const FormatCase& c :
         {FormatCase{"RWTexture1D<float>", ImageFormat::R32f, ImageDimension::One},
          FormatCase{"RWTexture2D<float2>", ImageFormat::Rg32f, ImageDimension::Two},
          FormatCase{"RWTexture3D<vector<float, 4> >", ImageFormat::Rgba32f, ImageDimension::Three},
          FormatCase{"RWTexture2D<half4>", ImageFormat::Rgba32f, ImageDimension::Two},
          FormatCase{"[[vk::image_format(\"rgba16f\")]] RWTexture2D<half4>", ImageFormat::Rgba16f, ImageDimension::Two},
          FormatCase{"[[vk::image_format(\"r8\")]] uniform RWTexture1D<float>", ImageFormat::R8, ImageDimension::One},
          FormatCase{"RWTexture2D<int>", ImageFormat::R32i, ImageDimension::Two},
          FormatCase{"RWTexture2D<int2>", ImageFormat::Rg32i, ImageDimension::Two},
          FormatCase{"RWTexture2D<int4>", ImageFormat::Rgba32i, ImageDimension::Two},
          FormatCase{"RWTexture2D<uint>", ImageFormat::R32ui, ImageDimension::Two},
          FormatCase{"RWTexture2D<uint2>", ImageFormat::Rg32ui, ImageDimension::Two},
          FormatCase{"RWTexture2D<uint4>", ImageFormat::Rgba32ui, ImageDimension::Two}}) {
        SCOPED_TRACE(c.type);
        const LoweredEffect result(std::string(c.type) +
                                   " image; [numthreads(1, 1, 1)] void cs() {}\n"
                                   "technique t { pass p { ComputeShader = compile cs_5_0 cs(); } }");
        ASSERT_EQ(result.messages(), "");
        EXPECT_EQ(result.lowered.resources.at(0).format, c.format);
        EXPECT_EQ(result.lowered.resources.at(0).dimension, c.dimension);
    }
}

TEST(ComputeFront, GroupsharedVariablesAreNotUniforms) {
    const LoweredEffect result(
        "groupshared float sums[64], lit; [numthreads(64, 1, 1)] void cs(uint i : SV_GroupIndex) { sums[i] = lit; }\n"
        "technique t { pass p { ComputeShader = compile cs_5_0 cs(); } }");
    ASSERT_EQ(result.messages(), "");
    EXPECT_TRUE(result.lowered.resources.empty());
    EXPECT_NE(result.lowered.modules.at(0).hlsl.find("groupshared float sums[64], lit;"), std::string::npos);
}

// Locals and parameters may have a resource's name; other functions' uses do not concern an entry point.
TEST(ComputeFront, OnlyWhatAnEntryPointReachesMatters) {
    const LoweredEffect result(R"(
RWTexture2D<float> image;
groupshared float sums[4];
sampler2D s;
float4 vs(float4 p : POSITION) : POSITION { float image = 1; return p * image; }
float helper(float sums) { return sums; }
float4 ps(float2 t : TEXCOORD0) : COLOR { clip(t.x); return tex2D(s, t) + ddx(t.x) + helper(t.y); }
float4 at(float2 t) { return tex2D(s, t, t, t) + tex2Dgrad(s, t, t, t) + tex2Dlod(s, t.xyyy); }
[numthreads(4, 1, 1)]
void cs(uint3 id : SV_DispatchThreadID) { sums[0] = at(id.xy).x; GroupMemoryBarrierWithGroupSync(); image[id.xy] = sums[0]; }
technique draw { pass p { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps(); } }
technique compute { pass p { ComputeShader = compile cs_5_0 cs(); } }
)");
    EXPECT_EQ(result.messages(), "");
}

TEST(ComputeFront, StatesOfAComputePassHaveNoEffect) {
    const LoweredEffect result(
        "[numthreads(1, 1, 1)] void cs() {}\n"
        "technique t { pass p { ComputeShader = compile cs_5_0 cs(); ZEnable = FALSE; } }");
    ASSERT_EQ(result.diagnostics.size(), 1u) << result.messages();
    EXPECT_EQ(result.diagnostics[0].code, "PG045");
    EXPECT_EQ(result.diagnostics[0].severity, Severity::Warning);
}

// Every text of up to the whole attribute, cut anywhere or with one token exchanged, ends in a diagnostic.
TEST(ComputeFront, BrokenGroupsNeverCrash) {
    const std::string good = "[numthreads(8,8,1)]void cs(uint3 i:SV_DispatchThreadID){}";
    const std::string technique = "\ntechnique t{pass p{ComputeShader=compile cs_5_0 cs();}}";
    for (std::size_t cut = 0; cut <= good.size(); ++cut) {
        LoweredEffect(good.substr(0, cut));
        LoweredEffect(good.substr(0, cut) + technique);
        LoweredEffect(good.substr(cut) + technique);
        for (const char* inserted :
             {"[", "]", "(", ")", ",", "-", "<", ">", "0", "4294967296", "99999999999999999999999", "1e9",
              "RWTexture2D", "groupshared", "\"", "numthreads"})
            LoweredEffect(good.substr(0, cut) + inserted + good.substr(cut) + technique);
    }
}

TEST(ComputeFront, BrokenStorageNeverCrashes) {
    const std::string good =
        "[[vk::image_format(\"rgba8\")]]RWTexture2D<float4> a:register(u0),b;RWByteAddressBuffer c;groupshared uint "
        "d[4];";
    for (std::size_t cut = 0; cut <= good.size(); ++cut) {
        LoweredEffect(good.substr(0, cut));
        LoweredEffect(good.substr(cut));
        for (const char* inserted : {"[", "]", "<", ">", ",", ";", "=", "=1", "static ", "StructuredBuffer ", "void"})
            LoweredEffect(good.substr(0, cut) + inserted + good.substr(cut));
    }
}

}  // namespace
}  // namespace permgen
