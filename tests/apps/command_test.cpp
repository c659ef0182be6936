// The command line: accepted options, messages and exit status.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "glb.h"
#include "program.h"

namespace tyndall::test {
namespace {

constexpr int failed = 1, wrongCommandLine = 2;

void expectRefusal(const ProgramRun& run, int status, const std::string& says) {
    EXPECT_EQ(run.status, status) << run.errors;
    EXPECT_TRUE(run.errors.starts_with("tyndall: error: ")) << run.errors;
    EXPECT_NE(run.errors.find(says), std::string::npos) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << "one sentence: " << run.errors;
    EXPECT_EQ(run.output, "");
}

struct WrongLine {
    const char* name;
    std::vector<std::string> options;
    const char* says;
};

class CommandLine : public testing::TestWithParam<WrongLine> {};

TEST_P(CommandLine, IsRefusedBeforeAnythingIsRead) {
    const std::string picture = freshPath("picture.png");
    std::vector<std::string> arguments = {"render", "no-such-scene.glb", "-o", picture};
    arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
    expectRefusal(runTyndall(arguments), wrongCommandLine, GetParam().says);
    EXPECT_TRUE(neighbours(picture).empty());
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, CommandLine,
    testing::Values(WrongLine{"SizeZero", {"--size", "0x0"}, "each side must be from 1 to 16384"},
                    WrongLine{"SizeHuge", {"--size", "100000x100000"}, "each side must be from 1 to 16384"},
                    WrongLine{"SizeOverflowing", {"--size", "99999999999999999999x1"}, "out of bounds"},
                    WrongLine{"SizeJunk", {"--size", "big"}, "is not a size"},
                    WrongLine{"SizeHalf", {"--size", "640x"}, "is not a size"},
                    WrongLine{"SizeNegative", {"--size=-4x4"}, "is not a size"},
                    WrongLine{"SizeTrailing", {"--size", "640x360p"}, "is not a size"},
                    WrongLine{"PlanesZero", {"--planes", "0"}, "from 1 to 65536"},
                    WrongLine{"PlanesTooMany", {"--planes", "65537"}, "from 1 to 65536"},
                    WrongLine{"PlanesJunk", {"--planes", "many"}, "--planes"},
                    WrongLine{"MaxSlicesZero", {"--max-slices", "0"}, "from 1 to 65536"},
                    WrongLine{"MaxSlicesWithPlanes", {"--max-slices", "9", "--planes", "9"}, "leave --planes out"},
                    WrongLine{"MaxSlicesOfTheArticle", {"--max-slices", "9", "--look", "article"}, "--look article"},
                    WrongLine{"PlanesOddWhenRouted", {"--accum", "rgba8-routed", "--planes", "6"}, "multiple of 4"},
                    WrongLine{"MethodUnknown", {"--method", "magic"}, "slices, raycast"},
                    WrongLine{"PlanesOfRays", {"--method", "raycast", "--planes", "9"}, "has no slices"},
                    WrongLine{"MaxSlicesOfRays", {"--method", "raycast", "--max-slices", "9"}, "has no slices"},
                    WrongLine{"QuadsOfRays", {"--method", "raycast", "--geometry", "quads"}, "has no slices"},
                    WrongLine{"ShadowSizeZero", {"--shadow-size", "0"}, "--shadow-size"},
                    WrongLine{"RangeZero", {"--range", "0"}, "--range"},
                    WrongLine{"AccumUnknown", {"--accum", "rgb5"}, "rgba8-routed"},
                    WrongLine{"GeometryUnknown", {"--geometry", "cubes"}, "polygons"},
                    WrongLine{"LookUnknown", {"--look", "nice"}, "article"},
                    WrongLine{"LayerUnknown", {"--layer", "floor"}, "shafts"},
                    WrongLine{
                        "TechniqueUnknown", {"--technique", "clip_technique"}, "clip_nonoise_shadow_cookie_technique"},
                    WrongLine{"ShaftsIntoPng", {"--layer", "shafts"}, "write an .exr"},
                    WrongLine{"OptionUnknown", {"--sise", "1x1"}, "--sise"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Command, OutputExtensionUnknown) {
    expectRefusal(runTyndall({"render", "scene.glb", "-o", "picture.jpeg"}), wrongCommandLine, ".png nor .exr");
}

TEST(Command, NothingAsked) {
    expectRefusal(runTyndall({}), wrongCommandLine, "render, explain, reference, compare");
}

TEST(Command, UnknownNamesTheKnown) {
    expectRefusal(runTyndall({"rendre", "scene.glb"}), wrongCommandLine, "no command \"rendre\"; take one of render");
}

TEST(Command, Version) {
    const ProgramRun run = runTyndall({"--version"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.output, "tyndall " TYNDALL_VERSION "\n");
    EXPECT_EQ(run.errors, "");
}

TEST(Command, ExposureDoesNothingToRadiance) {
    expectRefusal(runTyndall({"render", "scene.glb", "-o", "picture.exr", "--exposure", "1"}), wrongCommandLine,
                  "--exposure: picture.exr holds radiance");
}

TEST(Command, CompareChecksItsNumbers) {
    for (const char* option : {"--max-relative-l2", "--max-energy", "--max-dead-zone", "--banding-threshold"})
        for (const char* value : {"-1", "nan", "inf"})
            expectRefusal(runTyndall({"compare", "a.exr", "b.exr", std::string(option) + "=" + value}),
                          wrongCommandLine, option);
    expectRefusal(runTyndall({"compare", "a.exr", "b.exr", "--max-run=-1"}), wrongCommandLine, "--max-run");
    expectRefusal(runTyndall({"compare", "a.exr", "b.exr", "--difference", "d.jpg"}), wrongCommandLine, "nor .exr");
    expectRefusal(runTyndall({"compare", "a.exr", "b.exr", "--difference-scale", "1"}), wrongCommandLine,
                  "--difference OUT.png");
    expectRefusal(runTyndall({"compare", "a.exr"}), wrongCommandLine, "reference is required");
}

TEST(Command, ALinkIsFollowedToTheFileItNames) {
    const std::string target = freshPath("target.png"), link = freshPath("link.png");
    std::filesystem::create_symlink(target, link);
    const std::string scene = writeScene(wallScene());
    for (const char* size : {"4x3", "6x5"}) {  // a new file, then an existing one
        const ProgramRun run = runTyndall({"render", scene, "-o", link, "--size", size});
        ASSERT_EQ(run.status, 0) << run.errors;
        EXPECT_TRUE(std::filesystem::is_symlink(link));
        EXPECT_EQ(readPixels(target).width, size[0] - '0');
    }
    EXPECT_EQ(neighbours(link), std::vector<std::string>{"link.png"});
    EXPECT_EQ(neighbours(target), std::vector<std::string>{"target.png"});
    expectRefusal(runTyndall({"render", scene, "-o", target, "--stats", link}), failed, "picture's file");
}

TEST(Command, ALinkThatLeadsNowhereIsRefused) {
    const std::string link = freshPath("link.png");
    std::filesystem::create_symlink(link, link);
    expectRefusal(runTyndall({"render", writeScene(wallScene()), "-o", link}), failed, "symbolic link in a cycle");
}

TEST(Command, HelpIsNoError) {
    const ProgramRun run = runTyndall({"render", "--help"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.output.find("--planes"), std::string::npos);
    EXPECT_EQ(run.errors, "");
}

TEST(Command, SceneMissing) {
    expectRefusal(runTyndall({"explain", "no-such-scene.glb"}), failed, "no-such-scene.glb: no such file");
}

TEST(Command, CameraUnknownListsTheCameras) {
    expectRefusal(runTyndall({"explain", writeScene(wallScene()), "--camera", "Ear"}), failed, "it has \"Eye\"");
}

TEST(Command, FolderOfTheOutputMissing) {
    expectRefusal(runTyndall({"render", writeScene(wallScene()), "-o", "/no/such/folder/picture.png"}), failed,
                  "cannot be written");
}

TEST(Command, OutputIsAFolder) {
    const std::string folder = freshPath("picture.png");
    std::filesystem::create_directory(folder);
    expectRefusal(runTyndall({"render", writeScene(wallScene()), "-o", folder}), failed, "is a folder");
}

TEST(Command, OutputIsRefusedBeforeTheSceneIsRead) {
    expectRefusal(runTyndall({"render", "no-such-scene.glb", "-o", "/no/such/folder/picture.png"}), failed,
                  "/no/such/folder/picture.png");
}

TEST(Command, StatisticsUnwritable) {
    const std::string picture = freshPath("picture.png");
    expectRefusal(runTyndall({"render", writeScene(wallScene()), "-o", picture, "--stats", "/no/such/folder/s.json"}),
                  failed, "/no/such/folder/s.json");
    EXPECT_TRUE(neighbours(picture).empty());
}

TEST(Command, StatisticsDoNotTakeTheScenesPlace) {
    const std::string scene = writeScene(wallScene());
    const auto size = std::filesystem::file_size(scene);
    expectRefusal(runTyndall({"render", scene, "-o", freshPath("picture.png"), "--stats", scene}), failed,
                  "is the scene");
    EXPECT_EQ(std::filesystem::file_size(scene), size);
}

TEST(Command, StatisticsDoNotTakeAPipesPlace) {
    const std::string pipe = freshPath("pipe.json");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    expectRefusal(runTyndall({"render", writeScene(wallScene()), "-o", freshPath("picture.png"), "--stats", pipe}),
                  failed, "not a plain file");
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(Command, StatisticsDoNotTakeThePicturesPlace) {
    const std::string picture = freshPath("picture.png");
    expectRefusal(runTyndall({"render", writeScene(wallScene()), "-o", picture, "--stats", picture}), failed,
                  "picture's file");
    EXPECT_TRUE(neighbours(picture).empty());
}

TEST(Command, OutputWithoutAName) {
    expectRefusal(runTyndall({"render", "scene.glb", "-o", ""}), wrongCommandLine, "name is empty");
}

TEST(Command, NoVulkanDevice) {
    const std::string picture = freshPath("picture.png");
    const ProgramRun run = runTyndall({"render", writeScene(wallScene()), "-o", picture},
                                      {"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"});
    expectRefusal(run, failed, "ulkan");
    EXPECT_TRUE(neighbours(picture).empty());
}

TEST(Command, BrokenSceneLeavesNothingBehind) {
    const std::string picture = freshPath("picture.png");
    std::vector<unsigned char> bytes = wallScene().bytes();
    bytes.resize(bytes.size() / 2);
    expectRefusal(runTyndall({"render", writeBytes(bytes, "half.glb"), "-o", picture}), failed, "cut short");
    EXPECT_TRUE(neighbours(picture).empty());
}

TEST(Command, ExplainNeedsNoDevice) {
    const ProgramRun run = runTyndall({"explain", writeScene(wallScene())},
                                      {"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"});
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_NE(run.output.find("light \"Lamp\": drawn"), std::string::npos) << run.output;
    // The wall blocks all of the light, so nothing behind it can be in shadow.
    EXPECT_NE(run.output.find("clip_nonoise_noshadow_cookie_technique"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("Ends at a wall"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("without the scene's depth"), std::string::npos) << run.output;
}

TEST(Command, ExplainAsJson) {
    Glb glb = wallScene();
    glb.json["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"type", "point"}});
    glb.addNode({{"name", "Bulb"}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    const ProgramRun run = runTyndall({"explain", writeScene(glb), "--json", "--planes", "8"});
    ASSERT_EQ(run.status, 0) << run.errors;
    const auto report = nlohmann::json::parse(run.output);
    ASSERT_EQ(report["lights"].size(), 2u);
    EXPECT_EQ(report["lights"][0]["name"], "Lamp");
    EXPECT_EQ(report["lights"][0]["slices"], 8);
    EXPECT_EQ(report["lights"][0]["shadow"], false);
    EXPECT_EQ(report["lights"][0]["saved"].size(), 2u) << report["lights"][0]["saved"];
    EXPECT_EQ(report["lights"][1]["drawn"], false);
    EXPECT_NE(report["lights"][1]["reason"].get<std::string>().find("point light"), std::string::npos);
}

TEST(Command, SlicesAreAsManyAsNeededUpToABound) {
    const std::string scene = writeScene(wallScene());
    const auto slices = [&](const std::vector<std::string>& options) {
        std::vector<std::string> words{"explain", scene, "--json"};
        words.insert(words.end(), options.begin(), options.end());
        const ProgramRun run = runTyndall(words);
        return nlohmann::json::parse(run.output)["lights"][0]["slices"].get<int>();
    };
    const int needed = slices({"--max-slices", "65536"});
    EXPECT_GT(needed, 40);
    EXPECT_LE(slices({}), std::min(needed, 256));
    EXPECT_GE(slices({}), std::min(needed, 250));
    EXPECT_LE(slices({"--max-slices", "20"}), 20);
    EXPECT_GE(slices({"--max-slices", "20"}), 18);
}

TEST(Command, ExplainsRays) {
    const std::string scene = writeScene(wallScene());
    const ProgramRun json = runTyndall({"explain", scene, "--json", "--method", "raycast"});
    ASSERT_EQ(json.status, 0) << json.errors;
    const nlohmann::json report = nlohmann::json::parse(json.output);
    EXPECT_EQ(report["method"], "raycast");
    EXPECT_EQ(report["slices"], 0);
    EXPECT_GT(report["expectedFragments"], 0);
    const ProgramRun text = runTyndall({"explain", scene, "--method", "raycast"});
    EXPECT_NE(text.output.find("a ray for each pixel"), std::string::npos) << text.output;
    EXPECT_NE(text.output.find("of raycast.fx: about"), std::string::npos) << text.output;
    EXPECT_EQ(text.output.find("slabs"), std::string::npos) << text.output;
}

TEST(Command, NothingInTheConeMeansNoShadowMap) {
    Glb glb = wallScene();
    glb.json["nodes"][0]["translation"] = {0, 0, 50};  // behind lamp and camera
    const ProgramRun run = runTyndall({"explain", writeScene(glb), "--json"});
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(nlohmann::json::parse(run.output)["lights"][0]["technique"], "clip_nonoise_noshadow_cookie_technique");
}

}  // namespace
}  // namespace tyndall::test
