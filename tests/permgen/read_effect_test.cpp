#include "lower/read_effect.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "back/build_program.h"
#include "declared_techniques.h"

namespace permgen {
namespace {

const std::filesystem::path slices = std::filesystem::path(SHADERS) / "slices.fx";

std::string contents(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

TEST(ReadEffect, SlicesHasOnePixelModuleAndAllItsSettings) {
    Diagnostics diagnostics;
    const Lowered lowered = read_effect(slices.string(), {}, diagnostics);
    ASSERT_TRUE(diagnostics.empty()) << format(diagnostics[0]);
    EXPECT_EQ(lowered.name, "slices");
    EXPECT_EQ(lowered.dependencies,
              (std::vector<std::string>{slices.string(), (slices.parent_path() / "shadow.fxh").string()}));
    ASSERT_EQ(lowered.modules.size(), 2u);
    EXPECT_EQ(lowered.modules[0].author_entry, "vs_main");
    EXPECT_EQ(lowered.modules[1].author_entry, "ps_main");
    const std::vector<DeclaredTechnique> declared = declared_techniques(slices.string());
    ASSERT_GE(declared.size(), 16u);
    ASSERT_EQ(lowered.techniques.size(), declared.size());
    for (std::size_t i = 0; i < declared.size(); ++i) {
        const auto& [name, switches] = declared[i];
        EXPECT_EQ(lowered.techniques[i].name, name);
        const LoweredPass& pass = lowered.techniques[i].passes.at(0);
        EXPECT_EQ(pass.vertex.module, 0);
        EXPECT_EQ(pass.pixel.module, 1);
        ASSERT_EQ(pass.pixel.constants.size(), switches.size());
        for (std::uint32_t c = 0; c < switches.size(); ++c) {
            EXPECT_EQ(pass.pixel.constants[c].name, switches[c].first);
            EXPECT_EQ(pass.pixel.constants[c].id, c);
            EXPECT_EQ(pass.pixel.constants[c].bits, switches[c].second ? 1u : 0u) << name;
        }
        ASSERT_EQ(pass.states.size(), 7u);
        EXPECT_EQ(pass.states[1].id, StateId::SrcBlend);
        EXPECT_EQ(pass.states[1].bits, static_cast<std::uint32_t>(Blend::One));
    }
}

// Compiles small effects in typical styles: the resulting interface must be the intended one.
class Style : public testing::TestWithParam<const char*> {};

TEST_P(Style, Builds) {
    Diagnostics diagnostics;
    Lowered lowered = read_effect((std::filesystem::path(FIXTURES) / GetParam()).string() + ".fx", {}, diagnostics);
    std::string report;
    for (const Diagnostic& diagnostic : diagnostics) report += format(diagnostic) + '\n';
    ASSERT_FALSE(has_errors(diagnostics)) << report;
    build_program(std::move(lowered), {}, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics) report += format(diagnostic) + '\n';
    EXPECT_FALSE(has_errors(diagnostics)) << report;
}

INSTANTIATE_TEST_SUITE_P(ReadEffect, Style, testing::Values("interfaces", "declarations"),
                         [](const auto& test) { return std::string(test.param); });

// Reads broken variants of slices.fx. Each must end, and each failure must have a place and a sentence.
class Broken : public testing::Test {
protected:
    void SetUp() override {
        path_ = std::filesystem::temp_directory_path() / ("permgen_broken_" + std::to_string(::getpid()) + ".fx");
    }
    void TearDown() override { std::filesystem::remove(path_); }

    void read(const std::string& text) {
        std::ofstream(path_, std::ios::binary) << text;
        Diagnostics diagnostics;
        SourceOptions options;
        options.include_folders = {SHADERS};  // slices.fx includes a file from there
        const Lowered lowered = read_effect(path_.string(), options, diagnostics);
        for (const Diagnostic& diagnostic : diagnostics) {
            const std::string& file = diagnostic.place.file;
            ASSERT_TRUE(file == path_.string() || file.ends_with("shadow.fxh")) << file << '\n' << text;
            ASSERT_GE(diagnostic.place.line, diagnostic.code == "PG027" ? 0 : 1) << text;
            ASSERT_FALSE(diagnostic.message.empty());
        }
        failures_ += has_errors(diagnostics);
    }

    std::filesystem::path path_;
    int failures_ = 0;
};

TEST_F(Broken, CutOffAnywhere) {
    const std::string text = contents(slices);
    ASSERT_GT(text.size(), 5000u);
    const std::size_t first_technique = text.find("SLICE_TECHNIQUE(clip_noise_shadow_cookie");
    constexpr std::size_t step = 13;  // prime, so that every kind of token is cut in its middle
    int cuts = 0;
    for (std::size_t length = 0; length < first_technique; length += step, ++cuts)
        ASSERT_NO_FATAL_FAILURE(read(text.substr(0, length)));
    EXPECT_EQ(failures_, cuts) << "an effect without a technique must not be taken for a good one";
    for (std::size_t length = first_technique; length < text.size(); length += step)
        ASSERT_NO_FATAL_FAILURE(read(text.substr(0, length)));
}

TEST_F(Broken, CharactersLostSwappedAndInserted) {
    const std::string text = contents(slices);
    std::mt19937 random(20040325);
    const std::string inserted[] = {
        "(", ")", "{", "}", "<", ">", "\"", "/*", "#", "\n#if 1\n", std::string(1, '\0'), "\xFF", "technique "};
    for (int i = 0; i < 400; ++i) {
        std::string mutant = text;
        for (int k = 0; k < 2; ++k) {
            const std::size_t at = random() % mutant.size();
            switch (random() % 3) {
                case 0:
                    mutant.erase(at, 1 + random() % 12);
                    break;
                case 1:
                    mutant.insert(at, inserted[random() % std::size(inserted)]);
                    break;
                default:
                    std::swap(mutant[at], mutant[random() % mutant.size()]);
            }
        }
        ASSERT_NO_FATAL_FAILURE(read(mutant));
    }
    EXPECT_GT(failures_, 0);
}

struct MonsterCase {
    const char* name;
    std::string text;
};

class Monster : public Broken, public testing::WithParamInterface<MonsterCase> {};

TEST_P(Monster, IsRefused) {
    ASSERT_NO_FATAL_FAILURE(read(GetParam().text));
    EXPECT_EQ(failures_, 1);
}

std::string repeated(std::string_view text, std::size_t count) {
    std::string result;
    result.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i) result += text;
    return result;
}

INSTANTIATE_TEST_SUITE_P(
    ReadEffect, Monster,
    testing::Values(MonsterCase{"Empty", ""}, MonsterCase{"Nuls", std::string(4096, '\0')},
                    MonsterCase{"OneWordOfAMegabyte", std::string(1 << 20, 'a')},
                    MonsterCase{"NestedParentheses", "float f() { return " + repeated("(", 100000)},
                    MonsterCase{"NestedBraces", repeated("{", 100000)},
                    MonsterCase{"Annotations", "float a " + repeated("<", 100000)},
                    MonsterCase{"NestedConditions", repeated("#if 1\n", 100000)},
                    MonsterCase{"NestedCalls", "#define F(x) x\n" + repeated("F(", 100000)},
                    MonsterCase{"NestedClosedCalls", "#define F(x) x\n" + repeated("F(", 2000) + repeated(")", 2000)},
                    MonsterCase{"Minuses", "technique t { pass p { PixelShader = compile ps_2_0 f(" +
                                               repeated("-", 100000) + "1); } }"},
                    MonsterCase{"ManyErrors", repeated("float 3;\n", 10000)},
                    MonsterCase{"ManyStrayBytes", repeated("@\n", 10000)},
                    MonsterCase{"EndlessTypedef",
                                "typedef A A; float4 f(A a : COLOR) : COLOR { return 1; } technique t { pass p { "
                                "PixelShader = compile ps_2_0 f(); } }"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace permgen
