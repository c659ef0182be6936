// permgen-rig's command line and its error messages.
#include <gtest/gtest.h>
#include <rig/image.h>

#include <filesystem>

#include "folder.h"
#include "process.h"

namespace tyndall::test {
namespace {

constexpr const char* kEffect = R"(
float4 gTint;
sampler2D PictureSampler;
samplerCUBE SkySampler;
struct Corner { float4 position : POSITION; float2 uv : TEXCOORD0; };
Corner vs_main(float4 position : POSITION, float2 uv : TEXCOORD0) { Corner c; c.position = position; c.uv = uv; return c; }
float4 ps_main(float2 uv : TEXCOORD0, uniform bool bPicture, uniform bool bSky) : COLOR0
{
    float4 colour = gTint;
    if (bPicture) colour *= tex2D(PictureSampler, uv);
    if (bSky) colour *= texCUBE(SkySampler, float3(uv, 1.0));
    return colour;
}
technique plain { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(false, false); } }
technique picture { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(true, false); } }
)";
constexpr const char* kSky =
    "technique sky { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(false, "
    "true); } }";
constexpr const char* kFixture = R"({"size": [8, 8], "constants": {"gTint": [1, 0.5, 0.25, 1]},
    "textures": {"PictureSampler": {"generate": "checker", "size": [8, 8], "cells": [4, 4]}}})";

struct Program : testing::Test {
    Folder folder;
    std::string manifest = compileEffect(folder.path(), "tint", kEffect);
    std::string fixture = folder.at("f.json"), goldens = folder.at("goldens");

    Program() { writeText(fixture, kFixture); }

    Ran rig(const std::vector<std::string>& words) {
        std::vector<std::string> all{PERMGEN_RIG};
        all.insert(all.end(), words.begin(), words.end());
        return runProgram(all);
    }
    void expectRefused(const std::vector<std::string>& words, const std::string& expected) {
        const Ran ran = rig(words);
        EXPECT_EQ(ran.status, 2) << ran.text;
        EXPECT_NE(ran.text.find(expected), std::string::npos) << ran.text;
    }
    void expectFixtureRefused(const std::string& text, const std::string& expected) {
        writeText(fixture, text);
        expectRefused({manifest, fixture}, expected);
    }
};

TEST_F(Program, ListsTechniquesWithoutAFixture) {
    const Ran ran = rig({manifest, "--list"});
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.text, "plain\npicture\n");
    EXPECT_EQ(rig({folder.at("out"), "--list"}).text, "plain\npicture\n");
    EXPECT_EQ(rig({manifest, "--list", "--technique", "picture"}).text, "picture\n");
}

TEST_F(Program, PassesWithoutGoldensAndTriesOneTechniqueAlone) {
    const Ran ran = rig({manifest, fixture});
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_NE(ran.text.find("tint: 2 of 2 techniques on llvmpipe"), std::string::npos) << ran.text;
    const Ran one = rig({manifest, fixture, "--technique", "picture"});
    EXPECT_EQ(one.status, 0) << one.text;
    EXPECT_EQ(one.text.find("plain"), std::string::npos) << one.text;
}

// The picture shows the fixture's values: the tint, and a picture whose first texel is black and whose cells are two
// pixels wide.
TEST_F(Program, DrawsWhatTheFixtureSays) {
    EXPECT_EQ(rig({manifest, fixture, "--goldens", goldens, "--update-goldens"}).status, 1);
    EXPECT_EQ(listing(goldens), "picture.exr\nplain.exr\n");
    const auto plain = rig::readImage(goldens + "/plain.exr"), picture = rig::readImage(goldens + "/picture.exr");
    ASSERT_TRUE(plain.has_value() && picture.has_value());
    EXPECT_EQ(plain->width, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            EXPECT_EQ(plain->at(x, y, 1), 0.5f);
            EXPECT_EQ(picture->at(x, y, 0), (x / 2 + y / 2) % 2 == 0 ? 0.0f : 1.0f) << x << " " << y;
        }
    EXPECT_EQ(rig({manifest, fixture, "--goldens", goldens}).status, 0);
}

TEST_F(Program, FormatsAreDrawnAndHeldWithTheirOwnTolerance) {
    for (const std::string format : {"rgba8", "rgba16f"}) {
        writeText(fixture, replaced(kFixture, "\"size\": [8, 8], \"constants\"",
                                    "\"format\": \"" + format + "\", \"size\": [8, 8], \"constants\""));
        const std::string own = folder.at("goldens-" + format);
        EXPECT_EQ(rig({manifest, fixture, "--goldens", own, "--update-goldens"}).status, 1);
        EXPECT_EQ(rig({manifest, fixture, "--goldens", own}).status, 0);
        // 0.25 is exact as a half float, and 63.75 of 255.
        EXPECT_EQ(rig::readImage(own + "/plain.exr")->at(0, 0, 2), format == "rgba8" ? 64.0f / 255.0f : 0.25f);
        writeText(fixture, replaced(readText(fixture), "0.25, 1]}", "0.27, 1]}"));
        EXPECT_EQ(rig({manifest, fixture, "--goldens", own}).status, 1);
    }
}

