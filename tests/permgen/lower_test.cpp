#include "lower/lower.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "back/compile.h"
#include "front/parse.h"

namespace permgen {
namespace {

struct Result {
    Sources sources;
    Diagnostics diagnostics;
    Lowered lowered;

    explicit Result(std::string_view text) {
        sources.files.push_back(make_source("t.fx", text));
        const std::int32_t name = sources.name_index("t.fx");
        Tokens tokens = lex(sources.files.back(), name, sources, diagnostics);
        Token end;
        end.at = {name, 999, 1};
        tokens.push_back(end);
        lowered = lower(parse(std::move(tokens), sources, diagnostics), sources, diagnostics);
    }

    const LoweredModule& module(const std::string& name) const {
        for (const LoweredModule& module : lowered.modules)
            if (module.name == name) return module;
        throw std::runtime_error("no module " + name);
    }
};

const std::string vertex_shader = "float4 vs(float4 p : POSITION) : POSITION { return p; }\n";

// One technique that compiles `pixel_compile` beside the plain vertex shader.
std::string effect(const std::string& body, const std::string& pixel_compile) {
    return vertex_shader + body +
           "\ntechnique t { pass p { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 " +
           pixel_compile + "; } }";
}

const LoweredAttribute* find(const std::vector<LoweredAttribute>& attributes, const std::string& semantic) {
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const LoweredAttribute& a) { return a.semantic == semantic; });
    return found == attributes.end() ? nullptr : &*found;
}

struct LiteralCase {
    const char* name;
    const char* type;
    const char* argument;
    std::uint32_t bits;
};

class Literal : public testing::TestWithParam<LiteralCase> {};

TEST_P(Literal, BecomesBits) {
    const LiteralCase& c = GetParam();
    const Result result(effect(std::string("float4 ps(uniform ") + c.type + " x) : COLOR { return x; }",
                               std::string("ps(") + c.argument + ")"));
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    const LoweredShader& shader = result.lowered.techniques.at(0).passes.at(0).pixel;
    ASSERT_EQ(shader.constants.size(), 1u);
    EXPECT_EQ(shader.constants[0].bits, c.bits);
}

INSTANTIATE_TEST_SUITE_P(Lower, Literal,
                         testing::Values(LiteralCase{"True", "bool", "true", 1},
                                         LiteralCase{"False", "bool", "false", 0},
                                         LiteralCase{"OneAsBool", "bool", "1", 1}, LiteralCase{"Int", "int", "42", 42},
                                         LiteralCase{"NegativeInt", "int", "-1", 0xFFFFFFFFu},
                                         LiteralCase{"SmallestInt", "int", "-2147483648", 0x80000000u},
                                         LiteralCase{"HexUint", "uint", "0xFFFFFFFFu", 0xFFFFFFFFu},
                                         LiteralCase{"Parentheses", "int", "-(-(3))", 3},
                                         LiteralCase{"Float", "float", "1.5f", 0x3FC00000u},
                                         LiteralCase{"NegativeFloat", "float", "-0.5", 0xBF000000u},
                                         LiteralCase{"NegativeZero", "float", "-0.0", 0x80000000u},
                                         LiteralCase{"IntAsFloat", "float", "2", 0x40000000u},
                                         LiteralCase{"Exponent", "float", "1e-3", 0x3A83126Fu},
                                         LiteralCase{"TooSmallIsZero", "float", "1e-99", 0},
                                         LiteralCase{"PointOnly", "float", "1.", 0x3F800000u}),
                         [](const auto& test) { return test.param.name; });

struct LowerError {
    const char* name;
    std::string body;
    std::string compile;
    const char* code;
    int line;
    const char* says;
};

class LowerRefuses : public testing::TestWithParam<LowerError> {};

