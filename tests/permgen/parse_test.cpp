#include "front/parse.h"

#include <gtest/gtest.h>

namespace permgen {
namespace {

struct Parsed {
    Sources sources;
    Diagnostics diagnostics;
    ParsedEffect effect;

    explicit Parsed(std::string_view text) {
        sources.files.push_back(make_source("t.fx", text));
        const std::int32_t name = sources.name_index("t.fx");
        Tokens tokens = lex(sources.files.back(), name, sources, diagnostics);
        Token end;
        end.at = {name, 999, 1};
        tokens.push_back(end);
        effect = parse(std::move(tokens), sources, diagnostics);
    }

    std::string kept() const {
        std::string text;
        for (std::size_t i = 0; i < effect.tokens.size(); ++i)
            if (!effect.dropped[i] && !effect.tokens[i].text.empty())
                text += (text.empty() ? "" : " ") + std::string(effect.tokens[i].text);
        return text;
    }
};

struct KeptCase {
    const char* name;
    std::string text;
    std::string kept;
};

class Keeps : public testing::TestWithParam<KeptCase> {};

TEST_P(Keeps, OnlyHlsl) {
    const Parsed parsed(GetParam().text);
    EXPECT_EQ(parsed.kept(), GetParam().kept);
    EXPECT_TRUE(parsed.diagnostics.empty()) << format(parsed.diagnostics[0]);
}

INSTANTIATE_TEST_SUITE_P(
    Parse, Keeps,
    testing::Values(
        KeptCase{"GlobalSemantic", "float4x4 m : WORLD;", "float4x4 m ;"},
        KeptCase{"GlobalRegister", "float4 c : register(c0) = 1;", "float4 c = 1 ;"},
        KeptCase{"Annotation", "float a < string s = \"x > y\"; float b = 1; > = 2;", "float a = 2 ;"},
        KeptCase{"AnnotationBeforeEquals", "float a < float b = 1; >= 2;", "float a = 2 ;"},
        KeptCase{"Uniform", "uniform extern float a;", "float a ;"},
        KeptCase{"Texture", "texture t < string n = \"a.dds\"; >;", ""},
        KeptCase{"String", "string s < bool b = true; > = \"a;b\";", ""},
        KeptCase{"Sampler", "sampler2D s : register(s0) = sampler_state { Texture = <t>; };", ""},
        KeptCase{"MemberSemantic", "struct S { centroid float4 p : TEXCOORD0; };", "struct S { float4 p ; } ;"},
        KeptCase{"ParameterSemantic", "float4 f(in float4 p : POSITION, uniform bool b) : COLOR { return p; }",
                 "float4 f ( in float4 p , bool b ) { return p ; }"},
        KeptCase{"Packoffset", "cbuffer C : register(b1) { float4 a : packoffset(c2); };",
                 "cbuffer C { float4 a : packoffset ( c2 ) ; } ;"},
        KeptCase{"Technique", "technique t { pass p { VertexShader = compile vs_2_0 f(); } };", ""}),
    [](const auto& test) { return test.param.name; });

struct ParseError {
    const char* name;
    std::string text;
    const char* code;
    int line;
    const char* says;
};

class ParseRefuses : public testing::TestWithParam<ParseError> {};

TEST_P(ParseRefuses, WithPlaceAndRemedy) {
    const Parsed parsed(GetParam().text);
    ASSERT_FALSE(parsed.diagnostics.empty());
    const Diagnostic& first = parsed.diagnostics[0];
    EXPECT_EQ(first.code, GetParam().code) << first.message;
    EXPECT_EQ(first.place.line, GetParam().line);
    EXPECT_GT(first.place.column, 0);
    EXPECT_NE(first.message.find(GetParam().says), std::string::npos) << first.message;
}

std::string pass(const std::string& body) {
    return "technique t {\npass p {\n" + body + "\n} }";
}

INSTANTIATE_TEST_SUITE_P(
    Parse, ParseRefuses,
    testing::Values(
        ParseError{"MisspeltTechnique", "\ntecnique t { pass p { } }", "PG020", 2, "'technique'"},
        ParseError{"MisspeltPass", "technique t {\n pas p { } }", "PG020", 2, "'pass'"},
        ParseError{"MisspeltCompile", pass("PixelShader = comple ps_2_0 f();"), "PG026", 3, "'compile'"},
        ParseError{"MisspeltShader", pass("PixlShader = compile ps_2_0 f();"), "PG026", 3, "'PixelShader'"},
        ParseError{"MisspeltSamplerState", "sampler s = sampler_stat { };", "PG020", 1, "'sampler_state'"},
        ParseError{"WrongStage", pass("PixelShader = compile vs_2_0 f();"), "PG024", 3, "ps_3_0"},
        ParseError{"NoArgumentList", pass("PixelShader = compile ps_2_0 f;"), "PG020", 3, "'('"},
        ParseError{"ShaderTwice", pass("PixelShader = compile ps_2_0 f();\nPixelShader = compile ps_2_0 f();"), "PG025",
                   4, "twice"},
        ParseError{"NoShader", pass("ZEnable = TRUE;"), "PG027", 2, "no shader"},
        ParseError{"FixedFunction", pass("VertexShader = NULL; PixelShader = NULL;"), "PG027", 2, "fixed-function"},
        ParseError{"Assembler", pass("PixelShader = asm { ps_1_1 };"), "PG026", 3, "HLSL"},
        ParseError{"NoPass", "technique t { }", "PG027", 1, "no pass"},
        ParseError{"DuplicateTechnique",
                   pass("PixelShader = compile ps_2_0 f(); VertexShader = compile vs_2_0 f();") + "\n" +
                       pass("PixelShader = compile ps_2_0 f(); VertexShader = compile vs_2_0 f();"),
                   "PG023", 5, "line 1"},
        ParseError{"MissingSemicolon", pass("ZEnable = TRUE\nCullMode = NONE;"), "PG020", 4, "';'"},
        ParseError{"OpenPass", "technique t {\npass p { ZEnable = TRUE;", "PG021", 2, "'}'"},
        ParseError{"OpenBody", "float f() {\n if (1) {\n}", "PG021", 1, "'}'"},
        ParseError{"CrossedBrackets", "float f() {\n (]; }", "PG021", 2, "'('"},
        ParseError{"DeepBrackets", "float f() { return " + std::string(20000, '(') + "; }", "PG021", 1, "256"},
        ParseError{"UnnamedParameter", "float f(int) { return 1; }", "PG022", 1, "no name"},
        ParseError{"VoidMember", "struct S { void v; };", "PG022", 1, "void"},
        ParseError{"MemberTwice", "struct S { float a;\n int a; };", "PG023", 2, "two members"},
        ParseError{"Technique10", "technique10 t { }", "PG022", 1, "technique"},
        ParseError{"TextureObject", "Texture2D<float4> t;", "PG022", 1, "sampler2D"},
        ParseError{"ShaderVariable", "PixelShader p = compile ps_2_0 f();", "PG022", 1, "pass"},
        ParseError{"SamplerArray", "sampler s[2];", "PG022", 1, "single samplers"},
        ParseError{"OwnBinding", "[[vk::binding(0, 0)]] float4 a;", "PG022", 1, "permgen gives out"},
        ParseError{"LooseWord", "float4 a\nfloat4 b;", "PG020", 2, "';'"},
        ParseError{"NoDeclaration", "} float a;", "PG020", 1, "'}'"}),
    [](const auto& test) { return test.param.name; });

TEST(Parse, SemanticsAreUpperCaseWithTheirIndexSplitOff) {
    const auto semantic = [](std::string_view text) {
        Token token;
        token.text = text;
        return parse_semantic(token);
    };
    EXPECT_EQ(semantic("TexCoord3").name, "TEXCOORD");
    EXPECT_EQ(semantic("TexCoord3").index, 3u);
    EXPECT_EQ(semantic("COLOR").index, 0u);
    EXPECT_TRUE(semantic("TEXCOORD1_centroid").centroid);
    EXPECT_EQ(semantic("TEXCOORD1_centroid").index, 1u);
}

TEST(Parse, StatesKeepNamesAndUpperCaseWords) {
    const Parsed parsed(
        pass("AlphaRef = 0x80; SrcBlend = One; Texture[0] = <gTex>; ColorWriteEnable = Red|Green; "
             "VertexShader = compile vs_2_0 f(1, -2, float2(3, 4)); PixelShader = compile ps_2_a g();"));
    ASSERT_TRUE(parsed.diagnostics.empty());
    const ParsedPass& p = parsed.effect.techniques.at(0).passes.at(0);
    ASSERT_EQ(p.states.size(), 4u);
    EXPECT_EQ(p.states[0].value, "0x80");
    EXPECT_EQ(p.states[1].value, "ONE");
    EXPECT_EQ(p.states[2].name, "Texture[0]");
    EXPECT_EQ(p.states[2].value, "gTex");
    EXPECT_EQ(p.states[3].value, "RED|GREEN");
    EXPECT_EQ(p.vertex->arguments.size(), 3u);
    EXPECT_EQ(p.pixel->profile, "ps_2_a");
}

TEST(Parse, GoesOnBehindAnError) {
    const Parsed parsed("float4 f(int) { return 1; }\nfloat4 g(int) { return 1; }\nstruct S { void v; };\nfloat4 ok;");
    EXPECT_EQ(parsed.diagnostics.size(), 3u);
    EXPECT_EQ(parsed.effect.globals.size(), 1u);
}

TEST(Parse, PassWithoutVertexShaderIsAWarning) {
    const Parsed parsed(pass("VertexShader = NULL; PixelShader = compile ps_2_0 f();"));
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].severity, Severity::Warning);
}

}  // namespace
}  // namespace permgen
