// `tyndall compare`: figures and verdict from two files.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "exr.h"
#include "glb.h"
#include "program.h"

namespace tyndall::test {
namespace {

/// 8 x 6 pixels of three channels, all different, exact as half floats too.
study::Image picture() {
    study::Image image{8, 6, 3, {}};
    for (int k = 0; k < 8 * 6 * 3; ++k) image.values.push_back(0.25f + static_cast<float>(k) / 256.0f);
    return image;
}

std::size_t index(int x, int y, int channel) {
    return static_cast<std::size_t>((y * 8 + x) * 3 + channel);
}

nlohmann::json report(const std::string& image, const std::string& reference, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"compare", image, reference, "--json"});
    const ProgramRun run = runTyndall(options);
    EXPECT_EQ(run.status, 0) << run.errors;
    return nlohmann::json::parse(run.output, nullptr, false);
}

TEST(Compare, APictureEqualsItself) {
    const std::string path = writeExr(picture());
    const auto figures = report(path, path, {"--max-absolute", "0", "--max-relative-l2", "0", "--max-run", "0"});
    EXPECT_EQ(figures["relativeL2"], 0.0);
    EXPECT_EQ(figures["maximumAbsolute"], 0.0);
    EXPECT_EQ(figures["energy"], 0.0);
    EXPECT_EQ(figures["compared"], 8 * 6 * 3);
    EXPECT_EQ(figures["passed"], true);
}

TEST(Compare, FiguresAreTheFilesOwn) {
    study::Image image = picture();
    image.values[index(5, 4, 1)] += 2.0f;
    const auto figures = report(writeExr(image), writeExr(picture()));
    double squares = 0.0, sum = 0.0;
    for (const float value : picture().values) {
        squares += value * value;
        sum += value;
    }
    EXPECT_DOUBLE_EQ(figures["relativeL2"], std::sqrt(4.0 / squares));
    EXPECT_DOUBLE_EQ(figures["energy"], 2.0 / sum);
    EXPECT_EQ(figures["maximumAbsolute"], 2.0);
    EXPECT_EQ(figures["worst"]["x"], 5);
    EXPECT_EQ(figures["worst"]["y"], 4);
    EXPECT_EQ(figures["worst"]["channel"], "G");
    EXPECT_EQ(figures["worst"]["reference"], picture().values[index(5, 4, 1)]);
}

TEST(Compare, TextNamesEveryFigure) {
    study::Image image = picture();
    for (int x = 0; x < 8; ++x) image.values[index(x, 2, 0)] = 0.0f;
    const ProgramRun run = runTyndall({"compare", writeExr(image), writeExr(picture())});
    EXPECT_EQ(run.status, 0) << run.errors;
    for (const char* part : {"8x6, R G B, 32-bit float", "relative L2 ", "relative mean square", "largest error",
                             "R of pixel (7, 2): 0 instead of", "energy                -",
                             "8 equal pixels along the row from R of pixel (0, 2)", "dead zone             8 values"})
        EXPECT_NE(run.output.find(part), std::string::npos) << part << "\n" << run.output;
    EXPECT_EQ(run.errors, "");
}

struct Limit {
    const char* option;
    const char* fails;  ///< a limit that the comparison below exceeds
    const char* holds;
    const char* says;
};

class Limits : public testing::TestWithParam<Limit> {};

TEST_P(Limits, EndWithOneAndNameFigureAndPixel) {
    study::Image image = picture();
    image.values[index(1, 3, 2)] = 0.0f;
    image.values[index(4, 5, 0)] = image.values[index(5, 5, 0)];
    const std::string path = writeExr(image), reference = writeExr(picture());
    const ProgramRun good = runTyndall({"compare", path, reference, GetParam().option, GetParam().holds});
    EXPECT_EQ(good.status, 0) << good.errors;
    const ProgramRun bad = runTyndall({"compare", path, reference, GetParam().option, GetParam().fails});
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.output, good.output) << "figures are printed with every verdict";
    EXPECT_NE(bad.errors.find(GetParam().says), std::string::npos) << bad.errors;
    EXPECT_NE(bad.errors.find(GetParam().option), std::string::npos) << bad.errors;
    EXPECT_EQ(std::count(bad.errors.begin(), bad.errors.end(), '\n'), 1) << bad.errors;
}

