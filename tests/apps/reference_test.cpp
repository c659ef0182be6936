// `tyndall reference`: scenes whose shafts have a closed form, in both modes, and the command's files.
#include <gtest/gtest.h>
#include <tyndall/command/commands.h>
#include <tyndall/frame/reference_scene.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "glb.h"
#include "program.h"

namespace tyndall::test {
namespace {

constexpr int side = 16;  // pixels of the square pictures below

/// The lamp is at the eye, so L = 0.1 / (4 pi) * 100 cd * (1/a - 1/b) over a ray from a to b metres. On a slanted ray,
/// planes a and b metres in front of the eye are a and b times the ray's length at 1 m away.
double radiance(int x, int y, double nearPlane, double farPlane) {
    const double tanHalfFov = std::tan(0.35);
    const double u = tanHalfFov * (2.0 * (x + 0.5) / side - 1.0), v = tanHalfFov * (2.0 * (y + 0.5) / side - 1.0);
    return 0.1 / (4.0 * std::numbers::pi) * 100.0 * (1.0 / nearPlane - 1.0 / farPlane) / std::sqrt(1.0 + u * u + v * v);
}

/// The wall's scene with a hard-edged light from 1 to 10 m; the wall is at 5 m.
Glb openScene(const char* shadow) {
    Glb glb = wallScene();
    glb.json["nodes"][2]["extras"]["tyndall"] = {
        {"shape", "frustum"}, {"density", 0.1}, {"near", 1.0}, {"far", 10.0}, {"shadow", shadow}};
    return glb;
}

Pixels computed(const Glb& glb, const char* mode, std::vector<std::string> options = {}) {
    const std::string out = freshPath("reference.exr");
    options.insert(options.begin(), {"reference", writeScene(glb), "-o", out, "--size", "16x16", "--mode", mode});
    if (mode == std::string_view("hardware")) options.insert(options.end(), {"--shadow-size", "64"});
    const ProgramRun run = runTyndall(options);
    EXPECT_EQ(run.status, 0) << run.errors;
    return readPixels(out);
}

/// Ideal: storage rounds by 2^-24 = 6e-8. Hardware: the depth of a surface at d metres is a float that the
/// rasterizer interpolates, with an error of a few units of 2^-24, which 1/d passes on: some 1e-6 of the radiance.
double tolerance(const std::string& mode) {
    return mode == "ideal" ? 1e-7 : 3e-6;
}

class Modes : public testing::TestWithParam<const char*> {
protected:
    /// Every pixel of `picture` sees light from 1 m to `farPlane`.
    void expectRays(const Pixels& picture, double farPlane, double relative = tolerance(GetParam())) const {
        ASSERT_EQ(picture.width, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                EXPECT_NEAR(picture.at(x, y, 1) / radiance(x, y, 1.0, farPlane), 1.0, relative) << x << ", " << y;
    }
};

TEST_P(Modes, RaysEndAtTheWall) {
    expectRays(computed(openScene("none"), GetParam()), 5.0);
}

TEST_P(Modes, AWallFromBehindHidesNothing) {
    Glb glb = openScene("none");
    glb.json["nodes"][0]["rotation"] = {0, 1, 0, 0};
    expectRays(computed(glb, GetParam()), 10.0);
}

TEST_P(Modes, ADoubleSidedWallFromBehindHides) {
    Glb glb = openScene("none");
    glb.json["nodes"][0]["rotation"] = {0, 1, 0, 0};
    glb.json["materials"] = {{{"doubleSided", true}}};
    glb.json["meshes"][0]["primitives"][0]["material"] = 0;
    expectRays(computed(glb, GetParam()), 5.0);
}

TEST_P(Modes, AMirroredWallKeepsItsFront) {
    Glb glb = openScene("none");
    glb.json["nodes"][0]["scale"] = {-1, 1, 1};
    expectRays(computed(glb, GetParam()), 5.0);
    glb.json["nodes"][0]["rotation"] = {0, 1, 0, 0};
    expectRays(computed(glb, GetParam()), 10.0);
}

TEST_P(Modes, WhatIsSeenFromBehindStillThrowsAShadow) {
    Glb glb = openScene("static");
    // Covers the whole cone at 2 m; its back is turned to the lamp and to the eye.
    glb.addNode({{"mesh", 0}, {"translation", {0, 0, -2}}, {"rotation", {0, 1, 0, 0}}});
    // A ray through the lamp spans no plane with it. The integrator moves it to a distance of 1e-8 of its length;
    // doubles place a shadow's edge with the same relative error (study/src/occlusion.cpp).
    expectRays(computed(glb, GetParam()), 2.0, tolerance(GetParam()) + 4e-8);
    glb.json["nodes"][2]["extras"]["tyndall"]["shadow"] = "none";
    expectRays(computed(glb, GetParam()), 5.0);
}

TEST_P(Modes, AnEmptyVolumeThrowsNoShadow) {
    // The wall is beyond the light's far plane: neither renderer nor reference needs a shadow map.
    Glb glb = openScene("static");
    glb.json["nodes"][2]["extras"]["tyndall"]["far"] = 4.0;
    const std::string stats = freshPath("stats.json");
    expectRays(computed(glb, GetParam(), {"--stats", stats}), 4.0);
    std::ifstream file(stats);
    EXPECT_EQ(nlohmann::json::parse(file)["lights"][0]["shadow"], false);
}

TEST_P(Modes, ACookieIsTheSlideThatRenderShows) {
    Glb glb = openScene("none");
    // Top left red, top right green, bottom left blue, bottom right white.
    const std::size_t slide =
        glb.addTexture(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
    glb.json["nodes"][2]["extras"]["tyndall"]["cookie"] = slide;
    const Pixels picture = computed(glb, GetParam());
    ASSERT_EQ(picture.width, side);
    const int corners[4][2] = {{1, 1}, {14, 1}, {1, 14}, {14, 14}};
    const bool lit[4][3] = {{true, false, false}, {false, true, false}, {false, false, true}, {true, true, true}};
    for (int corner = 0; corner < 4; ++corner)
        for (int c = 0; c < 3; ++c) {
            const int x = corners[corner][0], y = corners[corner][1];
            EXPECT_NEAR(picture.at(x, y, c) / radiance(x, y, 1.0, 5.0), lit[corner][c] ? 1.0 : 0.0,
                        tolerance(GetParam()));
        }
}

TEST_P(Modes, TexturesAreRoundedWhereTheRendererRoundsThem) {
    Glb glb = openScene("none");
    glb.json["nodes"][2]["extras"]["tyndall"]["cookie"] = glb.addTexture(1, 1, {100, 100, 100, 255});
    const Pixels picture = computed(glb, GetParam());
    ASSERT_EQ(picture.width, side);
    const auto grey = static_cast<float>(std::pow((100.0 / 255.0 + 0.055) / 1.055, 2.4));
    const float uploaded = glm::unpackHalf1x16(glm::packHalf1x16(grey));
    ASSERT_GT(std::abs(uploaded / grey - 1.0f), 1e-5f) << "the test needs a value that half floats lack";
    const double expected = std::string(GetParam()) == "ideal" ? grey : uploaded;
    // The sRGB curve in floats has errors of a few 1e-7.
    EXPECT_NEAR(picture.at(5, 9, 0) / radiance(5, 9, 1.0, 5.0) / expected, 1.0, tolerance(GetParam()) + 1e-6);
}

TEST_P(Modes, AConeFallsOffAsTheExtensionSays) {
    Glb glb = wallScene();  // half angles of 0.2 and 0.35
    glb.json["nodes"][2]["extras"]["tyndall"] = {{"density", 0.1}, {"near", 1.0}, {"shadow", "none"}};
    const bool ideal = std::string(GetParam()) == "ideal";
    for (const bool slide : {false, true}) {
        if (slide)  // red and a little green
            glb.json["nodes"][2]["extras"]["tyndall"]["cookie"] = glb.addTexture(1, 1, {255, 100, 0, 255});
        const double green = slide ? std::pow((100.0 / 255.0 + 0.055) / 1.055, 2.4) : 1.0;
        const Pixels picture = computed(glb, GetParam());
        ASSERT_EQ(picture.width, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double tanHalfFov = std::tan(0.35);
                const double u = tanHalfFov * (2.0 * (x + 0.5) / side - 1.0),
                             v = tanHalfFov * (2.0 * (y + 0.5) / side - 1.0);
                const double cosine = 1.0 / std::sqrt(1.0 + u * u + v * v);
                // KHR_lights_punctual, "Inner and Outer Cone Angles".
                const double share = std::clamp((cosine - std::cos(0.35)) / (std::cos(0.2) - std::cos(0.35)), 0.0, 1.0);
                const double full = radiance(x, y, 1.0, 5.0);
                // Baked into 512 texels: averaged over a texel and interpolated between two, which errs by less than
                // the squared texel, 0.35 / 256, times the falloff's second derivative, 2 / 0.15^2; and rounded.
                const double baked = ideal ? 0.0 : 2.0 * std::pow(0.35 / 256 / 0.15, 2.0) + std::exp2(-11.0);
                const double mask = share * share, allowed = tolerance(GetParam()) + baked;
                EXPECT_NEAR(picture.at(x, y, 0) / full, mask, allowed) << x << ", " << y;
                EXPECT_NEAR(picture.at(x, y, 1) / full, green * mask, allowed + 1e-6) << x << ", " << y;
            }
    }
}

TEST_P(Modes, TimeMovesTheScene) {
    Glb glb = openScene("none");
    const std::size_t times = glb.addFloats({0.0f, 2.0f}, "SCALAR");
    glb.json["accessors"][times]["min"] = {0.0};
    glb.json["accessors"][times]["max"] = {2.0};
    const std::size_t places = glb.addFloats({0, 0, -5, 0, 0, -3}, "VEC3");
    glb.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}},
                               {"samplers", {{{"input", times}, {"output", places}}}}}};
    expectRays(computed(glb, GetParam(), {"--time", "1"}), 4.0);
}

