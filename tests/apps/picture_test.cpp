// From radiance to files.
#include <gtest/gtest.h>
#include <kit/image/srgb.h>
#include <kit/image/tone_map.h>
#include <kit/image/write_picture.h>

#include <chrono>
#include <fstream>
#include <limits>
#include <thread>

#include "glb.h"
#include "program.h"

namespace tyndall::test {
namespace {

tyndall::Picture filled(std::uint32_t width, std::uint32_t height, glm::vec3 value) {
    return {width, height, std::vector<glm::vec3>(std::size_t{width} * height, value)};
}

TEST(Srgb, TurnsRoundForEveryByte) {
    for (int byte = 0; byte < 256; ++byte)
        EXPECT_EQ(std::lround(255.0f * tyndall::srgbFromLinear(tyndall::linearFromSrgb(static_cast<float>(byte) / 255.0f))),
                  byte);
}

TEST(Srgb, IsTheStandardCurve) {  // IEC 61966-2-1
    EXPECT_NEAR(tyndall::srgbFromLinear(0.5f), 0.735357f, 1e-5);
    EXPECT_NEAR(tyndall::srgbFromLinear(0.002f), 0.02584f, 1e-6);
}

TEST(ToneMap, KeepsDarkValuesBringsFourToWhiteAndNeverFalls) {
    EXPECT_NEAR(tyndall::toneMap(0.001, 0.0), 0.001, 2e-6);  // c (1 - c) to first order
    EXPECT_DOUBLE_EQ(tyndall::toneMap(4.0, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(tyndall::toneMap(1e30, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(tyndall::toneMap(-1.0, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(tyndall::toneMap(0.5, 1.0), tyndall::toneMap(1.0, 0.0)) << "a stop is a factor of two";
    for (double c = 0.0; c < 5.0; c += 0.01) EXPECT_LE(tyndall::toneMap(c, 0.0), tyndall::toneMap(c + 0.01, 0.0));
}

TEST(ToneMap, AutomaticExposureBringsTheLogAverageToTheKey) {
    EXPECT_NEAR(tyndall::automaticExposure(filled(4, 4, glm::vec3(0.18f))), 0.0, 1e-6);
    EXPECT_NEAR(tyndall::automaticExposure(filled(4, 4, glm::vec3(0.045f))), 2.0, 1e-6);
    tyndall::Picture half = filled(4, 4, glm::vec3(0.045f));
    for (std::size_t i = 0; i < 8; ++i) half.pixels[i] = glm::vec3(0.0f);
    EXPECT_NEAR(tyndall::automaticExposure(half), 2.0, 1e-6) << "black background does not count";
    EXPECT_EQ(tyndall::automaticExposure(filled(4, 4, glm::vec3(0.0f))), 0.0);
}

TEST(WritePicture, ExrKeepsEveryBit) {
    tyndall::Picture picture = filled(3, 2, glm::vec3(0.0f));
    picture.pixels[1] = glm::vec3(1e-20f, 12345.678f, 0.1f);
    const std::string path = freshPath("picture.exr");
    ASSERT_TRUE(tyndall::writePicture(path, picture, std::nullopt));
    const Pixels read = readPixels(path);
    ASSERT_EQ(read.width, 3);
    ASSERT_EQ(read.height, 2);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(read.at(1, 0, c), picture.pixels[1][c]);
    EXPECT_EQ(neighbours(path), std::vector<std::string>{"picture.exr"}) << "nothing is left beside it";
}

TEST(WritePicture, TheSamePictureIsTheSameBytes) {
    const auto bytes = [](const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    for (const char* name : {"picture.exr", "picture.png"}) {
        const std::string first = freshPath(name), second = freshPath(name);
        ASSERT_TRUE(tyndall::writePicture(first, filled(3, 2, glm::vec3(0.5f)), std::nullopt));
        std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // dates in headers count seconds
        ASSERT_TRUE(tyndall::writePicture(second, filled(3, 2, glm::vec3(0.5f)), std::nullopt));
        EXPECT_EQ(bytes(first), bytes(second)) << name;
    }
}

TEST(WritePicture, PngIsToneMapped) {
    const std::string path = freshPath("picture.PNG");
    ASSERT_TRUE(tyndall::writePicture(path, filled(2, 2, glm::vec3(0.25f)), 1.0));
    const double shown = tyndall::srgbFromLinear(static_cast<float>(tyndall::toneMap(0.5, 0.0)));
    EXPECT_NEAR(readPixels(path).at(1, 1, 0), shown, 0.5 / 255.0 + 1e-6) << "half a byte's step";
}

TEST(WritePicture, NotFiniteIsRefusedWithTheFirstPixel) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        tyndall::Picture picture = filled(5, 4, glm::vec3(1.0f));
        picture.pixels[5 * 2 + 3].y = bad;
        picture.pixels[5 * 3 + 1].z = bad;
        const std::string path = freshPath("picture.exr");
        const auto written = tyndall::writePicture(path, picture, std::nullopt);
        ASSERT_FALSE(written);
        EXPECT_NE(written.error().message.find("2 pixels"), std::string::npos) << written.error().message;
        EXPECT_NE(written.error().message.find("(3, 2)"), std::string::npos) << written.error().message;
        EXPECT_TRUE(neighbours(path).empty());
    }
}

TEST(WritePicture, AnOldPictureSurvivesAFailure) {
    const std::string path = freshPath("picture.exr");
    ASSERT_TRUE(tyndall::writePicture(path, filled(2, 2, glm::vec3(7.0f)), std::nullopt));
    ASSERT_FALSE(tyndall::writePicture(path, filled(2, 2, glm::vec3(NAN)), std::nullopt));
    EXPECT_EQ(readPixels(path).at(0, 0, 0), 7.0f);
}

}  // namespace
}  // namespace tyndall::test
