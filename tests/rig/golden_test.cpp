// Only the explicit switch makes a golden, and a run that makes one fails.
#include <gtest/gtest.h>
#include <rig/golden.h>

#include <limits>

#include "folder.h"

namespace tyndall::rig {
namespace {

using test::Folder;

Image picture(float value) {
    Image image = blankImage(4, 3, 4);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = value * static_cast<float>(i + 1);
    return image;
}

struct GoldenTest : testing::Test {
    Folder folder;
    GoldenStore store{folder.at("goldens"), false, "say --update-goldens"};
    GoldenStore updating{folder.at("goldens"), true, "say --update-goldens"};
};

TEST_F(GoldenTest, AMissingOneFailsAndSaysHowToMakeIt) {
    const GoldenVerdict verdict = checkGolden(store, "first", picture(1.0f), Tolerance::Float);
    EXPECT_FALSE(verdict.passed());
    EXPECT_NE(verdict.reason.find("first.exr"), std::string::npos) << verdict.reason;
    EXPECT_NE(verdict.reason.find("say --update-goldens"), std::string::npos) << verdict.reason;
    EXPECT_EQ(test::listing(folder.path()), "");
}

TEST_F(GoldenTest, TheRunThatMakesOneFailsAndTheNextPasses) {
    EXPECT_FALSE(checkGolden(updating, "first", picture(1.0f), Tolerance::Float).passed());
    EXPECT_EQ(test::listing(folder.path()), "goldens/first.exr\n");
    EXPECT_EQ(checkGolden(store, "first", picture(1.0f), Tolerance::Exact).reason, "");
    EXPECT_EQ(checkGolden(updating, "first", picture(1.0f), Tolerance::Exact).reason, "");
}

TEST_F(GoldenTest, AnotherPictureFailsWithTheGoldenAtHandAndLeavesItAlone) {
    checkGolden(updating, "first", picture(1.0f), Tolerance::Float);
    const GoldenVerdict verdict = checkGolden(store, "first", picture(1.001f), Tolerance::Float);
    EXPECT_FALSE(verdict.passed());
    ASSERT_TRUE(verdict.expected.has_value());
    EXPECT_EQ(verdict.expected->values, picture(1.0f).values);
    EXPECT_TRUE(checkGolden(store, "first", picture(1.0f), Tolerance::Exact).passed());
}

TEST_F(GoldenTest, ReplacingOneFailsTooAndTellsByHowMuchItWasOff) {
    checkGolden(updating, "first", picture(1.0f), Tolerance::Float);
    const GoldenVerdict verdict = checkGolden(updating, "first", picture(2.0f), Tolerance::Float);
    EXPECT_NE(verdict.reason.find("replaced"), std::string::npos) << verdict.reason;
    EXPECT_NE(verdict.reason.find("instead of"), std::string::npos) << verdict.reason;
    EXPECT_TRUE(checkGolden(store, "first", picture(2.0f), Tolerance::Exact).passed());
}

TEST_F(GoldenTest, WhatIsNotFiniteIsNeverMadeAGolden) {
    Image bad = picture(1.0f);
    bad.values[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(checkGolden(updating, "first", bad, Tolerance::Float).passed());
    EXPECT_EQ(test::listing(folder.path()), "");
    checkGolden(updating, "first", picture(1.0f), Tolerance::Float);
    EXPECT_FALSE(checkGolden(updating, "first", bad, Tolerance::Float).passed());
    EXPECT_TRUE(checkGolden(store, "first", picture(1.0f), Tolerance::Exact).passed());
}

TEST_F(GoldenTest, ABrokenFileIsAFailureNotACrash) {
    test::writeText(folder.at("goldens/first.exr"), "no image");
    const GoldenVerdict verdict = checkGolden(store, "first", picture(1.0f), Tolerance::Float);
    EXPECT_NE(verdict.reason.find("first.exr: cannot be read"), std::string::npos) << verdict.reason;
    EXPECT_FALSE(checkGolden(updating, "first", picture(1.0f), Tolerance::Float).passed());
    EXPECT_TRUE(checkGolden(store, "first", picture(1.0f), Tolerance::Exact).passed());
}

TEST_F(GoldenTest, APlaceThatCannotBeWrittenIsNamed) {
    test::writeText(folder.at("goldens"), "a file where the folder should be");
    const GoldenVerdict verdict = checkGolden(updating, "first", picture(1.0f), Tolerance::Float);
    EXPECT_NE(verdict.reason.find("cannot be written"), std::string::npos) << verdict.reason;
}

}  // namespace
}  // namespace tyndall::rig
