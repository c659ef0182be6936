// `render` uploads and makes only what the picture needs, and nothing twice.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "glb.h"
#include "program.h"

namespace tyndall::test {
namespace {

nlohmann::json statistics(const Glb& glb, std::vector<std::string> options) {
    const std::string stats = freshPath("stats.json");
    std::vector<std::string> arguments = {
        "render", writeScene(glb), "-o", freshPath("picture.exr"), "--stats", stats, "--size", "32x32", "--validate"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = runTyndall(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    std::ifstream file(stats);
    return run.status == 0 ? nlohmann::json::parse(file) : nlohmann::json{};
}

constexpr std::uint64_t texelBytes = 8;  // half floats, four channels

/// A lamp with a slide of 2 x 2 texels and dust of 4 x 4, before a wall with a texture of 1 x 3.
Glb scene(std::size_t& slide, std::size_t& dust) {
    Glb glb = wallScene();
    slide = glb.addTexture(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
    std::vector<std::uint8_t> noise;
    for (int i = 0; i < 64; ++i) noise.push_back(static_cast<std::uint8_t>(37 * i));
    dust = glb.addTexture(4, 4, noise);
    const std::size_t paint = glb.addTexture(1, 3, {90, 0, 0, 255, 0, 90, 0, 255, 0, 0, 90, 255});
    glb.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", paint}}}}}}};
    glb.json["meshes"][0]["primitives"][0]["material"] = 0;
    glb.json["nodes"][2]["extras"]["tyndall"] = {
        {"shape", "frustum"}, {"near", 0.5}, {"density", 0.1}, {"cookie", slide}, {"noise", {{"texture", dust}}}};
    return glb;
}

struct Case {
    const char* name;
    std::vector<std::string> options;
    std::size_t images, texels;
};

class Images : public testing::TestWithParam<Case> {};

TEST_P(Images, AreUploadedWhereSomethingDrawnLooksAtThem) {
    std::size_t slide = 0, dust = 0;
    const nlohmann::json found = statistics(scene(slide, dust), GetParam().options);
    EXPECT_EQ(found["images"]["uploaded"], GetParam().images);
    EXPECT_EQ(found["images"]["bytes"], GetParam().texels * texelBytes);
    EXPECT_EQ(found["images"]["ofTheScene"], 3);
}

INSTANTIATE_TEST_SUITE_P(
    Drawn, Images,
    testing::Values(
        Case{"Everything", {}, 3, 4 + 16 + 3}, Case{"ShaftsAlone", {"--layer", "shafts"}, 2, 4 + 16},
        Case{"ShaftsWithoutDust", {"--layer", "shafts", "--technique", "clip_nonoise_noshadow_cookie_technique"}, 1, 4},
        Case{"ShaftsWithNeither",
             {"--layer", "shafts", "--technique", "clip_nonoise_noshadow_nocookie_technique"},
             0,
             0}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Once, LampsThatShareASlideUploadItOnce) {
    std::size_t slide = 0, dust = 0;
    Glb glb = scene(slide, dust);
    for (int i = 0; i < 5; ++i) glb.addNode(glb.json["nodes"][2]);
    const nlohmann::json found = statistics(glb, {"--layer", "shafts"});
    EXPECT_EQ(found["draws"]["shafts"], 6);
    EXPECT_EQ(found["images"]["uploaded"], 2);
    EXPECT_EQ(found["pipelinesPrepared"], 2) << "one technique, one composite";
}

TEST(Once, ALampBehindTheEyeUploadsNothing) {
    std::size_t slide = 0, dust = 0;
    Glb glb = scene(slide, dust);
    glb.json["nodes"][2]["translation"] = {0, 0, 10};
    glb.json["nodes"][2]["rotation"] = {0, 1, 0, 0};
    const nlohmann::json found = statistics(glb, {"--layer", "shafts"});
    EXPECT_EQ(found["draws"]["shafts"], 0);
    EXPECT_EQ(found["images"]["uploaded"], 0);
    EXPECT_EQ(found["shadowMapsDrawn"], 0);
    EXPECT_EQ(found["pipelinesPrepared"], 0);
    EXPECT_EQ(found["pipelinesCreated"]["shafts"], 0);
}

}  // namespace
}  // namespace tyndall::test
