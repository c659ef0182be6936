// Pictures of small scenes with known results, drawn on lavapipe by the program.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "glb.h"
#include "program.h"

namespace tyndall::test {
namespace {

/// Renders with validation on and returns the EXR's pixels; empty if it failed.
Pixels render(const Glb& glb, std::vector<std::string> options) {
    const std::string picture = freshPath("picture.exr");
    std::vector<std::string> arguments = {"render", writeScene(glb), "-o", picture, "--validate", "--size", "64x64"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = runTyndall(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_NE(run.errors.find("wrote " + picture), std::string::npos) << run.errors;
    return run.status == 0 ? readPixels(picture) : Pixels{};
}

/// The camera is at the lamp and sees exactly the lamp's field of view.
Glb slideScene() {
    Glb glb = wallScene();
    // Top row red, green; bottom row blue, white.
    const std::size_t slide =
        glb.addTexture(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
    glb.json["nodes"][2]["extras"]["tyndall"] = {
        {"shape", "frustum"}, {"cookie", slide}, {"density", 0.1}, {"near", 1.0}};
    for (const int node : {1, 2}) glb.json["nodes"][node]["rotation"] = {0, 0, 0, 1};
    return glb;
}

constexpr std::array<std::array<int, 2>, 4> quarters = {{{8, 8}, {56, 8}, {8, 56}, {56, 56}}};
constexpr std::array<std::array<bool, 3>, 4> slideColours = {
    {{true, false, false}, {false, true, false}, {false, false, true}, {true, true, true}}};

class Slide : public testing::TestWithParam<const char*> {};

TEST_P(Slide, AppearsAsItWouldToAnEyeAtTheLamp) {
    Glb glb = slideScene();
    // Clear air: only the light on the wall is visible.
    if (GetParam() == std::string("all")) glb.json["nodes"][2]["extras"]["tyndall"]["density"] = 0.0;
    const Pixels picture = render(glb, {"--layer", GetParam(), "--accum", "rgba32f", "--planes", "16"});
    ASSERT_EQ(picture.width, 64);
    for (std::size_t quarter = 0; quarter < 4; ++quarter)
        for (int c = 0; c < 3; ++c) {
            const float value = picture.at(quarters[quarter][0], quarters[quarter][1], c);
            // Lit channels get 100 cd at 5 m and more; dark ones only ambient light, two hundredths of that.
            if (slideColours[quarter][static_cast<std::size_t>(c)])
                EXPECT_GT(value, 0.2f) << "quarter " << quarter << " channel " << c;
            else
                EXPECT_LT(value, 0.1f) << "quarter " << quarter << " channel " << c;
        }
}

INSTANTIATE_TEST_SUITE_P(Layers, Slide, testing::Values("all", "shafts"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Render, ShaftIsTheIntegralAlongTheRay) {
    Glb glb = slideScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {
        {"shape", "frustum"}, {"density", 0.1}, {"near", 1.0}, {"shadow", "none"}};
    const Pixels picture = render(glb, {"--layer", "shafts", "--accum", "rgba32f", "--planes", "400"});
    ASSERT_EQ(picture.width, 64);
    // Every ray starts at the lamp, so L = density / (4 pi) I (1/a - 1/b) over a ray from a to b metres.
    // The middle of four pixels lies on the axis: 1 to 5 m, within (0.35 / 32)^2 / 2 = 6e-5 of it.
    const double expected = 0.1 / (4.0 * std::numbers::pi) * 100.0 * (1.0 - 1.0 / 5.0);
    // The midpoint rule over slabs of h = 0.01 m errs by h^2 / 24 * (f'(5) - f'(1)) = 8e-6 for f = 1 / d^2, 1e-5 of
    // the integral 0.8; adding 400 floats by 400 * 6e-8 = 2.4e-5; the slant by 3e-5. Three times their sum: 2e-4.
    EXPECT_NEAR(picture.at(32, 32, 0) / expected, 1.0, 2e-4);
}

TEST(Render, PoolOnTheWallIsLambertsLaw) {
    Glb glb = slideScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"shape", "frustum"}, {"density", 0.0}, {"near", 1.0}};
    const Pixels picture = render(glb, {"--accum", "rgba32f"});
    ASSERT_EQ(picture.width, 64);
    // I / (pi d^2), and ambient light from the horizon: 0.02 / pi * I / r^2 * (0.4 + 1) / 2 with r half of the
    // scene's diagonal, which for a flat wall is that of its square: 4 sqrt(2) m.
    const double pool = 100.0 / std::numbers::pi * (1.0 / 25.0 + 0.02 * 0.7 / 32.0);
    EXPECT_NEAR(picture.at(32, 32, 0) / pool, 1.0, 1e-3) << "within a pixel of the axis";
}

TEST(Render, ABlockerDarkensTheAirBehindItAndTheWall) {
    Glb glb = slideScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"shape", "frustum"}, {"density", 0.1}, {"near", 1.0}};
    const std::size_t square = glb.addSquare(0.3f);
    glb.addNode({{"name", "Blocker"}, {"mesh", square}, {"translation", {0, 0, -2}}});
    // The eye is aside and looks at the wall's middle past the blocker.
    glb.json["nodes"][1]["translation"] = {3, 0, 0};
    glb.json["nodes"][1]["rotation"] = {0, std::sin(0.27), 0, std::cos(0.27)};  // 2 * 0.27 = atan(3/5)
    const Pixels shadowed = render(glb, {});
    glb.json["nodes"][2]["extras"]["tyndall"]["shadow"] = "none";
    const Pixels open = render(glb, {});
    ASSERT_EQ(shadowed.width, 64);
    ASSERT_EQ(open.width, 64);
    EXPECT_LT(shadowed.at(32, 32, 0), 0.4f * open.at(32, 32, 0)) << "the wall's middle lies in the shadow";
    Glb empty = glb;
    empty.json["nodes"][3].erase("mesh");
    empty.json["nodes"][2]["extras"]["tyndall"]["shadow"] = "static";
    const Pixels lit = render(empty, {});
    ASSERT_EQ(lit.width, 64);
    EXPECT_NEAR(lit.at(32, 32, 0) / open.at(32, 32, 0), 1.0, 0.02) << "a wall does not shade itself";
}

TEST(Render, NoSurfaceShadesItself) {
    Glb glb = wallScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"shape", "frustum"}, {"density", 0.0}};
    // The lamp sees the wall at 80 degrees from its normal: the worst slope for a shadow map.
    glb.json["nodes"][0]["rotation"] = {0, std::sin(0.698), 0, std::cos(0.698)};
    const Pixels with = render(glb, {"--shadow-size", "256"});
    glb.json["nodes"][2]["extras"]["tyndall"]["shadow"] = "none";
    const Pixels without = render(glb, {"--shadow-size", "256"});
    ASSERT_EQ(with.width, 64);
    ASSERT_EQ(without.width, 64);
    for (int y = 16; y < 48; ++y)
        for (int x = 16; x < 48; ++x) EXPECT_NEAR(with.at(x, y, 0), without.at(x, y, 0), 1e-4f) << x << ", " << y;
}

