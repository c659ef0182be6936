#include "back/compile.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "back/build_program.h"
#include "back/compile_log.h"
#include "back/compile_modules.h"
#include "small_effect.h"

namespace permgen {
namespace {

constexpr std::size_t pixel = 1;  // index of small_effect()'s pixel module

std::string all_of(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) text += format(diagnostic) + "\n";
    return text;
}

std::vector<CompiledModule> compile(const Lowered& effect, Diagnostics& diagnostics) {
    return compile_modules(effect, 2, {}, diagnostics);
}

TEST(Compile, TheSmallEffectCompilesWithoutAWord) {
    Diagnostics diagnostics;
    const auto modules = compile(test::small_effect(), diagnostics);
    EXPECT_EQ(all_of(diagnostics), "");
    for (const CompiledModule& module : modules) EXPECT_FALSE(module.code.empty());
    EXPECT_EQ(modules[pixel].reflection.constants.size(), 2u);
}

TEST(Compile, SameTextSameWordsWhateverTheNumberOfJobs) {
    Diagnostics diagnostics;
    const auto first = compile_modules(test::small_effect(), 1, {}, diagnostics);
    for (const int jobs : {1, 2, 8}) {
        const auto again = compile_modules(test::small_effect(), jobs, {}, diagnostics);
        for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].code, again[i].code);
    }
}

/// An effect file with exactly the text that small_effect() compiles.
class Located : public testing::Test {
protected:
    // One file per process: ctest runs several at once.
    Located() : path_(testing::TempDir() + "located_" + std::to_string(::getpid()) + ".fx") {}
    ~Located() override { std::filesystem::remove(path_); }

    Diagnostics errors_of(const std::string& body) {
        Lowered effect = test::small_effect();
        effect.modules[pixel].hlsl = test::pixel_text(body);
        std::ofstream(path_, std::ios::binary) << effect.modules[pixel].hlsl;
        effect.modules[pixel].line_map.clear();
        for (int line = 1; line <= 40; ++line) effect.modules[pixel].line_map.push_back({path_, line, 0});
        Diagnostics diagnostics;
        compile(effect, diagnostics);
        return diagnostics;
    }

    std::string path_;
};

struct Mistake {
    const char* name;
    const char* body;
    int line;
    int column;
    const char* says;
};
void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

class Mistakes : public Located, public testing::WithParamInterface<Mistake> {};

TEST_P(Mistakes, AreToldInTheAuthorsLines) {
    const Diagnostics diagnostics = errors_of(GetParam().body);
    ASSERT_EQ(diagnostics.size(), 1u) << all_of(diagnostics);
    EXPECT_EQ(diagnostics[0].code, "PG050");
    EXPECT_EQ(diagnostics[0].place.file, path_);
    EXPECT_EQ(diagnostics[0].place.line, GetParam().line);
    EXPECT_EQ(diagnostics[0].place.column, GetParam().column);
    EXPECT_NE(diagnostics[0].message.find(GetParam().says), std::string::npos) << diagnostics[0].message;
}