INSTANTIATE_TEST_SUITE_P(Reference, Modes, testing::Values("ideal", "hardware"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Reference, TheHardwareModeHoldsWhatTheRendererDrewAndDrawsItWithoutAMessage) {
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
        setenv(name, "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json", 1);
    app::ViewOptions options;
    options.scene = writeScene(openScene("static"));
    options.size = {side, side};
    const auto device = headless::Device::create({.validation = true});
    ASSERT_TRUE(device) << device.error().message;
    const auto viewed = app::viewScene(options);
    ASSERT_TRUE(viewed) << viewed.error().message;
    const auto scene = app::hardwareScene(*device, *viewed, options, 32);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(device->messages(), std::vector<std::string>{});
    // Reversed depth of a wall 5 m away: from a near plane at 0.1 m to infinity 0.1 / 5; from the lamp's planes at
    // n = 1 and f = 10 m (n f / 5 - n) / (f - n). Both are rounded to floats by the rasterizer's interpolation.
    ASSERT_EQ(scene->depth.values.size(), static_cast<std::size_t>(side * side));
    for (const float stored : scene->depth.values) EXPECT_NEAR(stored, 0.1 / 5.0, 1e-8);
    ASSERT_EQ(scene->lights[0].shadowMap.values.size(), 32u * 32u);
    for (const float stored : scene->lights[0].shadowMap.values) EXPECT_NEAR(stored, (10.0 / 5.0 - 1.0) / 9.0, 1e-7);
    EXPECT_TRUE(scene->triangles.empty());
}

TEST(Reference, RenderingConvergesToTheHardwareMode) {
    Glb glb = openScene("static");
    glb.addNode({{"mesh", glb.addSquare(0.2f)}, {"translation", {0.1, 0.05, -2}}});
    glb.json["nodes"][1]["translation"] = {1.5, 0, 0};
    glb.json["nodes"][1]["rotation"] = {0, std::sin(0.2), 0, std::cos(0.2)};
    const std::string scene = writeScene(glb), reference = freshPath("reference.exr"), image = freshPath("image.exr");
    const std::vector<std::string> common = {scene, "--size", "48x32", "--shadow-size", "128"};
    const auto run = [&](std::vector<std::string> options) {
        options.insert(options.begin() + 1, common.begin(), common.end());
        const ProgramRun done = runTyndall(options);
        EXPECT_EQ(done.status, 0) << done.errors;
    };
    run({"reference", "-o", reference, "--mode", "hardware"});
    double last = 1.0;
    // A hard edge makes midpoints err by 1/N in a pixel that sees it, and the smooth rest by 1/N^2. Over random
    // positions of the edge within a slab the L2 error falls with 1/N: 16 times for 16 times the slices. The test
    // requires half of that.
    for (const char* planes : {"32", "512"}) {
        run({"render", "-o", image, "--layer", "shafts", "--accum", "rgba32f", "--planes", planes});
        const ProgramRun compared = runTyndall({"compare", image, reference, "--json"});
        ASSERT_EQ(compared.status, 0) << compared.errors;
        const double error = nlohmann::json::parse(compared.output)["relativeL2"];
        EXPECT_LT(error, last / 8.0) << planes;
        last = error;
    }
    // About a slab's share of the 10 m, 1/512, for each of a pixel's two or three edges.
    EXPECT_LT(last, 8e-3);
}

TEST(Reference, SaysWhatItTookAndReached) {
    const std::string out = freshPath("reference.exr"), stats = freshPath("stats.json");
    const ProgramRun run = runTyndall(
        {"reference", writeScene(wallScene()), "-o", out, "--size", "8x4", "--accuracy", "1e-6", "--stats", stats});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.output, "");
    EXPECT_NE(run.errors.find("evaluations, relative error at most"), std::string::npos) << run.errors;
    EXPECT_EQ(run.errors.find('\r'), std::string::npos) << "no progress line without a terminal";
    std::ifstream file(stats);
    const auto report = nlohmann::json::parse(file);
    EXPECT_EQ(report["mode"], "ideal");
    EXPECT_TRUE(report.contains("technique") && report["technique"].is_null());
    EXPECT_EQ(report["size"], (std::vector<int>{8, 4}));
    EXPECT_EQ(report["triangles"], 2);
    EXPECT_EQ(report["accuracy"]["asked"], 1e-6);
    EXPECT_LE(report["accuracy"]["reached"], 1e-6);
    EXPECT_GT(report["evaluations"], 0);
    EXPECT_GT(report["seconds"]["integrating"], 0.0);
    EXPECT_EQ(report["lights"][0]["name"], "Lamp");
}

