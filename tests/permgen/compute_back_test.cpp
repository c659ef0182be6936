// Compute shaders as SPIR-V: what the modules say of themselves, what is live in each technique, what glslang drops.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <spirv/unified1/spirv.hpp>

#include "back/build_program.h"
#include "back/validate.h"
#include "common/names.h"
#include "common/spirv_module.h"
#include "d3d9/image_formats.h"
#include "emit/emit.h"
#include "emit/list_effect.h"
#include "lowered_text.h"

namespace permgen {
namespace {

struct Built {
    Diagnostics diagnostics;
    std::optional<Program> program;

    explicit Built(const std::string& text) {
        test::LoweredEffect effect(text);
        diagnostics = effect.diagnostics;
        if (has_errors(diagnostics)) return;
        effect.lowered.name = "t";
        program = build_program(std::move(effect.lowered), {}, diagnostics);
    }
    std::string messages() const {
        std::string text;
        for (const Diagnostic& diagnostic : diagnostics) text += format(diagnostic) + '\n';
        return text;
    }
    std::string live(std::size_t technique) const {
        std::string names;
        for (const std::size_t index : program->passes[technique][0].live)
            names += (names.empty() ? "" : " ") + program->effect.resources[index].name;
        return names;
    }
};

std::size_t opcodes(const SpirvWords& code, spv::Op opcode) {
    std::size_t found = 0;
    for_each_instruction(code, [&](const SpirvInstruction& instruction) { found += instruction.opcode == opcode; });
    return found;
}

constexpr const char* two_techniques = R"(
float4 tint;
sampler2D cookie;
struct Cell { float3 sum; float weights[3]; float2x2 turn; uint lit; };
RWTexture2D<float4> image;
RWTexture3D<float> volume;
StructuredBuffer<Cell> cells;
RWStructuredBuffer<float> sums;
RWByteAddressBuffer total;
groupshared float4 texels[64];

[numthreads(8, 4, 2)]
void cs(uint3 id : SV_DispatchThreadID, uint index : SV_GroupIndex, uniform bool deep, uniform bool counted)
{
    texels[index] = tex2Dlod(cookie, float4(id.xy, 0, 0)) * tint;
    GroupMemoryBarrierWithGroupSync();
    float4 sum = 0;
    for (uint i = 0; i < 64; ++i)
        sum += texels[i];
    image[id.xy] = sum;
    if (deep)
        volume[id] = sum.x + cells[id.x].turn[1][0];
    if (counted) {
        uint before;
        total.InterlockedAdd(0, 1u, before);
        sums[id.x] = before;
    }
}
technique flat { pass p { ComputeShader = compile cs_5_0 cs(false, false); } }
technique deep { pass p { ComputeShader = compile cs_5_0 cs(true, false); } }
technique counted { pass p { ComputeShader = compile cs_5_0 cs(false, true); } }
)";

TEST(ComputeBack, LiveStorageFollowsTheSwitches) {
    const Built built(two_techniques);
    ASSERT_EQ(built.messages(), "");
    EXPECT_EQ(built.live(0), "Globals cookie image");
    EXPECT_EQ(built.live(1), "Globals cookie image volume cells");
    EXPECT_EQ(built.live(2), "Globals cookie image sums total");
}

TEST(ComputeBack, TheModuleKeepsItsGroupAndFormats) {
    const Built built(two_techniques);
    ASSERT_EQ(built.messages(), "");
    ASSERT_EQ(built.program->modules.size(), 1u);
    for (const Reflection* reflection :
         {&built.program->modules[0].reflection, &built.program->passes[1][0].compute.reflection}) {
        EXPECT_EQ(reflection->stage, Stage::Compute);
        EXPECT_EQ(reflection->group_size, (std::array<std::uint32_t, 3>{8, 4, 2}));
    }
    std::set<std::uint32_t> bindings;
    for (const ReflectedResource& resource : built.program->modules[0].reflection.resources) {
        EXPECT_TRUE(bindings.insert(resource.binding).second) << resource.name;
        if (resource.name == "image") {
            EXPECT_EQ(resource.format, ImageFormat::Rgba32f);
        }
        if (resource.name == "volume") {
            EXPECT_EQ(resource.format, ImageFormat::R32f);
        }
        if (resource.name == "volume") {
            EXPECT_EQ(resource.dimension, ImageDimension::Three);
        }
        EXPECT_EQ(resource.writable,
                  resource.name != "Globals" && resource.name != "cookie" && resource.name != "cells")
            << resource.name;
    }
    EXPECT_EQ(bindings.size(), 7u);
}

// std430: a float3 is aligned to 16 bytes, an array of floats is not padded.
TEST(ComputeBack, ElementsHaveASizeAndMembers) {
    const Built built(two_techniques);
    ASSERT_EQ(built.messages(), "");
    const Program& program = *built.program;
    for (std::size_t i = 0; i < program.effect.resources.size(); ++i) {
        const std::string& name = program.effect.resources[i].name;
        if (name == "cells") {
            EXPECT_EQ(program.resource_sizes[i], 48u);
        }
        if (name == "sums" || name == "total") {
            EXPECT_EQ(program.resource_sizes[i], 4u);
        }
        if (name == "image") {
            EXPECT_EQ(program.resource_sizes[i], 0u);
        }
    }
    std::vector<ReflectedMember> cell;
    std::copy_if(program.members.begin(), program.members.end(), std::back_inserter(cell),
                 [](const ReflectedMember& member) { return member.block == "cells"; });
    const std::vector<ReflectedMember> expected = {
        {"cells", "sum", 0, 12}, {"cells", "weights", 12, 12}, {"cells", "turn", 24, 16}, {"cells", "lit", 40, 4}};
    EXPECT_EQ(cell, expected);
}

// Dead code elimination must not take what other threads read.
TEST(ComputeBack, FrozenModulesKeepBarriersSharedMemoryAndAtomics) {
    const Built built(two_techniques);
    ASSERT_EQ(built.messages(), "");
    for (const auto& technique : built.program->passes) {
        const SpirvWords& code = technique[0].compute.code;
        EXPECT_EQ(validate_spirv(code), "");
        EXPECT_EQ(opcodes(code, spv::OpControlBarrier), 1u);
        EXPECT_EQ(opcodes(code, spv::OpLoopMerge), 1u);
        SpirvModule module;
        ASSERT_TRUE(parse_spirv(code, module));
        EXPECT_EQ(std::count_if(module.variables.begin(), module.variables.end(),
                                [](const auto& v) { return v.storage == spv::StorageClassWorkgroup; }),
                  1);
    }
    EXPECT_EQ(opcodes(built.program->passes[0][0].compute.code, spv::OpImageWrite), 1u);
    EXPECT_EQ(opcodes(built.program->passes[1][0].compute.code, spv::OpImageWrite), 2u);
    EXPECT_EQ(opcodes(built.program->passes[0][0].compute.code, spv::OpAtomicIAdd), 0u);
    EXPECT_EQ(opcodes(built.program->passes[2][0].compute.code, spv::OpAtomicIAdd), 1u);
}

TEST(ComputeBack, EmitsGroupStageAndFrozenFiles) {
    const Built built(two_techniques);
    ASSERT_EQ(built.messages(), "");
    const std::string header = emit_header(*built.program, {"t", true});
    EXPECT_NE(header.find("permgen::Stage::Compute"), std::string::npos);
    EXPECT_NE(header.find(", {8u, 4u, 2u}};"), std::string::npos);
    EXPECT_NE(header.find("permgen::ResourceKind::StorageImage, permgen::ImageDimension::Three"), std::string::npos);
    const std::string manifest = emit_manifest(*built.program, {"t", true});
    EXPECT_NE(manifest.find("\"format\": \"rgba32f\""), std::string::npos);
    EXPECT_NE(manifest.find("\"frozen\": \"t.deep.0-p.compute.spv\""), std::string::npos);
    std::set<std::string> paths;
    for (const OutputFile& file : emit_files(*built.program, {"t", true})) paths.insert(file.path);
    EXPECT_TRUE(paths.contains("t.counted.0-p.compute.spv"));
    EXPECT_NE(list_table(*built.program).find("cs(true, false) [8, 4, 2]"), std::string::npos);
    EXPECT_NE(list_json(*built.program).find("\"group_size\""), std::string::npos);
}

// Effects without compute shaders list as before.
TEST(ComputeBack, TheListShowsComputeShadersWhereThereAreSome) {
    const Built built(
        "float4 vs(float4 p : POSITION) : POSITION { return p; }\n"
        "technique t { pass p { VertexShader = compile vs_3_0 vs(); } }");
    ASSERT_TRUE(built.program) << built.messages();
    EXPECT_EQ(list_table(*built.program).find("compute"), std::string::npos);
}

struct Statement {
    const char* name;
    const char* text;
    spv::Op opcode;
};
void PrintTo(const Statement& statement, std::ostream* out) {
    *out << statement.name;
}

class ComputeStatement : public testing::TestWithParam<Statement> {};

TEST_P(ComputeStatement, SurvivesCompilation) {
    const Built built(
        std::string(R"(struct Pair { float a; uint b; };
RWTexture1D<float> line; RWTexture2D<float4> image; RWTexture2D<uint> counts; RWTexture3D<int2> cube;
RWStructuredBuffer<float> point; RWStructuredBuffer<uint> heads; StructuredBuffer<float4> given;
RWByteAddressBuffer bytes; ByteAddressBuffer words; groupshared uint lit; groupshared int least;
groupshared Pair pairs[4];
)") +
        "void add(inout float x, out float y) { x += 1; y = x; }\n"
        "[numthreads(4, 1, 1)] void cs(uint3 id : SV_DispatchThreadID, uint3 g : SV_GroupID,\n"
        "uint3 t : SV_GroupThreadID, uint i : SV_GroupIndex) {\nuint o = 0;\n" +
        GetParam().text +
        "\nheads[9] = o + g.x + t.y + i;\n}\ntechnique t { pass p { ComputeShader = compile cs_5_0 cs(); } }");
    ASSERT_TRUE(built.program) << built.messages();
    EXPECT_GE(opcodes(built.program->passes[0][0].compute.code, GetParam().opcode), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    All, ComputeStatement,
    testing::Values(
        Statement{"WriteLine", "line[id.x] = 2;", spv::OpImageWrite},
        Statement{"WriteCube", "cube[id] = int2(1, -1);", spv::OpImageWrite},
        Statement{"Compound", "image[id.xy] += 1; counts[id.xy]++; point[id.x] *= 2;", spv::OpImageRead},
        Statement{"Load", "image[id.xy] = given[id.x] + image.Load(int2(id.yx)); o = words.Load(4);", spv::OpImageRead},
        Statement{"Bytes",
                  "bytes.Store4(16, words.Load4(0)); bytes.Store(4, asuint(id.x * 0.5)); o = bytes.Load2(4).y;",
                  spv::OpBitcast},
        Statement{"Dimensions",
                  "uint w, h; image.GetDimensions(w, h); uint n, s; point.GetDimensions(n, s); o = w + n;",
                  spv::OpImageQuerySize},
        Statement{"Shared", "InterlockedAdd(lit, 1u, o);", spv::OpAtomicIAdd},
        Statement{"SharedMin", "InterlockedMin(least, -3);", spv::OpAtomicSMin},
        Statement{"SharedStruct", "pairs[i].b = i; GroupMemoryBarrierWithGroupSync(); o = pairs[3 - i].b;",
                  spv::OpControlBarrier},
        Statement{"Texel", "InterlockedMax(counts[id.xy], 3u, o);", spv::OpAtomicUMax},
        Statement{"Element", "InterlockedExchange(heads[id.x], 3u, o);", spv::OpAtomicExchange},
        Statement{"Compare", "InterlockedCompareExchange(lit, 1u, 2u, o);", spv::OpAtomicCompareExchange},
        Statement{"Method", "bytes.InterlockedOr(4, 3u, o);", spv::OpAtomicOr},
        Statement{"InoutElement", "float y; add(point[id.x], y); line[1] = y;", spv::OpImageWrite},
        Statement{"OutTexel", "float x = 1; add(x, line[id.x]);", spv::OpImageWrite},
        Statement{"DeviceBarrier", "DeviceMemoryBarrier(); AllMemoryBarrierWithGroupSync();", spv::OpMemoryBarrier}),
    [](const auto& statement) { return std::string(statement.param.name); });

// glslang makes a module without the statement, and says so only in its log.
TEST(ComputeBack, WhatTheCompilerDropsIsAnError) {
    Diagnostics diagnostics;
    test::LoweredEffect effect(
        "groupshared uint n; [numthreads(1, 1, 1)] void cs() { InterlockedExchange(n, 1u, n); }\n"
        "technique t { pass p { ComputeShader = compile cs_5_0 cs(); } }");
    ASSERT_EQ(effect.messages(), "");
    std::string& hlsl = effect.lowered.modules[0].hlsl;
    hlsl.replace(hlsl.find("InterlockedExchange(n, 1u, n)"), 29, "InterlockedCompareStore(n,1u,2u)");
    EXPECT_FALSE(build_program(std::move(effect.lowered), {}, diagnostics));
    ASSERT_FALSE(diagnostics.empty());
    EXPECT_EQ(diagnostics[0].code, "PG050");
    EXPECT_NE(diagnostics[0].message.find("cannot translate part of this entry point"), std::string::npos);
}

// The attribute of every format reaches the SPIR-V; build_program() compares the two.
TEST(ComputeBack, EveryImageFormatReachesTheSpirv) {
    std::string declarations, body;
    for (const d3d9::ImageFormatRow& row : d3d9::image_formats) {
        const std::string name(row.name);
        declarations += "[[vk::image_format(\"" + name + "\")]] RWTexture2D<" + type_name(row.scalar, row.components) +
                        "> image_" + name + ";\n";
        body += "image_" + name + "[id] = 1; ";
    }
    const Built built(declarations + "[numthreads(8, 8, 1)] void cs(uint2 id : SV_DispatchThreadID) { " + body +
                      "}\ntechnique t { pass p { ComputeShader = compile cs_5_0 cs(); } }");
    ASSERT_TRUE(built.program) << built.messages();
    for (const ReflectedResource& resource : built.program->modules.at(0).reflection.resources)
        EXPECT_EQ("image_" + std::string(format_name(resource.format)), resource.name);
}

// Every module is made from the whole text, but only compute modules may have groupshared variables.
TEST(ComputeBack, AnEffectMayDrawAndCompute) {
    const Built built(
        "groupshared\nuint lit; float groupshared_area; precise groupshared float4 sums[4]; RWTexture2D<float4> "
        "image;\n"
        "float4 vs(float4 p : POSITION) : POSITION { return p; }\n"
        "float4 ps() : COLOR { return 1; }\n"
        "[numthreads(4, 1, 1)] void cs(uint i : SV_GroupIndex) {\n"
        "    uint before; InterlockedAdd(lit, 1u, before); sums[i] = 1; GroupMemoryBarrierWithGroupSync();\n"
        "    image[uint2(i, lit)] = sums[3 - i]; }\n"
        "technique draw { pass p { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps(); } }\n"
        "technique sum { pass p { ComputeShader = compile cs_5_0 cs(); } }");
    ASSERT_TRUE(built.program) << built.messages();
    EXPECT_EQ(built.live(0), "");
    EXPECT_EQ(built.live(1), "image");
    for (const CompiledModule& module : built.program->modules) EXPECT_EQ(validate_spirv(module.code), "");
}

TEST(ComputeBack, APixelShaderMayReadBuffers) {
    const Built built(
        "StructuredBuffer<float4> colours; ByteAddressBuffer words;\n"
        "float4 vs(float4 p : POSITION) : POSITION { return p; }\n"
        "float4 ps() : COLOR { return colours[words.Load(0)]; }\n"
        "technique t { pass p { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps(); } }");
    ASSERT_TRUE(built.program) << built.messages();
    EXPECT_EQ(built.live(0), "colours words");
}

TEST(ComputeBack, AnotherGroupInTheSpirvIsAnError) {
    Diagnostics diagnostics;
    test::LoweredEffect effect(
        "[numthreads(8, 4, 2)] void cs() {}\n"
        "technique t { pass p { ComputeShader = compile cs_5_0 cs(); } }");
    effect.lowered.modules.at(0).group_size = {4, 8, 2};
    EXPECT_FALSE(build_program(std::move(effect.lowered), {}, diagnostics));
    ASSERT_FALSE(diagnostics.empty());
    EXPECT_EQ(diagnostics[0].code, "PG056");
}

}  // namespace
}  // namespace permgen