TEST_F(Program, AResourceThatShowsNothingIsNoted) {
    writeText(fixture, replaced(kFixture, "[1, 0.5, 0.25, 1]", "[0, 0, 0, 0]"));
    const Ran ran = rig({manifest, fixture});
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_NE(ran.text.find("note: PictureSampler is live, but changing it changes no value"), std::string::npos)
        << ran.text;
}

TEST_F(Program, ConstantsLeftAtZeroAreNoted) {
    writeText(fixture, R"({"textures": {"PictureSampler": {"generate": "noise"}}})");
    EXPECT_NE(rig({manifest, fixture}).text.find("note: the fixture leaves these constants at 0: gTint"),
              std::string::npos);
}

TEST_F(Program, AnImageFileIsATexture) {
    Image image = blankImage(2, 1, 3);
    image.at(1, 0, 0) = 0.5f;
    ASSERT_TRUE(writeExr(folder.at("two.exr"), image).has_value());
    writeText(fixture, R"({"size": [8, 8], "constants": {"gTint": [1, 1, 1, 1]},
                           "textures": {"PictureSampler": {"image": "two.exr"}}})");
    rig({manifest, fixture, "--goldens", goldens, "--update-goldens"});
    const auto picture = rig::readImage(goldens + "/picture.exr");
    ASSERT_TRUE(picture.has_value()) << picture.error().message;
    EXPECT_EQ(picture->at(0, 0, 0), 0.0f);
    EXPECT_EQ(picture->at(7, 7, 0), 0.5f);
    EXPECT_EQ(picture->at(0, 0, 3), 1.0f);  // images without alpha are opaque
}

// Two targets are one below the other; a pass leaves the targets unchanged that it does not write.
TEST_F(Program, SeveralTargetsAndPassesThatWriteFewerOfThem) {
    const std::string two = compileEffect(folder.at("two"), "two", R"(
        struct Both { float4 a : COLOR0; float4 b : COLOR1; };
        float4 vs_main(float4 position : POSITION) : POSITION { return position; }
        Both ps_both() { Both both; both.a = float4(1, 0, 0, 1); both.b = float4(0, 1, 0, 1); return both; }
        float4 ps_one() : COLOR0 { return float4(0, 0, 1, 0); }
        technique t {
            pass both { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_both(); }
            pass one { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_one();
                       AlphaBlendEnable = TRUE; SrcBlend = ONE; DestBlend = ONE; }
            pass depth { VertexShader = compile vs_3_0 vs_main(); } })");
    for (const std::string depth : {"false", "true"}) {
        const std::string own = folder.at("goldens-" + depth);
        writeText(fixture, R"({"size": [4, 4], "depth": )" + depth + "}");
        const Ran made = rig({two, fixture, "--goldens", own, "--update-goldens"});
        EXPECT_EQ(made.status, 1);
        const Ran ran = rig({two, fixture, "--goldens", own});
        EXPECT_EQ(ran.status, 0) << ran.text;
        const auto picture = rig::readImage(own + "/t.depth.exr");
        ASSERT_TRUE(picture.has_value()) << picture.error().message;
        ASSERT_EQ(picture->height, 8);
        EXPECT_EQ(std::vector<float>(&picture->values[0], &picture->values[0] + 4), (std::vector<float>{1, 0, 1, 1}));
        EXPECT_EQ(std::vector<float>(&picture->values[64], &picture->values[64] + 4), (std::vector<float>{0, 1, 0, 1}));
    }
}

// An effect without attributes and resources, with a loop of variable length.
TEST_F(Program, AnEffectThatReadsNothingIsDrawn) {
    const std::string nothing = compileEffect(folder.at("nothing"), "nothing", R"(
        float4 vs_main() : POSITION { return float4(0, 0, 0, 1); }
        float4 ps_main(uniform int n) : COLOR0 { float4 c = 0; for (int i = 0; i < n; i++) c += 0.1; return c; }
        technique t { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_main(3); } })");
    writeText(fixture, "{}");
    const Ran ran = rig({nothing, fixture});
    EXPECT_EQ(ran.status, 0) << ran.text;
}

TEST_F(Program, WrongCommandLinesAreRefused) {
    expectRefused({}, "MANIFEST");
    expectRefused({manifest}, "FIXTURE");
    expectRefused({manifest, fixture, "--update-goldens"}, "--goldens");
    expectRefused({manifest, fixture, "--nonsense"}, "--nonsense");
    expectRefused({manifest, fixture, "--technique", "pictur"},
                  "there is no technique 'pictur'; did you mean 'picture'?");
    expectRefused({folder.at("none.fx.json"), fixture}, "none.fx.json");
    expectRefused({manifest, folder.at("none.json")}, "none.json: cannot be read");
    expectRefused({manifest, folder.path()}, folder.path() + ": this is a folder");
    expectRefused({manifest, fixture, "--device", "no such device"}, "no such device");
    EXPECT_EQ(rig({"--help"}).status, 0);
}