TEST(Reference, StrengthsBeyondThePicturesFloatsAreTheScenes) {
    Glb glb = openScene("none");
    glb.json["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 1e308;
    const std::string out = freshPath("reference.exr");
    const ProgramRun run = runTyndall({"reference", writeScene(glb), "-o", out, "--size", "8x8"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.errors.find("lower the scene's intensities"), std::string::npos) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_TRUE(neighbours(out).empty());
}

TEST(Reference, StatisticsNameTheTechnique) {
    const std::string name = "clip_nonoise_noshadow_cookie_technique", stats = freshPath("stats.json");
    computed(openScene("static"), "ideal", {"--technique", name, "--stats", stats});
    std::ifstream file(stats);
    EXPECT_EQ(nlohmann::json::parse(file)["technique"], name);
}

TEST(Reference, ThreadsDoNotChangeAPixel) {
    const Pixels one = computed(openScene("static"), "ideal", {"--threads", "1"});
    const Pixels five = computed(openScene("static"), "ideal", {"--threads", "5"});
    ASSERT_EQ(one.width, side);
    EXPECT_EQ(one.values, five.values);
}

app::ReferenceOptions ideal(const std::string& out) {
    app::ReferenceOptions options;
    options.view.scene = writeScene(openScene("none"));
    options.view.size = {32, 32};
    options.output = out;
    return options;
}

TEST(Reference, StoppedAtAnyPointItLeavesNothing) {
    for (const int calls : {0, 1}) {  // before the first pixel, and among them
        const std::string out = freshPath("reference.exr");
        int count = 0;
        app::ReferenceOptions options = ideal(out);
        // One pixel ends before the next progress call; the other size takes over a second, with many calls.
        options.view.size = calls == 0 ? app::Size{1, 1} : app::Size{1024, 1024};
        const auto result = app::reference(options, [&](double) { return count++ < calls; });
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().message, "interrupted; nothing was written");
        EXPECT_TRUE(neighbours(out).empty());
    }
}

TEST(Reference, ProgressRises) {
    double last = 0.0;
    ASSERT_TRUE(app::reference(ideal(freshPath("reference.exr")), [&](double share) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1.0);
        last = share;
        return true;
    }));
}