TEST_P(LowerRefuses, WithPlaceAndRemedy) {
    const Result result(effect(GetParam().body, GetParam().compile));
    ASSERT_TRUE(has_errors(result.diagnostics));
    const Diagnostic& first = result.diagnostics[0];
    EXPECT_EQ(first.code, GetParam().code) << first.message;
    EXPECT_EQ(first.place.line, GetParam().line);
    EXPECT_GT(first.place.column, 0);
    EXPECT_NE(first.message.find(GetParam().says), std::string::npos) << first.message;
}

const std::string switched = "float4 ps_main(uniform bool bFog, uniform int n) : COLOR { return n; }";

INSTANTIATE_TEST_SUITE_P(
    Lower, LowerRefuses,
    testing::Values(
        LowerError{"MisspeltEntry", switched, "ps_mian(true, 1)", "PG030", 3, "'ps_main'"},
        LowerError{"OverloadedEntry", switched + switched, "ps_main(true, 1)", "PG030", 3, "overloaded"},
        LowerError{"TooFewArguments", switched, "ps_main(true)", "PG031", 3, "bool bFog, int n"},
        LowerError{"TooManyArguments", switched, "ps_main(true, 1, 2)", "PG031", 3, "gives 3"},
        LowerError{"FloatForBool", switched, "ps_main(0.5, 1)", "PG032", 3,
                   "a float; parameter 'bFog' of 'ps_main' is a bool"},
        LowerError{"TwoForBool", switched, "ps_main(2, 1)", "PG032", 3, "a bool"},
        LowerError{"BoolForInt", switched, "ps_main(true, true)", "PG032", 3, "an int"},
        LowerError{"FloatForInt", switched, "ps_main(true, 1.0)", "PG032", 3, "an int"},
        LowerError{"IntTooLarge", switched, "ps_main(true, 2147483648)", "PG032", 3, "out of range"},
        LowerError{"NegativeUint", "float4 ps(uniform uint n) : COLOR { return n; }", "ps(-1)", "PG032", 3,
                   "out of range"},
        LowerError{"FloatTooLarge", "float4 ps(uniform float f) : COLOR { return f; }", "ps(1e39)", "PG032", 3,
                   "out of range"},
        LowerError{"UnknownGlobal", "bool gFog; " + switched, "ps_main(gFgo, 1)", "PG033", 3, "'gFog'"},
        LowerError{"GlobalOfOtherType", "float4 gFog; " + switched, "ps_main(gFog, 1)", "PG032", 3, "bFog"},
        LowerError{"NoSemantic", "float4 ps(float4 c) : COLOR { return c; }", "ps()", "PG034", 2, "'c'"},
        LowerError{"NoResultSemantic", "float4 ps() { return 1; }", "ps()", "PG034", 2, "'ps'"},
        LowerError{"WrongTarget", "float4 ps() : TEXCOORD0 { return 1; }", "ps()", "PG035", 2, "TEXCOORD0"},
        LowerError{"NinthTarget", "float4 ps() : COLOR8 { return 1; }", "ps()", "PG035", 2, "COLOR8"},
        LowerError{"SemanticTwice", "float4 ps(float a : TEXCOORD1, float b : texcoord1) : COLOR { return a; }", "ps()",
                   "PG036", 2, "TEXCOORD1"},
        LowerError{"ArrayRunsIntoNeighbour",
                   "float4 ps(float a[3] : TEXCOORD1, float b : TEXCOORD3) : COLOR { return b; }", "ps()", "PG036", 2,
                   "TEXCOORD3"},
        LowerError{"StructWithinItself", "struct S { S s; };\nfloat4 ps(S s) : COLOR { return 1; }", "ps()", "PG037", 2,
                   "'S'"},
        LowerError{"DoubleInput", "float4 ps(double d : COLOR) : COLOR { return 1; }", "ps()", "PG037", 2, "double"},
        LowerError{"WideDepth", "float4 ps() : DEPTH { return 1; }", "ps()", "PG037", 2, "float"},
        LowerError{"SamplerOfTwoKinds", "sampler s; float4 ps() : COLOR { return tex2D(s, 0) +\n texCUBE(s, 0); }",
                   "ps()", "PG038", 3, "samplerCUBE"},
        LowerError{"GlobalTwice", "float a;\nfloat a; float4 ps() : COLOR { return 1; }", "ps()", "PG023", 3, "line 2"},
        LowerError{"ReservedName", "float permgen_in; float4 ps() : COLOR { return 1; }", "ps()", "PG042", 2,
                   "permgen_"},
        LowerError{"ReservedBlock", "float a; struct Globals { float b; }; float4 ps() : COLOR { return 1; }", "ps()",
                   "PG042", 2, "Globals"}),
    [](const auto& test) { return test.param.name; });