TEST_F(Program, FixturesThatDoNotFitTheEffectAreRefused) {
    expectFixtureRefused(R"({"constants": {"gTnit": [1, 1, 1, 1]}})",
                         "constants.gTnit: tint has no such constant; did you mean gTint?");
    expectFixtureRefused(R"({"constants": {"gTint": [1, 1, 1]}})",
                         "constants.gTint: it is a float4: give 4 numbers, not 3");
    expectFixtureRefused(R"({})", "textures.PictureSampler: picture reads it, but the fixture gives it no texture");
    expectFixtureRefused(R"({"textures": {"PictureSample": {"generate": "noise"}}})",
                         "textures.PictureSample: tint has no such sampler; did you mean PictureSampler?");
    expectFixtureRefused(R"({"textures": {"PictureSampler": {"image": "none.png"}}})", "none.png: cannot be read");
    expectFixtureRefused(R"({"textures": {"PictureSampler": {"generate": "noise"}},
                             "geometry": {"vertices": {"POSITION": [[0, 0], [1, 0], [0, 1]]}}})",
                         "reads TEXCOORD0, but the vertices have POSITION0");
    expectFixtureRefused("{", "this is not JSON");
}

TEST_F(Program, WithoutFrozenModulesNothingIsTried) {
    writeText(folder.at("p.fx"), kEffect);
    runProgram({PERMGEN, "compile", folder.at("p.fx"), "-o", folder.at("melted")});
    expectRefused({folder.at("melted"), fixture}, "compile the effect with permgen compile --freeze");
}

TEST_F(Program, ACubeMapThatIsReadIsRefusedAndOneThatIsNotIsNoMatter) {
    const std::string sky = compileEffect(folder.at("sky"), "tint", std::string(kEffect) + kSky);
    expectRefused({sky, fixture}, "textures.SkySampler: sky reads it, but it is a samplerCUBE");
    EXPECT_EQ(rig({sky, fixture, "--technique", "picture"}).status, 0);
}

TEST_F(Program, TechniquesThatComputeAreRefusedAndLeaveTheOthersAlone) {
    const std::string sums = compileEffect(folder.at("sums"), "tint", std::string(kEffect) + R"(
        struct Cell { float3 colour; float gain; };
        StructuredBuffer<Cell> Cells;
        RWStructuredBuffer<Cell> Sums;
        groupshared float shared_gain;
        [numthreads(8, 1, 1)] void cs_main(uint3 id : SV_DispatchThreadID) { shared_gain = 1; Sums[id.x].gain = shared_gain * gTint.x; }
        float4 ps_cells() : COLOR0 { return Cells[0].gain; }
        technique sum { pass { ComputeShader = compile cs_5_0 cs_main(); } }
        technique cells { pass { VertexShader = compile vs_3_0 vs_main(); PixelShader = compile ps_3_0 ps_cells(); } })");
    expectRefused({sums, fixture}, "sum computes, and permgen-rig tests what is drawn; name a technique that draws");
    expectRefused({sums, fixture, "--technique", "cells"},
                  "cells reads the storage buffer Cells, and a fixture has none");
    const Ran ran = rig({sums, fixture, "--technique", "picture"});
    EXPECT_EQ(ran.status, 0) << ran.text;
}

TEST_F(Program, ATechniqueThatWasRenamedLeavesTheReport) {
    const std::vector<std::string> words{manifest, fixture, "--goldens", goldens, "--report", folder.at("report")};
    EXPECT_EQ(rig(words).status, 1);
    EXPECT_NE(readText(folder.at("report/index.html")).find("<h2>picture</h2>"), std::string::npos);
    compileEffect(folder.path(), "tint", replaced(kEffect, "technique picture", "technique painting"));
    EXPECT_EQ(rig(words).status, 1);
    EXPECT_EQ(readText(folder.at("report/index.html")).find("<h2>picture</h2>"), std::string::npos);
    EXPECT_NE(readText(folder.at("report/index.html")).find("<h2>painting</h2>"), std::string::npos);
}

TEST_F(Program, AReportThatCannotBeWrittenIsSaid) {
    writeText(folder.at("file"), "");
    expectRefused({manifest, fixture, "--goldens", goldens, "--report", folder.at("file")},
                  "the report cannot be written");
    writeText(folder.at("garden/index.html"), "My garden");
    expectRefused({manifest, fixture, "--goldens", goldens, "--report", folder.at("garden")},
                  "its index.html is not a page of failing comparisons");
    EXPECT_EQ(listing(folder.at("garden")), "index.html\n");
}

}  // namespace
}  // namespace tyndall::test