// The body starts on line 11.
INSTANTIATE_TEST_SUITE_P(
    Compile, Mistakes,
    testing::Values(Mistake{"UnknownName", "    return gTint[0] * gGian;\n", 11, 23, "'gGian': unknown variable"},
                    Mistake{"SecondLine", "    float a = 1.0;\n    return vec(a);\n", 12, 12, "vec"},
                    Mistake{"MissingOperand", "    float a = 1.0 +;\n    return a;\n", 11, 20, "syntax error at ';'"},
                    Mistake{"NamePartOfAnother", "    float gGianx = 1.0; return gGian * gGianx;\n", 11, 32, "gGian"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Located, AMissingBraceIsOneError) {
    const Diagnostics diagnostics = errors_of("    if (bNoise) { return 1.0;\n");
    EXPECT_EQ(diagnostics.size(), 1u) << all_of(diagnostics);
}

TEST(Compile, AMistakeSharedByTwoModulesIsSaidOnce) {
    Lowered effect = test::small_effect();
    effect.modules[pixel].hlsl = test::pixel_text("    return nothing;\n");
    effect.modules.push_back(effect.modules[pixel]);
    Diagnostics diagnostics;
    compile(effect, diagnostics);
    EXPECT_EQ(diagnostics.size(), 1u) << all_of(diagnostics);
}

TEST(Compile, AMistakeInGeneratedTextIsPlacedAtTheEntryPoint) {
    Lowered effect = test::small_effect();
    effect.modules[pixel].hlsl += "float generated() { return nothing; }\n";
    effect.modules[pixel].line_map.resize(10);
    Diagnostics diagnostics;
    compile(effect, diagnostics);
    ASSERT_EQ(diagnostics.size(), 1u) << all_of(diagnostics);
    EXPECT_EQ(diagnostics[0].place.line, effect.modules[pixel].place.line);
}

TEST(Compile, AMistakeIsNotSaidAgainOfTheGeneratedTextThatItBreaks) {
    LoweredModule module;
    module.hlsl = "float f()\n{ return nothing; }\nwrapper\n";
    module.line_map = {{"author.fx", 1, 0}, {"author.fx", 2, 0}};
    const std::string generated = "ERROR: 0:3: 'constructor' : can't convert\n";
    const Diagnostics both = read_compile_log("ERROR: 0:2: 'nothing' : unknown variable\n" + generated, module);
    ASSERT_EQ(both.size(), 1u) << all_of(both);
    EXPECT_EQ(both[0].place.line, 2);
    const Diagnostics warned = read_compile_log("WARNING: 0:2: 'f' : doubtful\n" + generated, module);
    EXPECT_TRUE(has_errors(warned)) << all_of(warned);
}

struct Crash {
    const char* name;
    const char* source;
    /// ctest loses the labels of a test whose name contains brackets or semicolons.
    friend void PrintTo(const Crash& crash, std::ostream* out) { *out << crash.name; }
};
class Crashes : public testing::TestWithParam<Crash> {};

// Each of these makes glslang 12.0.0 crash or run on. In either case it must become an error about that entry point,
// and the other module must compile.
TEST_P(Crashes, BecomeDiagnostics) {
    Lowered effect = test::small_effect();
    effect.modules[pixel].hlsl = GetParam().source;
    Diagnostics diagnostics;
    const auto modules = compile_modules(effect, 2, {std::chrono::seconds(5), WorkerLimits{}.memory}, diagnostics);
    EXPECT_FALSE(modules[0].code.empty());
    EXPECT_TRUE(modules[pixel].code.empty());
    EXPECT_TRUE(has_errors(diagnostics));
}

std::string nested(int depth) {
    return "float4 ps_entry() : SV_Target0 { return " + std::string(static_cast<std::size_t>(depth), '(') + "1.0" +
           std::string(static_cast<std::size_t>(depth), ')') + "; }\n";
}
const std::string deep = nested(20'000);

INSTANTIATE_TEST_SUITE_P(
    Compile, Crashes,
    testing::Values(Crash{"UnnamedParameter", "float4 ps_entry(int) : SV_Target0 { return 1.0; }\n"},
                    Crash{"VoidMember", "struct S { void a; }; float4 ps_entry(S s) : SV_Target0 { return 1.0; }\n"},
                    Crash{"CaseOutsideSwitch", "float4 ps_entry() : SV_Target0 { case 1: return 1.0; }\n"},
                    Crash{"UnclosedSubscript", "float4 ps_entry() : SV_Target0 { float a[3]; a[10 = 1; }\n"},
                    Crash{"DeepNesting", deep.c_str()}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Compile, ACrashNamesTheEntryPointAndWhatHappened) {
    Lowered effect = test::small_effect();
    effect.modules[pixel].hlsl = "float4 ps_entry() : SV_Target0 { case 1: return 1.0; }\n";
    Diagnostics diagnostics;
    compile(effect, diagnostics);
    ASSERT_EQ(diagnostics.size(), 1u) << all_of(diagnostics);
    EXPECT_EQ(diagnostics[0].code, "PG052");
    EXPECT_NE(diagnostics[0].message.find("'ps_main'"), std::string::npos);
    EXPECT_NE(diagnostics[0].message.find("crashed (Segmentation fault"), std::string::npos) << diagnostics[0].message;
}

TEST(Compile, AnEntryPointThatIsNotThereIsAnError) {
    Lowered effect = test::small_effect();
    effect.modules[pixel].entry = "nowhere";
    Diagnostics diagnostics;
    const auto modules = compile(effect, diagnostics);
    EXPECT_TRUE(has_errors(diagnostics));
    EXPECT_TRUE(modules[pixel].code.empty());
}

/// In each case the lowered text differs from the intended interface in one detail.
class Meant : public testing::Test {
protected:
    std::string complaint() {
        Diagnostics diagnostics;
        compile(effect, diagnostics);
        for (const Diagnostic& diagnostic : diagnostics) EXPECT_EQ(diagnostic.code, "PG056");
        return all_of(diagnostics);
    }
    Lowered effect = test::small_effect();
};

TEST_F(Meant, AnotherLocation) {
    effect.modules[pixel].inputs[1].location = 5;
    EXPECT_NE(complaint().find("is at location 1"), std::string::npos);
}
TEST_F(Meant, AnotherWidth) {
    effect.modules[0].inputs[0].components = 4;
    EXPECT_NE(complaint().find("POSITION0 at location 0 is float3, but float4 was intended"), std::string::npos);
}
TEST_F(Meant, AnotherType) {
    effect.modules[pixel].inputs[0].type = ScalarType::Int;
    EXPECT_NE(complaint().find("is float4, but int4 was intended"), std::string::npos);
}
TEST_F(Meant, AnOutputMore) {
    effect.modules[0].outputs.push_back({"TEXCOORD7", false, 7, 4, ScalarType::Float, {}});
    EXPECT_NE(complaint().find("output TEXCOORD7 is missing"), std::string::npos);
}
TEST_F(Meant, ASystemValueMore) {
    effect.modules[pixel].outputs.push_back({"SV_DEPTH", true, 0, 1, ScalarType::Float, {}});
    EXPECT_NE(complaint().find("output SV_DEPTH is missing"), std::string::npos);
}
TEST_F(Meant, ASystemValueLess) {
    effect.modules[0].outputs.pop_back();
    EXPECT_NE(complaint().find("became a system value"), std::string::npos);
}
TEST_F(Meant, AnotherBinding) {
    effect.resources[1].binding = 7;
    EXPECT_NE(complaint().find("'CookieSampler' is at set 0, binding 1"), std::string::npos);
}
TEST_F(Meant, AnotherName) {
    effect.resources[1].name = "Cookie";
    EXPECT_NE(complaint().find("'CookieSampler'"), std::string::npos);
}
TEST_F(Meant, AnotherDimension) {
    effect.resources[2].dimension = ImageDimension::Cube;
    EXPECT_NE(complaint().find("is a sampler3D, but a samplerCUBE was intended"), std::string::npos);
}
TEST_F(Meant, ASwitchMore) {
    effect.modules[pixel].axes.push_back({"bFog", 2, ScalarType::Bool, 0, {}});
    EXPECT_NE(complaint().find("switch 'bFog' did not become a specialization constant"), std::string::npos);
}
TEST_F(Meant, ASwitchLess) {
    effect.modules[pixel].axes.pop_back();
    EXPECT_NE(complaint().find("specialization constant 1 was not intended"), std::string::npos);
}
TEST_F(Meant, AnUnusedInputMayGo) {
    effect.modules[0].inputs.push_back({"NORMAL0", false, 3, 3, ScalarType::Float, {}});
    EXPECT_EQ(complaint(), "");
}

TEST(WorkerReply, SurvivesPackingAndTruncation) {
    const WorkerReply reply{{1, 2, 3}, "log", "complaint"};
    const std::string packed = pack(reply);
    const WorkerReply back = unpack(packed);
    EXPECT_EQ(back.code, reply.code);
    EXPECT_EQ(back.log, reply.log);
    EXPECT_EQ(back.invalid, reply.invalid);
    for (std::size_t size = 0; size < packed.size(); ++size) unpack(packed.substr(0, size));
}

}  // namespace
}  // namespace permgen