// The conversion of a value from the interface to the author's variable and back.
struct WrapperCase {
    const char* name;
    const char* shader;
    const char* line;
};

class Wrapper : public testing::TestWithParam<WrapperCase> {};

TEST_P(Wrapper, HasLine) {
    const std::string text = GetParam().shader;
    const bool vertex = text.find("vs(") != std::string::npos;
    const Result result(text + (vertex ? " technique t { pass p { VertexShader = compile vs_3_0 vs(); } }"
                                       : " technique t { pass p { PixelShader = compile ps_3_0 ps(); } }"));
    ASSERT_FALSE(has_errors(result.diagnostics)) << format(result.diagnostics[0]);
    const std::string& hlsl = result.module(vertex ? "vs" : "ps").hlsl;
    EXPECT_NE(hlsl.find(GetParam().line), std::string::npos) << hlsl;
}

constexpr const char* matrix_input =
    "float4 vs(float4 p : POSITION, float3x2 m : TEXCOORD1, row_major float2x3 r : TEXCOORD4) : POSITION { return p; }";
constexpr const char* pixel_input =
    "float4 ps(float2 at : VPOS, float face : VFACE, float4 z : POSITION, bool b : LIT, float size : PSIZE) : COLOR "
    "{ return face; }";
constexpr const char* pixel_output =
    "struct O { float4 b : COLOR1; float4 a : SV_Target0; float d : DEPTH0; }; O ps() { return (O)0; }";
constexpr const char* vertex_output =
    "struct O { float4 p : POSITION0; float s : PSIZE; float c : SV_ClipDistance; float2 t_m : TEXCOORD3_centroid; int "
    "i "
    ": ID; }; void vs(inout float4 p : POSITION1, out O o, uint n : SV_VertexID) { o = (O)0; }";

INSTANTIATE_TEST_SUITE_P(
    Lower, Wrapper,
    testing::Values(
        // D3D9 assigns one register to a column of a column_major matrix, to a row of a row_major one.
        WrapperCase{"ColumnIsRegister", matrix_input, "permgen_argument1[2][1] = (permgen_in.TEXCOORD2).z;"},
        WrapperCase{"ColumnRegister", matrix_input, "[[vk::location(4)]] float3 TEXCOORD2;"},
        WrapperCase{"RowIsRegister", matrix_input, "permgen_argument2[1] = permgen_in.TEXCOORD5;"},
        WrapperCase{"PixelIndex", pixel_input, "permgen_argument0 = floor(permgen_in.SV_POSITION).xy;"},
        WrapperCase{"FaceSign", pixel_input, "(permgen_in.SV_ISFRONTFACE ? 1.0 : -1.0)"},
        WrapperCase{"OnePositionForBoth", pixel_input, "permgen_argument2 = permgen_in.SV_POSITION;"},
        WrapperCase{"BoolTravelsAsUint", pixel_input, "nointerpolation uint LIT0;"},
        WrapperCase{"BoolIsBoolAgain", pixel_input, "permgen_argument3 = (bool)(permgen_in.LIT0);"},
        WrapperCase{"PointSizeReadsAsZero", pixel_input, "permgen_argument4 = 0;"},
        WrapperCase{"SecondTargetFirst", pixel_output, "[[vk::location(1)]] float4 COLOR1 : SV_Target1;"},
        WrapperCase{"TargetIsColour", pixel_output, "permgen_out.COLOR0 = permgen_result.a;"},
        WrapperCase{"Depth", pixel_output, "float SV_DEPTH : SV_Depth;"},
        WrapperCase{"Position", vertex_output, "float4 SV_POSITION : SV_Position;"},
        WrapperCase{"PointSize", vertex_output, "[[vk::builtin(\"PointSize\")]] float PSIZE0;"},
        WrapperCase{"ClipDistance", vertex_output, "float SV_CLIPDISTANCE0 : SV_ClipDistance0;"},
        WrapperCase{"Centroid", vertex_output, "[[vk::location(5)]] centroid float2 TEXCOORD3;"},
        WrapperCase{"IntIsFlat", vertex_output, "nointerpolation int ID0;"},
        WrapperCase{"InoutGoesIn", vertex_output, "permgen_argument0 = permgen_in.POSITION1;"},
        WrapperCase{"InoutComesOut", vertex_output, "permgen_out.POSITION1 = permgen_argument0;"},
        WrapperCase{"VertexIndex", vertex_output, "uint SV_VERTEXID : SV_VertexID;"}),
    [](const auto& test) { return test.param.name; });