// One value of 0.25 + 77/256 = 0.551 is lost; the 144 values have the mean 0.529 and the mean square 0.306.
// Relative L2 0.083, mean square 0.0069, energy -0.0072.
INSTANTIATE_TEST_SUITE_P(
    Options, Limits,
    testing::Values(Limit{"--max-relative-l2", "0.08", "0.09", "worst is B of pixel (1, 3): 0 instead of 0.550781"},
                    Limit{"--max-relative-mean-square", "0.006", "0.008", "B of pixel (1, 3)"},
                    Limit{"--max-absolute", "0.55", "0.56", "B of pixel (1, 3)"},
                    Limit{"--max-energy", "0.007", "0.008", "B of pixel (1, 3)"},
                    Limit{"--max-run", "1", "2", "2 equal pixels along the row from R of pixel (4, 5)"},
                    Limit{"--max-dead-zone", "0.55", "0.56", "up to 0.551 at B of pixel (1, 3)"}),
    [](const auto& test) {
        std::string name = test.param.option;
        std::erase(name, '-');
        return name;
    });

TEST(Compare, WhatIsNoNumberFailsWithoutBeingAsked) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        for (const bool inImage : {true, false}) {
            study::Image broken = picture();
            broken.values[index(7, 1, 1)] = bad;
            const std::string a = writeExr(inImage ? broken : picture()), b = writeExr(inImage ? picture() : broken);
            const ProgramRun run = runTyndall({"compare", a, b});
            EXPECT_EQ(run.status, 1);
            EXPECT_NE(run.errors.find(inImage ? "the image holds" : "the reference holds"), std::string::npos);
            EXPECT_NE(run.errors.find("the first at G of pixel (7, 1)"), std::string::npos) << run.errors;
            EXPECT_NE(run.output.find("not finite"), std::string::npos);
        }
    study::Image broken = picture();
    broken.values[3] = std::numeric_limits<float>::quiet_NaN();
    const std::string path = writeExr(broken);
    EXPECT_EQ(runTyndall({"compare", path, path}).status, 1) << "NaN fails even if both have it";
}

TEST(Compare, WithoutANumberInBothThereAreNoFigures) {
    study::Image none = picture(), odd = picture(), even = picture();
    for (std::size_t k = 0; k < none.values.size(); ++k) {
        none.values[k] = std::numeric_limits<float>::quiet_NaN();
        (k % 2 == 0 ? even : odd).values[k] = std::numeric_limits<float>::infinity();
    }
    for (const auto& [image, reference] : {std::pair(none, none), std::pair(none, picture()), std::pair(odd, even)}) {
        const std::string a = writeExr(image), b = writeExr(reference);
        const ProgramRun text = runTyndall({"compare", a, b, "--max-relative-l2", "0.1"});
        EXPECT_EQ(text.status, 1);
        EXPECT_NE(text.output.find("nothing to compare"), std::string::npos) << text.output;
        for (const char* figure : {"relative L2", "largest error", "energy", "banding", "dead zone"})
            EXPECT_EQ(text.output.find(figure), std::string::npos) << text.output;
        const ProgramRun run = runTyndall({"compare", a, b, "--json"});
        EXPECT_EQ(run.status, 1);
        const auto figures = nlohmann::json::parse(run.output, nullptr, false);
        EXPECT_EQ(figures["compared"], 0);
        EXPECT_EQ(figures["passed"], false);
        for (const char* figure :
             {"relativeL2", "relativeMeanSquare", "maximumAbsolute", "worst", "meanDifference", "energy"})
            EXPECT_TRUE(figures.contains(figure) && figures[figure].is_null()) << figure << run.output;
        EXPECT_TRUE(figures["banding"]["longestRun"].is_null()) << run.output;
        EXPECT_TRUE(figures["deadZone"]["count"].is_null()) << run.output;
    }
}