TEST(Render, GeometriesAgree) {
    const std::vector<std::string> options = {"--layer", "shafts", "--accum", "rgba32f", "--planes", "64"};
    std::vector<std::string> quads = options;
    quads.insert(quads.end(), {"--geometry", "quads"});
    const Pixels polygon = render(wallScene(), options), quad = render(wallScene(), quads);
    ASSERT_EQ(polygon.width, 64);
    ASSERT_EQ(quad.width, 64);
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < polygon.values.size(); ++i) {
        difference += std::abs(polygon.values[i] - quad.values[i]);
        sum += polygon.values[i];
    }
    EXPECT_GT(sum, 0.0);
    EXPECT_LT(difference / sum, 0.01) << "only pixels on the volume's edge may differ";
}

class Accumulations : public testing::TestWithParam<const char*> {};

TEST_P(Accumulations, ComeCloseToFloat) {
    const Pixels exact = render(wallScene(), {"--layer", "shafts", "--accum", "rgba32f"});
    const Pixels picture = render(wallScene(), {"--layer", "shafts", "--accum", GetParam()});
    ASSERT_EQ(exact.width, 64);
    ASSERT_EQ(picture.width, 64);
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
        difference += std::abs(exact.values[i] - picture.values[i]);
        sum += exact.values[i];
    }
    // 8 bits lose up to half a step for each of 100 slices, a fifth of the range (an eighth of that when routed).
    EXPECT_LT(difference / sum, std::string(GetParam()) == "rgba16f" ? 0.02 : 0.5);
}