TEST(Lower, MatrixTakesOneRegisterForEachColumnOrRow) {
    const Result result(std::string(matrix_input) + " technique t { pass p { VertexShader = compile vs_3_0 vs(); } }");
    const std::vector<LoweredAttribute>& inputs = result.module("vs").inputs;
    ASSERT_EQ(inputs.size(), 5u);
    EXPECT_EQ(inputs[1].components, 3u);
    EXPECT_EQ(inputs[2].semantic, "TEXCOORD2");
    EXPECT_EQ(inputs[3].semantic, "TEXCOORD4");
    EXPECT_EQ(inputs[4].semantic, "TEXCOORD5");
}

TEST(Lower, VertexShaderWithoutPositionIsRefused) {
    const Result result(
        "float4 vs(float4 p : POSITION) : COLOR { return p; }\ntechnique t { pass p { VertexShader = compile vs_3_0 "
        "vs(); } }");
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].code, "PG040");
}

TEST(Lower, EffectWithoutTechniqueIsRefused) {
    const Result result(vertex_shader);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].code, "PG027");
}

TEST(Lower, VaryingLocationsDoNotDependOnOrder) {
    const std::string out =
        "struct O { float4 p : POSITION; float4 a : TEXCOORD3; float b : FOG; float4 c : COLOR1; float2 d : NORMAL; "
        "};\n"
        "O vs(float4 p : POSITION) { return (O)0; }\n";
    const std::string in =
        "float4 ps(float4 n : NORMAL, float4 c : COLOR1, float b : FOG, float4 a : TEXCOORD3) : COLOR { return a + b + "
        "c + n; }\n";
    const Result result(
        out + in + "technique t { pass p { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps(); } }");
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    for (const LoweredAttribute& input : result.module("ps").inputs) {
        const LoweredAttribute* output = find(result.module("vs").outputs, input.semantic);
        ASSERT_NE(output, nullptr) << input.semantic;
        EXPECT_EQ(input.location, output->location) << input.semantic;
    }
    EXPECT_EQ(find(result.module("ps").inputs, "TEXCOORD3")->location, 5u);
    EXPECT_EQ(find(result.module("ps").inputs, "COLOR1")->location, 1u);
    EXPECT_EQ(find(result.module("ps").inputs, "FOG0")->location, 12u);
    EXPECT_EQ(find(result.module("ps").inputs, "NORMAL0")->location, 13u);
}

