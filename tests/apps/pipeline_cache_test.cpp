// `render --pipeline-cache`: the cache is kept between runs, and its problems give only notes.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <tyndall/pipeline_cache.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "glb.h"
#include "program.h"

namespace tyndall::test {
namespace {

using Bytes = std::vector<char>;

Bytes readBytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// One run of a small scene: its notes about the cache, and its picture.
struct Drawing {
    int status;
    std::string notes;
    std::vector<float> picture;
    nlohmann::json cache;
};

Drawing draw(const std::vector<std::string>& options, const std::vector<std::string>& environment = {}) {
    const std::string picture = freshPath("picture.exr"), stats = freshPath("stats.json");
    std::vector<std::string> arguments = {
        "render", writeScene(wallScene()), "-o", picture, "--size", "16x16", "--stats", stats, "--planes", "4"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = runTyndall(arguments, environment);
    EXPECT_EQ(run.status, 0) << run.errors;
    if (run.status != 0) return {run.status, run.errors, {}, {}};
    std::ifstream file(stats);
    return {run.status, run.errors, readPixels(picture).values, nlohmann::json::parse(file)["pipelineCache"]};
}

bool says(const Drawing& run, const std::string& what) {
    return run.notes.find(what) != std::string::npos;
}

TEST(PipelineCache, IsKeptInTheUsersCacheFolder) {
    const std::string home = freshPath("made/when/needed");
    const Drawing first = draw({}, {"XDG_CACHE_HOME=" + home});
    const std::string file = first.cache["file"];
    EXPECT_TRUE(file.starts_with(home + "/tyndall/pipelines-")) << file;
    EXPECT_EQ(first.cache["bytesLoaded"], 0);
    EXPECT_EQ(first.cache["bytesWritten"], std::filesystem::file_size(file));
    EXPECT_FALSE(says(first, "note: ")) << first.notes;
    EXPECT_EQ(neighbours(file).size(), 1u) << "nothing beside it";

    const auto written = std::filesystem::last_write_time(file);
    const Drawing second = draw({}, {"XDG_CACHE_HOME=" + home});
    EXPECT_GE(second.cache["bytesLoaded"], 32);
    EXPECT_EQ(second.cache["bytesWritten"], 0);
    EXPECT_EQ(std::filesystem::last_write_time(file), written);
    EXPECT_FALSE(says(second, "note: ")) << second.notes;
    EXPECT_EQ(second.picture, first.picture);
}

TEST(PipelineCache, HomeWhereTheCacheFolderIsNotAbsolute) {
    const std::string home = freshPath("home");
    for (const char* const unfit : {"XDG_CACHE_HOME=", "XDG_CACHE_HOME=relative"}) {
        const std::string file = draw({}, {unfit, "HOME=" + home}).cache["file"];
        EXPECT_TRUE(file.starts_with(home + "/.cache/tyndall/")) << file;
    }
    const Drawing nowhere = draw({}, {"XDG_CACHE_HOME=", "HOME="});
    EXPECT_TRUE(says(nowhere, "neither XDG_CACHE_HOME nor HOME")) << nowhere.notes;
}

TEST(PipelineCache, NoneKeepsNothing) {
    const std::string home = freshPath("cache");
    EXPECT_EQ(draw({"--pipeline-cache", "none"}, {"XDG_CACHE_HOME=" + home}).cache["file"], "");
    EXPECT_FALSE(std::filesystem::exists(home + "/tyndall"));
}

struct Damage {
    const char* name;
    void (*to)(Bytes&);
    const char* says;
};

class DamagedPipelineCache : public testing::TestWithParam<Damage> {};

TEST_P(DamagedPipelineCache, IsNotedAndMadeAnew) {
    const std::string file = freshPath("pipelines.bin");
    const Drawing whole = draw({"--pipeline-cache", file});
    const Bytes good = readBytes(file);
    ASSERT_GE(good.size(), 80u + 32u);
    Bytes bad = good;
    GetParam().to(bad);
    write(file, bad);

    const Drawing run = draw({"--pipeline-cache", file});
    EXPECT_TRUE(says(run, "note: " + file)) << run.notes;
    EXPECT_TRUE(says(run, GetParam().says)) << run.notes;
    EXPECT_EQ(run.cache["bytesLoaded"], 0);
    EXPECT_EQ(run.picture, whole.picture);
    EXPECT_EQ(readBytes(file), good) << "written again";
}

/// Sealed for a device with these values in its properties; the data are still lavapipe's.
void reseal(Bytes& bytes, std::uint32_t vendor, std::uint32_t driver) {
    const auto data = std::as_bytes(std::span(bytes)).subspan(pipelineCacheSeal);
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
        return value;
    };
    VkPhysicalDeviceProperties other{};
    other.vendorID = number(16) + vendor;
    other.deviceID = number(20);
    other.driverVersion = number(24) + driver;
    std::copy_n(bytes.begin() + 40, VK_UUID_SIZE, other.pipelineCacheUUID);
    const auto sealed = sealPipelineCache(data, other);
    std::transform(sealed.begin(), sealed.end(), bytes.begin(), [](std::byte b) { return static_cast<char>(b); });
}

INSTANTIATE_TEST_SUITE_P(
    Damages, DamagedPipelineCache,
    testing::Values(Damage{"CutShort", [](Bytes& bytes) { bytes.pop_back(); }, "cut short"},
                    Damage{"CutWithinItsName", [](Bytes& bytes) { bytes.resize(5); }, "cut short"},
                    Damage{"OneBitFlipped", [](Bytes& bytes) { bytes.back() ^= 1; }, "corrupt"},
                    Damage{"TooLong", [](Bytes& bytes) { bytes.push_back(0); }, "followed by"},
                    Damage{"OfAnotherDevice", [](Bytes& bytes) { reseal(bytes, 1, 0); }, "another device"},
                    Damage{"OfAnotherDriver", [](Bytes& bytes) { reseal(bytes, 0, 1); }, "another version"},
                    Damage{"OfAnotherFormat", [](Bytes& bytes) { bytes[8] = 2; }, "version 2 of its format"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PipelineCache, AnEmptyFileIsFilled) {
    const std::string file = freshPath("pipelines.bin");
    write(file, {});
    EXPECT_FALSE(says(draw({"--pipeline-cache", file}), "note: "));
    EXPECT_GE(readBytes(file).size(), 80u + 32u);
}

TEST(PipelineCache, WhatIsNotOursIsLeftAlone) {
    const std::string file = freshPath("letter.txt");
    const std::string letter = "not a cache";
    write(file, {letter.begin(), letter.end()});
    const Drawing run = draw({"--pipeline-cache", file});
    EXPECT_TRUE(says(run, "is not a pipeline cache of this program; it is left unchanged")) << run.notes;
    EXPECT_EQ(readBytes(file), Bytes(letter.begin(), letter.end()));

    const std::string folder = std::filesystem::path(file).parent_path().string();
    EXPECT_TRUE(says(draw({"--pipeline-cache", folder}), "is not a plain file"));
    const std::string pipe = freshPath("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_TRUE(says(draw({"--pipeline-cache", pipe}), "is not a plain file"));
}

TEST(PipelineCache, AFolderThatCannotBeWrittenIsANote) {
    const std::string plain = freshPath("plain");
    write(plain, {'x'});
    const Drawing run = draw({}, {"XDG_CACHE_HOME=" + plain});
    EXPECT_TRUE(says(run, "note: ")) << run.notes;
    EXPECT_GT(run.picture.size(), 0u);
    const std::string nowhere = freshPath("no/such/folder/cache.bin");
    EXPECT_TRUE(says(draw({"--pipeline-cache", nowhere}), "note: pipelines are not kept: " + nowhere));
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(nowhere).parent_path()));
}

TEST(PipelineCache, AnotherFilesPlaceIsRefused) {
    const std::string scene = writeScene(wallScene()), picture = freshPath("picture.exr"),
                      stats = freshPath("stats.json");
    for (const std::string& taken : {scene, picture, stats}) {
        const ProgramRun run =
            runTyndall({"render", scene, "-o", picture, "--stats", stats, "--pipeline-cache", taken});
        EXPECT_EQ(run.status, 1);
        EXPECT_NE(run.errors.find("--pipeline-cache: " + taken), std::string::npos) << run.errors;
        EXPECT_FALSE(std::filesystem::exists(picture));
    }
}

}  // namespace
}  // namespace tyndall::test
