// States and profiles against Direct3D 9's table: values, errors with their place, and warnings.
#include "d3d9/states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>

#include "front/parse.h"
#include "lower/lower.h"

namespace permgen {
namespace {

struct Effect {
    Sources sources;
    Diagnostics diagnostics;
    Lowered lowered;

    explicit Effect(std::string_view text) {
        sources.files.push_back(make_source("t.fx", text));
        const std::int32_t name = sources.name_index("t.fx");
        Tokens tokens = lex(sources.files.back(), name, sources, diagnostics);
        Token end;
        end.at = {name, 999, 1};
        tokens.push_back(end);
        const ParsedEffect parsed = parse(std::move(tokens), sources, diagnostics);
        if (!has_errors(diagnostics)) lowered = lower(parsed, sources, diagnostics);
    }

    const std::vector<LoweredState>& states() const { return lowered.techniques.at(0).passes.at(0).states; }
};

/// The states stand alone on line 4, from column 1 on.
std::string in_pass(const std::string& states) {
    return "float4 vs(float4 p : POSITION) : POSITION { return p; }\nint gMode; float4 ps() : COLOR { return 1; }\n"
           "technique t { pass p { VertexShader = compile vs_3_0 vs(); PixelShader = compile ps_3_0 ps();\n" +
           states + "\n} }";
}

/// The same inside a sampler, on line 1 behind `sampler2D s = sampler_state {`, which is 29 characters long.
std::string in_sampler(const std::string& states) {
    return "sampler2D s = sampler_state {" + states + "};\n" + in_pass("");
}

struct Read {
    const char* name;
    std::string written;
    StateId id;
    ValueKind kind;
    std::uint32_t bits;
    std::string table_name = {};  ///< empty: not looked at
};

class StateIsRead : public testing::TestWithParam<Read> {};

TEST_P(StateIsRead, AsDirect3D9sNumber) {
    const Read& c = GetParam();
    const Effect effect(in_pass(c.written));
    ASSERT_FALSE(has_errors(effect.diagnostics)) << format(effect.diagnostics[0]);
    ASSERT_EQ(effect.states().size(), 1u);
    const LoweredState& state = effect.states()[0];
    EXPECT_EQ(state.id, c.id);
    EXPECT_EQ(state.kind, c.kind);
    EXPECT_EQ(state.bits, c.bits);
    if (!c.table_name.empty()) {
        EXPECT_EQ(state.name, c.table_name);
    }
}

INSTANTIATE_TEST_SUITE_P(
    , StateIsRead,
    testing::Values(
        Read{"SwitchOn", "AlphaBlendEnable = TRUE;", StateId::AlphaBlendEnable, ValueKind::Bool, 1},
        Read{"SwitchAsNumber", "ZWriteEnable = 0;", StateId::ZWriteEnable, ValueKind::Bool, 0},
        Read{"AnyCase", "aLPHAbLENDeNABLE = true;", StateId::AlphaBlendEnable, ValueKind::Bool, 1, "AlphaBlendEnable"},
        Read{"EnumWord", "SrcBlend = InvSrcAlpha;", StateId::SrcBlend, ValueKind::Enum, 6},
        Read{"EnumNumber", "CullMode = 3;", StateId::CullMode, ValueKind::Enum, 3},
        Read{"InParentheses", "CullMode = (NONE);", StateId::CullMode, ValueKind::Enum, 1},
        Read{"FlagWords", "ColorWriteEnable = RED | Green|ALPHA;", StateId::ColorWriteEnable, ValueKind::Flags, 11},
        Read{"FlagNumber", "ColorWriteEnable = 0x0F;", StateId::ColorWriteEnable, ValueKind::Flags, 15},
        Read{"FlagsZero", "ColorWriteEnable = 0;", StateId::ColorWriteEnable, ValueKind::Flags, 0},
        Read{"Hexadecimal", "AlphaRef = 0x80;", StateId::AlphaRef, ValueKind::Integer, 128},
        Read{"LargestInteger", "StencilMask = 0xffffffff;", StateId::StencilMask, ValueKind::Integer, 0xffffffffu},
        Read{"Float", "DepthBias = -0.5;", StateId::DepthBias, ValueKind::Float, 0xbf000000u},
        Read{"FloatAsInteger", "FogStart = 2;", StateId::FogStart, ValueKind::Float, 0x40000000u},
        Read{"Colour", "TextureFactor = 0xff8040c0;", StateId::TextureFactor, ValueKind::Colour, 0xff8040c0u},
        Read{"Stage", "ColorOp[1] = SELECTARG1;", StateId::ColorOp, ValueKind::Enum, 2, "ColorOp[1]"},
        Read{"StageFlags", "ColorArg1[0] = TEXTURE | COMPLEMENT;", StateId::ColorArg1, ValueKind::Flags, 18},
        Read{"WordThatBeginsWithADigit", "VertexBlend = 2WEIGHTS;", StateId::VertexBlend, ValueKind::Enum, 2},
        Read{"Texture", "Texture[0] = <gTex>;", StateId::Texture, ValueKind::Object, 0, "Texture[0]"},
        Read{"Parameter", "CullMode = <gMode>;", StateId::CullMode, ValueKind::Expression, 0},
        Read{"ParameterInParentheses", "CullMode = (gMode);", StateId::CullMode, ValueKind::Expression, 0},
        Read{"Computed", "AlphaRef = (gMode + 1);", StateId::AlphaRef, ValueKind::Expression, 0},
        Read{"LastOneWins", "CullMode = NONE; CullMode = CW;", StateId::CullMode, ValueKind::Enum, 2}),
    [](const auto& row) { return row.param.name; });

TEST(States, IndicesKeepApart) {
    const Effect effect(in_pass("ColorOp[0] = MODULATE; ColorOp[1] = DISABLE; ColorOp[0] = ADD;"));
    ASSERT_EQ(effect.states().size(), 2u);
    EXPECT_EQ(effect.states()[0].index, 1u);
    EXPECT_EQ(effect.states()[1].index, 0u);
    EXPECT_EQ(effect.states()[1].bits, 7u);
}

TEST(States, TheTableKnowsEveryNameAndValueInAnyCase) {
    for (const d3d9::StateRow& row : d3d9::states) {
        if (row.id == StateId::VertexShader || row.id == StateId::PixelShader) continue;
        for (const d3d9::NamedValue& value : row.values) {
            std::string name(row.name);
            std::transform(name.begin(), name.end(), name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
            const Effect effect(in_pass(name + " = " + std::string(value.name) + ";"));
            ASSERT_EQ(effect.states().size(), 1u) << row.name << " = " << value.name;
            EXPECT_EQ(effect.states()[0].id, row.id);
            EXPECT_EQ(effect.states()[0].bits, value.bits) << row.name << " = " << value.name;
        }
    }
}

struct Refused {
    const char* name;
    std::string effect;
    const char* code;
    int line;
    int column;
    const char* says;
};

class StateIsRefused : public testing::TestWithParam<Refused> {};

TEST_P(StateIsRefused, AtItsPlace) {
    const Refused& c = GetParam();
    const Effect effect(c.effect);
    ASSERT_TRUE(has_errors(effect.diagnostics));
    const Diagnostic& first = effect.diagnostics[0];
    EXPECT_EQ(first.code, c.code);
    EXPECT_EQ(first.place.line, c.line);
    EXPECT_EQ(first.place.column, c.column) << first.message;
    EXPECT_NE(first.message.find(c.says), std::string::npos) << first.message;
}

INSTANTIATE_TEST_SUITE_P(
    , StateIsRefused,
    testing::Values(
        Refused{"MistypedName", in_pass("AlphaBlendEnabel = TRUE;"), "PG043", 4, 1, "did you mean 'AlphaBlendEnable'?"},
        Refused{"NoSuchName", in_pass("Brightness = 1;"), "PG043", 4, 1, "not a state of Direct3D 9"},
        Refused{"MistypedSamplerName", in_sampler(" MinFilte = LINEAR; "), "PG043", 1, 31, "did you mean 'MinFilter'?"},
        Refused{"RenderStateInASampler", in_sampler("CullMode = NONE;"), "PG043", 1, 30, "write it into a pass"},
        Refused{"IndexOfAPlainState", in_pass("CullMode[0] = NONE;"), "PG043", 4, 10, "takes no index"},
        Refused{"IndexInASampler", in_sampler("MinFilter[0] = LINEAR;"), "PG043", 1, 40, "takes no index"},
        Refused{"IndexThatIsNoLiteral", in_pass("ColorOp[gMode] = ADD;"), "PG043", 4, 9, "literal"},
        Refused{"MistypedValue", in_pass("SrcBlend = INVSRCALPA;"), "PG044", 4, 12, "did you mean 'INVSRCALPHA'?"},
        Refused{"ValueOfAnotherState", in_pass("ZFunc = CW;"), "PG044", 4, 9, "one of NEVER, LESS,"},
        Refused{"MistypedSwitch", in_pass("ZWriteEnable = FLASE;"), "PG044", 4, 16, "did you mean 'FALSE'?"},
        Refused{"SwitchAsSeven", in_pass("ZWriteEnable = 7;"), "PG044", 4, 16, "TRUE or FALSE, not '7'"},
        Refused{"EnumOutOfRange", in_pass("CullMode = 4;"), "PG044", 4, 12, "one of NONE, CW, CCW, not '4'"},
        Refused{"EnumAsFloat", in_pass("CullMode = 1.5;"), "PG044", 4, 12, "not '1.5'"},
        Refused{"IntegerAsWord", in_pass("AlphaRef = TRUE;"), "PG044", 4, 12, "whole number"},
        Refused{"IntegerTooLarge", in_pass("AlphaRef = 4294967296;"), "PG044", 4, 12, "4294967295"},
        Refused{"ColourAsFloat", in_pass("FogColor = 0.5;"), "PG044", 4, 12, "a colour"},
        Refused{"FloatAsWord", in_pass("DepthBias = SMALL;"), "PG044", 4, 13, "a number, not 'SMALL'"},
        Refused{"ValueAsString", in_pass("CullMode = \"NONE\";"), "PG044", 4, 12, "not '\"NONE\"'"},
        Refused{"MistypedFlag", in_pass("ColorWriteEnable = RED|GREN;"), "PG044", 4, 24, "did you mean 'GREEN'?"},
        Refused{"FlagsTooLarge", in_pass("ColorWriteEnable = 16;"), "PG044", 4, 20, "not '16'"},
        Refused{"FlagsDangling", in_pass("ColorWriteEnable = RED|;"), "PG044", 4, 23, "'|' at the end"},
        Refused{"UndeclaredParameter", in_pass("CullMode = <gMood>;"), "PG044", 4, 13, "not 'gMood'"},
        Refused{"UnknownProfile", in_pass("") + "technique u { pass { PixelShader = compile ps_2_c ps(); } }", "PG024",
                5, 47, "did you mean 'ps_2_"},
        Refused{"ProfileOfTheOtherStage", in_pass("") + "technique u { pass { PixelShader = compile vs_3_0 ps(); } }",
                "PG024", 5, 47, "not a profile for a PixelShader; write ps_3_0"}),
    [](const auto& row) { return row.param.name; });

struct Warned {
    const char* name;
    std::string effect;
    std::vector<std::string> codes;
    const char* says = "";
};

class StateIsWarnedOf : public testing::TestWithParam<Warned> {};

TEST_P(StateIsWarnedOf, OncePerState) {
    const Warned& c = GetParam();
    const Effect effect(c.effect);
    std::vector<std::string> codes;
    for (const Diagnostic& diagnostic : effect.diagnostics) {
        EXPECT_EQ(diagnostic.severity, Severity::Warning);
        codes.push_back(diagnostic.code);
    }
    EXPECT_EQ(codes, c.codes);
    if (!codes.empty()) {
        EXPECT_NE(effect.diagnostics[0].message.find(c.says), std::string::npos) << effect.diagnostics[0].message;
    }
}

INSTANTIATE_TEST_SUITE_P(
    , StateIsWarnedOf,
    testing::Values(
        Warned{"Nothing", in_pass("ZEnable = TRUE; CullMode = NONE; FillMode = SOLID; ColorWriteEnable = RED;"), {}},
        Warned{"OffByHabit", in_pass("Lighting = FALSE; AlphaTestEnable = FALSE; FogEnable = 0; DepthBias = 0;"), {}},
        Warned{"FixedFunction", in_pass("AlphaRef = 1;"), {"PG045"}, "'AlphaRef' has no effect"},
        Warned{
            "SaidOnce", in_pass("ColorOp[0] = ADD; ColorOp[1] = ADD; AlphaRef = 1; AlphaRef = 2;"), {"PG045", "PG045"}},
        Warned{"Refused", in_pass("AlphaTestEnable = TRUE;"), {"PG045"}, "write FALSE or remove it"},
        Warned{
            "ValueThatIsNotDrawn", in_pass("FillMode = Wireframe;"), {"PG045"}, "'FillMode = WIREFRAME' is not drawn"},
        Warned{"SamplerStateInAPass", in_pass("MinFilter[0] = LINEAR;"), {"PG045"}, "sampler_state"},
        Warned{"Anisotropic", in_sampler("MinFilter = ANISOTROPIC;"), {"PG045"}, "is not drawn"},
        Warned{"BlackBorder", in_sampler("BorderColor = 0; MaxMipLevel = 0;"), {}},
        Warned{"WhiteBorder", in_sampler("BorderColor = 0xffffffff;"), {"PG045"}, "refuses a sampler with it"},
        Warned{"Expression", in_pass("CullMode = <gMode>;"), {"PG046"}, "not a literal"}),
    [](const auto& row) { return row.param.name; });

TEST(Format, ShowsTheLineAndACaret) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "permgen_caret.fx";
    std::ofstream(path, std::ios::binary) << "\xEF\xBB\xBF"
                                             "first\r\n\tb = \xC3\xA4 c;\rthird";
    const auto shown = [&](int line, int column) {
        const std::string text = format({Severity::Error, "PG043", {path.string(), line, column}, "m"});
        const std::size_t end = text.find('\n');
        return end == std::string::npos ? std::string() : text.substr(end + 1);
    };
    EXPECT_EQ(shown(1, 1), "first\n^");
    EXPECT_EQ(shown(2, 9), "\tb = \xC3\xA4 c;\n\t      ^") << "a tab stays one, a character of two bytes is one wide";
    EXPECT_EQ(shown(3, 6), "third\n     ^") << "behind the last character";
    EXPECT_EQ(shown(3, 7), "") << "no such column";
    EXPECT_EQ(shown(4, 1), "") << "no such line";
    EXPECT_EQ(shown(2, 0), "") << "the line as a whole";
    std::filesystem::remove(path);
    EXPECT_EQ(shown(1, 1), "") << "the file is gone";
}

}  // namespace
}  // namespace permgen