TEST(Lower, VertexOutputsAreAsWideAsPixelShadersReadThem) {
    const Result result(
        "void vs(inout float4 p : POSITION, inout float2 a : TEXCOORD0, inout float4 b : TEXCOORD1) { }\n"
        "float4 ps(float4 a : TEXCOORD0, float2 b : TEXCOORD1) : COLOR { return a + b.xyxy; }\n"
        "technique t { pass p { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps(); } }");
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    const LoweredModule& vs = result.module("vs");
    EXPECT_EQ(find(vs.outputs, "TEXCOORD0")->components, 4u);
    EXPECT_EQ(find(vs.outputs, "TEXCOORD1")->components, 4u);
    EXPECT_EQ(find(vs.inputs, "TEXCOORD0")->components, 2u);
    EXPECT_EQ(find(result.module("ps").inputs, "TEXCOORD1")->components, 2u);
    EXPECT_NE(vs.hlsl.find("permgen_out.TEXCOORD0 = float4(permgen_argument1, 0, 1);"), std::string::npos);
    EXPECT_FALSE(compile_hlsl(vs.stage, vs.entry, vs.hlsl).code.empty());
}

TEST(Lower, VertexInputsHaveTheDocumentedLocations) {
    const Result result(
        "float4 vs(float4 i : BLENDINDICES, float4 p : POSITION, float4 z : ZETA, float4 t : TEXCOORD7, float4 c : "
        "COLOR, "
        "float4 n : NORMAL, float4 t8 : TEXCOORD8) : POSITION { return p; }\n"
        "technique t { pass p { VertexShader = compile vs_3_0 vs(); } }");
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    const std::pair<const char*, std::uint32_t> expected[] = {
        {"POSITION0", 0},      {"NORMAL0", 1},    {"TEXCOORD7", 9}, {"COLOR0", 10},
        {"BLENDINDICES0", 15}, {"TEXCOORD8", 16}, {"ZETA0", 17}};
    for (const auto& [semantic, location] : expected) {
        const LoweredAttribute* input = find(result.module("vs").inputs, semantic);
        ASSERT_NE(input, nullptr) << semantic;
        EXPECT_EQ(input->location, location) << semantic;
    }
}

TEST(Lower, OneModuleForAllSettingsOfAnEntryPoint) {
    const std::string pass = "{ VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ";
    const Result result(vertex_shader + "bool gOn, gOther; " + switched + "technique t { pass a " + pass +
                        "ps_main(true, 1); } pass b " + pass + "ps_main(false, -7); } pass c " + pass +
                        "ps_main(gOn, 1); } pass d " + pass + "ps_main(gOther, 1); } }");
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    ASSERT_EQ(result.lowered.modules.size(), 4u);
    const std::vector<LoweredPass>& passes = result.lowered.techniques[0].passes;
    EXPECT_EQ(passes[0].pixel.module, passes[1].pixel.module);
    EXPECT_NE(passes[0].pixel.module, passes[2].pixel.module);
    EXPECT_NE(passes[2].pixel.module, passes[3].pixel.module);
    EXPECT_EQ(result.lowered.modules[2].name, "ps_main_2");
    ASSERT_EQ(passes[2].pixel.constants.size(), 1u);
    EXPECT_EQ(passes[2].pixel.constants[0].name, "n");
    EXPECT_EQ(passes[2].pixel.constants[0].id, 0u);
    EXPECT_NE(result.lowered.modules[2].hlsl.find("ps_main(gOn, permgen_axis_n)"), std::string::npos);
}

TEST(Lower, DefaultsFillMissingArguments) {
    const Result result(
        effect("float4 ps(uniform float a, uniform int n = -2, uniform bool b = true) : COLOR { return a; }", "ps(1)"));
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    const std::vector<LoweredAxis>& axes = result.module("ps").axes;
    ASSERT_EQ(axes.size(), 3u);
    EXPECT_EQ(axes[1].default_bits, 0xFFFFFFFEu);
    EXPECT_EQ(axes[2].default_bits, 1u);
    EXPECT_EQ(result.lowered.techniques[0].passes[0].pixel.constants[1].bits, 0xFFFFFFFEu);
}