TEST(Reference, ASignalEndsItAndTheOldPictureStays) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string out = freshPath("reference.exr");
        std::ofstream(out) << "an older picture";
        // Minutes of work.
        const ProgramRun run =
            interruptTyndall({"reference", writeScene(openScene("static")), "-o", out, "--size", "4000x4000"}, signal);
        EXPECT_EQ(run.status, 1);
        EXPECT_EQ(run.errors, "tyndall: error: interrupted; nothing was written\n");
        EXPECT_EQ(neighbours(out), std::vector<std::string>{"reference.exr"});
        EXPECT_EQ(std::filesystem::file_size(out), 16u);
    }
}

TEST(Reference, CommandLine) {
    const auto refused = [](std::vector<std::string> options, int status, const char* says) {
        options.insert(options.begin(), {"reference", "no-such-scene.glb"});
        const ProgramRun run = runTyndall(options);
        EXPECT_EQ(run.status, status);
        EXPECT_NE(run.errors.find(says), std::string::npos) << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    };
    const std::string out = freshPath("r.exr");
    refused({}, 2, "--output is required");
    refused({"-o", ""}, 2, "name is empty");
    refused({"-o", "r.png"}, 2, "write an .exr");
    for (const char* accuracy : {"0", "1e-13", "2", "nan", "-1"})
        refused({"-o", out, std::string("--accuracy=") + accuracy}, 2, "from 1e-12 to 1");
    refused({"-o", out, "--threads=-1"}, 2, "--threads");
    refused({"-o", out, "--threads", "5000"}, 2, "from 0 to 1024");
    refused({"-o", out, "--mode", "real"}, 2, "ideal, hardware");
    refused({"-o", out, "--mode", "hardware", "--shadow-size", "0"}, 2, "from 1 to 16384");
    for (const char* texels : {"1024", "64"})  // the default too, if given explicitly
        refused({"-o", out, "--shadow-size", texels}, 2, "the ideal mode has no shadow maps");
    refused({"-o", out, "--size", "0x4"}, 2, "each side");
    refused({"-o", out, "--layer", "all"}, 2, "--layer");
    refused({"-o", out}, 1, "no such file");
    refused({"-o", out, "--stats", out}, 1, "picture's file");
    refused({"-o", "/no/such/folder/r.exr"}, 1, "/no/such/folder");
    EXPECT_TRUE(neighbours(out).empty());
}

}  // namespace
}  // namespace tyndall::test