TEST(Compare, HalfTiledAndSmallerLevelsReadAsTheSamePicture) {
    const std::string plain = writeExr(picture());
    for (const ExrLayout& layout :
         {ExrLayout{.type = OIIO::TypeDesc::HALF}, ExrLayout{.tile = 16}, ExrLayout{.tile = 16, .mipLevels = true}})
        EXPECT_EQ(report(writeExr(picture(), layout), plain, {"--max-absolute", "0"})["maximumAbsolute"], 0.0);
}

TEST(Compare, APngIsDecodedFromSrgbAndItsAlphaLeftAlone) {
    // sRGB 188 is 0.5029 linear (IEC 61966-2-1); half transparent alpha is 128/255 with every colour.
    const std::string png = writeBytes(encodePng(1, 1, {188, 188, 0, 128}), "a.png");
    const double half = std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4);
    const auto figures = report(png, writeExr({1, 1, 4, {0.0f, 0.0f, 0.0f, 0.0f}}));
    EXPECT_NEAR(figures["worst"]["image"], half, 1e-6);
    EXPECT_NEAR(figures["meanDifference"], (2.0 * half + 128.0 / 255.0) / 4.0, 1e-6);
    EXPECT_EQ(figures["image"]["encoding"], "8 bits, decoded from sRGB");
}

TEST(Compare, DifferenceIsImageMinusReference) {
    study::Image image = picture();
    for (std::size_t k = 0; k < image.values.size(); k += 5) image.values[k] = 1.0f / static_cast<float>(k + 3);
    const std::string out = freshPath("difference.exr");
    report(writeExr(image), writeExr(picture()), {"--difference", out});
    const Pixels read = readPixels(out);
    ASSERT_EQ(read.values.size(), image.values.size());
    for (std::size_t k = 0; k < image.values.size(); ++k)
        EXPECT_EQ(read.values[k], image.values[k] - picture().values[k]) << k;
    EXPECT_EQ(neighbours(out), std::vector<std::string>{"difference.exr"});
}

TEST(Compare, DifferenceAsPngIsRedWhereBrighterAndBlueWhereDarker) {
    study::Image image = picture();
    image.values[index(2, 1, 0)] += 0.5f;
    image.values[index(3, 1, 2)] -= 0.25f;
    image.values[index(4, 1, 1)] = std::numeric_limits<float>::quiet_NaN();
    const std::string out = freshPath("difference.png"), a = writeExr(image), b = writeExr(picture());
    const ProgramRun run = runTyndall({"compare", a, b, "--difference", out});
    EXPECT_EQ(run.status, 1) << "for the NaN";
    EXPECT_NE(run.errors.find("darker by 0.5, over white to red, brighter by 0.5"), std::string::npos) << run.errors;
    const auto expectColour = [&](const Pixels& seen, int x, const std::array<int, 3>& rgb) {
        for (int c = 0; c < 3; ++c) EXPECT_EQ(std::lround(255.0f * seen.at(x, 1, c)), rgb[c]) << x << " " << c;
    };
    const Pixels seen = readPixels(out);
    ASSERT_EQ(seen.width, 8);
    expectColour(seen, 1, {255, 255, 255});
    expectColour(seen, 2, {255, 0, 0});
    expectColour(seen, 3, {128, 128, 255});
    expectColour(seen, 4, {255, 0, 255});
    runTyndall({"compare", a, b, "--difference", out, "--difference-scale", "1"});
    expectColour(readPixels(out), 2, {255, 128, 128});
}

struct Refusal {
    const char* name;
    ExrLayout layout;
    const char* says;
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithItsReason) {
    const ProgramRun run = runTyndall({"compare", writeExr(picture(), GetParam().layout), writeExr(picture())});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.errors.find(GetParam().says), std::string::npos) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(run.output, "");
}