TEST(Lower, EveryLineOfTheTextHasItsPlace) {
    const Result result(effect("\n\nfloat4 ps(float4 c : COLOR) : COLOR\n{\n    return c;\n}", "ps()"));
    const LoweredModule& module = result.module("ps");
    std::vector<std::string> lines;
    std::string line;
    for (const char c : module.hlsl) {
        if (c == '\n')
            lines.push_back(std::exchange(line, ""));
        else
            line += c;
    }
    ASSERT_EQ(lines.size(), module.line_map.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i] == "    return c;") {
            EXPECT_EQ(module.line_map[i].line, 6);
        }
        if (lines[i].starts_with("struct permgen_")) {
            EXPECT_TRUE(module.line_map[i].file.empty());
        }
    }
}

TEST(Lower, InitialValuesOfUniformsAreWarnedAbout) {
    const Result result(
        effect("float4 gTint = {1, 1, 1, 1}; const float K = 2; float4 ps() : COLOR { return gTint * K; }", "ps()"));
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].code, "PG039");
    EXPECT_FALSE(has_errors(result.diagnostics));
    EXPECT_NE(result.module("ps").hlsl.find("static"), std::string::npos);
}

TEST(Lower, BindingsAreUniformsThenSamplersThenBuffers) {
    const Result result(
        effect("cbuffer B { float4 b; }; sampler3D s; float4 a; samplerCUBE c = sampler_state { MinFilter = point; };"
               "float4 ps() : COLOR { return a + b + tex3D(s, 0) + texCUBE(c, 0); }",
               "ps()"));
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    const std::vector<LoweredResource>& resources = result.lowered.resources;
    ASSERT_EQ(resources.size(), 4u);
    const char* names[] = {"Globals", "s", "c", "B"};
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_EQ(resources[i].name, names[i]);
        EXPECT_EQ(resources[i].binding, i);
        EXPECT_EQ(resources[i].set, 0u);
    }
    EXPECT_EQ(resources[1].dimension, ImageDimension::Three);
    EXPECT_EQ(resources[2].dimension, ImageDimension::Cube);
    ASSERT_EQ(resources[2].sampler_states.size(), 1u);
    EXPECT_EQ(resources[2].sampler_states[0].value, "POINT");
}

TEST(Lower, UntypedSamplersGetTheDimensionThatCallsGiveThem) {
    const Result result(
        effect("sampler a, b, c; float4 inner(sampler s) { return texCUBElod(s, 0); } float4 outer(float x, sampler s) "
               "{ return inner(s); }"
               "float4 ps() : COLOR { return outer(1, b) + tex3Dproj(a, 0); }",
               "ps()"));
    ASSERT_TRUE(result.diagnostics.empty()) << format(result.diagnostics[0]);
    EXPECT_EQ(result.lowered.resources[0].dimension, ImageDimension::Three);
    EXPECT_EQ(result.lowered.resources[1].dimension, ImageDimension::Cube);
    EXPECT_EQ(result.lowered.resources[2].dimension, ImageDimension::Two);
    EXPECT_NE(result.module("ps").hlsl.find("outer(float x, samplerCUBE s)"), std::string::npos);
}

// SPIR-V's matrices are HLSL's transposed, so HLSL's column_major is RowMajor there: memory then holds one HLSL
// column after another, which is what a column-major C++ matrix uploads.
TEST(Lower, UniformMatricesKeepColumnsTogether) {
    const Result result(effect("float4x4 m; float4 ps(float4 c : COLOR) : COLOR { return mul(m, c); }", "ps()"));
    const LoweredModule& module = result.module("ps");
    const CompileResult compiled = compile_hlsl(module.stage, module.entry, module.hlsl);
    ASSERT_FALSE(compiled.code.empty()) << compiled.log;
    constexpr std::uint32_t op_member_decorate = 72, row_major = 4, column_major = 5;
    int rows = 0, columns = 0;
    for (std::size_t i = 5; i < compiled.code.size(); i += std::max(1u, compiled.code[i] >> 16)) {
        if ((compiled.code[i] & 0xFFFF) != op_member_decorate) continue;
        rows += compiled.code[i + 3] == row_major;
        columns += compiled.code[i + 3] == column_major;
    }
    EXPECT_EQ(rows, 1);
    EXPECT_EQ(columns, 0);
}

}  // namespace
}  // namespace permgen