INSTANTIATE_TEST_SUITE_P(Formats, Accumulations, testing::Values("rgba16f", "rgba8", "rgba8-routed"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(Render, StatisticsSayWhatWasDrawn) {
    const std::string stats = freshPath("stats.json");
    ASSERT_EQ(render(wallScene(), {"--stats", stats, "--planes", "12"}).width, 64);
    std::ifstream file(stats);
    const auto report = nlohmann::json::parse(file);
    EXPECT_NE(report["device"].get<std::string>().find("llvmpipe"), std::string::npos);
    EXPECT_EQ(report["lights"][0]["technique"], "clip_nonoise_noshadow_cookie_technique") << "it ends at the wall";
    EXPECT_EQ(report["lights"][0]["slices"], 12);
    EXPECT_EQ(report["slices"], 12);
    EXPECT_EQ(report["draws"]["shafts"], 1);
    EXPECT_EQ(report["draws"]["surfaces"], 2) << "a base pass and one light";
    // The lamp's square field of view fills the picture's: 64 x 64 pixels for each of 12 slices at most, and
    // drivers may round up to whole tiles.
    EXPECT_GT(report["fragmentInvocations"], 12 * 64 * 64 / 2);
    EXPECT_LT(report["fragmentInvocations"], 12 * 64 * 64 * 2);
    EXPECT_GT(report["memory"]["deviceBytes"], 64 * 64 * 16);
    EXPECT_EQ(report["shadowMapsDrawn"], 0);
    // Apart from textures, the uploads are the plan's geometry and the composite's few constants.
    const std::uint64_t uploaded = report["memory"]["bytesUploaded"], geometry = report["bytes"]["geometry"];
    EXPECT_GE(uploaded, geometry);
    EXPECT_LE(uploaded, geometry + 256);
    for (const char* pass : {"surfaces", "accumulate", "composite"})
        EXPECT_GT(report["milliseconds"][pass], 0.0) << pass;
}

TEST(Render, ForcedTechniqueDrawsWhatTheLightLacks) {
    Glb glb = wallScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"shape", "frustum"}, {"shadow", "none"}};
    const Pixels plain = render(glb, {"--layer", "shafts", "--accum", "rgba32f"});
    const Pixels forced =
        render(glb, {"--layer", "shafts", "--accum", "rgba32f", "--technique", "clip_nonoise_shadow_cookie_technique"});
    ASSERT_EQ(plain.width, 64);
    ASSERT_EQ(forced.width, 64);
    // A white cookie and an empty shadow map change only the last bits of a product.
    for (std::size_t i = 0; i < plain.values.size(); ++i) EXPECT_NEAR(forced.values[i], plain.values[i], 1e-5f);
}

TEST(Render, PngByDefaultBesideNothingElse) {
    const std::string picture = freshPath("picture.png");
    const ProgramRun run = runTyndall({"render", writeScene(wallScene()), "-o", picture, "--size", "33x17"});
    ASSERT_EQ(run.status, 0) << run.errors;
    const Pixels pixels = readPixels(picture);
    EXPECT_EQ(pixels.width, 33);
    EXPECT_EQ(pixels.height, 17);
    EXPECT_EQ(neighbours(picture), std::vector<std::string>{"picture.png"});
}

}  // namespace
}  // namespace tyndall::test