INSTANTIATE_TEST_SUITE_P(Layouts, Refused,
                         testing::Values(Refusal{"Parts", {.parts = 2}, "several parts"},
                                         Refusal{"Deep", {.deep = true}, "deep samples"},
                                         Refusal{"Cropped", {.cropped = true}, "data window"},
                                         Refusal{"WholeNumbers", {.type = OIIO::TypeDesc::UINT}, "holds integers"}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Compare, BrokenFilesAreRefusedInOneSentence) {
    const std::string good = writeExr(picture());
    std::ifstream file(good, std::ios::binary);
    const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{5}, std::size_t{60}, bytes.size() / 2, bytes.size() - 20}) {
        const std::string cut = freshPath("cut.exr");
        std::ofstream(cut, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(length));
        const ProgramRun run = runTyndall({"compare", cut, good});
        EXPECT_EQ(run.status, 1) << length;
        EXPECT_TRUE(run.errors.starts_with("tyndall: error: " + cut)) << length << ": " << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << length << ": " << run.errors;
    }
    EXPECT_NE(runTyndall({"compare", good, freshPath("none.exr")}).errors.find("No such file"), std::string::npos);
    EXPECT_NE(runTyndall({"compare", TYNDALL_PROGRAM, good}).errors.find("neither OpenEXR nor PNG"), std::string::npos);
}

TEST(Compare, ChannelsOfOtherNamesAreRefused) {
    const auto refused = [](const std::string& image, const std::string& reference, const char* says) {
        const std::string out = freshPath("difference.exr");
        const ProgramRun run = runTyndall({"compare", image, reference, "--difference", out});
        EXPECT_EQ(run.status, 1);
        EXPECT_EQ(run.output, "");
        EXPECT_NE(run.errors.find(says), std::string::npos) << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_TRUE(neighbours(out).empty());
    };
    const std::string colours = writeExr(picture());
    for (const std::string& named : {writeExr(picture(), {.channels = {"X", "Y", "Z"}}),
                                     writeExr(picture(), {.channels = {"direct.R", "direct.G", "direct.B"}})}) {
        refused(named, colours, "R G B");
        refused(colours, named, "the channels are R G B in the image and ");
    }
    const study::Image single{2, 1, 1, {0.5f, 0.25f}};
    refused(writeExr(single, {.channels = {"Z"}}), writeExr(single, {.channels = {"R"}}),
            "the channels are Z in the image and R in the reference; rename them");
}

TEST(Compare, PathsThatAreNoUtf8StillMakeJson) {
    const std::string path = writeExr(picture(), {}, "p\xffq.exr");
    EXPECT_NE(report(path, path)["image"]["file"].get<std::string>().find("p\xEF\xBF\xBDq.exr"), std::string::npos);
}

TEST(Compare, SizesAndChannelsMustAgree) {
    const std::string good = writeExr(picture());
    const ProgramRun size = runTyndall({"compare", writeExr({2, 2, 3, std::vector<float>(12)}), good});
    EXPECT_EQ(size.status, 1);
    EXPECT_NE(size.errors.find("2x2 pixels and the reference 8x6"), std::string::npos) << size.errors;
    const ProgramRun channels = runTyndall({"compare", writeExr({8, 6, 1, std::vector<float>(48)}), good});
    EXPECT_EQ(channels.status, 1);
    EXPECT_NE(channels.errors.find("1 channels and the reference 3"), std::string::npos) << channels.errors;
}

TEST(Compare, TheDifferenceNeverTakesAnInputsPlace) {
    const std::string a = writeExr(picture()), b = writeExr(picture());
    const std::string link = freshPath("link.exr");
    std::filesystem::create_symlink(b, link);
    for (const std::string& out : {a, b, link}) {
        const ProgramRun run = runTyndall({"compare", a, b, "--difference", out});
        EXPECT_EQ(run.status, 1);
        EXPECT_NE(run.errors.find("itself; name another file"), std::string::npos) << run.errors;
    }
    EXPECT_EQ(readPixels(b).values, picture().values);
}

}  // namespace
}  // namespace tyndall::test
