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

Image filled(int width, int height, glm::vec3 value) {
    Image image = blankImage(width, height, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = value[static_cast<int>(i % 3)];
    return image;
}

TEST(Srgb, TurnsRoundForEveryByte) {
    for (int byte = 0; byte < 256; ++byte)
        EXPECT_EQ(std::lround(255.0f * srgbFromLinear(linearFromSrgb(static_cast<float>(byte) / 255.0f))), byte);
}

TEST(Srgb, IsTheStandardCurve) {  // IEC 61966-2-1
    EXPECT_NEAR(srgbFromLinear(0.5f), 0.735357f, 1e-5);
    EXPECT_NEAR(srgbFromLinear(0.002f), 0.02584f, 1e-6);
}

TEST(ToneMap, KeepsDarkValuesBringsFourToWhiteAndNeverFalls) {
    EXPECT_NEAR(toneMap(0.001, 0.0), 0.001, 2e-6);  // c (1 - c) to first order
    EXPECT_DOUBLE_EQ(toneMap(4.0, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(toneMap(1e30, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(toneMap(-1.0, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(toneMap(0.5, 1.0), toneMap(1.0, 0.0)) << "a stop is a factor of two";
    for (double c = 0.0; c < 5.0; c += 0.01) EXPECT_LE(toneMap(c, 0.0), toneMap(c + 0.01, 0.0));
}

TEST(ToneMap, AutomaticExposureBringsTheLogAverageToTheKey) {
    EXPECT_NEAR(automaticExposure(filled(4, 4, glm::vec3(0.18f))), 0.0, 1e-6);
    EXPECT_NEAR(automaticExposure(filled(4, 4, glm::vec3(0.045f))), 2.0, 1e-6);
    Image half = filled(4, 4, glm::vec3(0.045f));
    for (std::size_t i = 0; i < 3 * 8; ++i) half.values[i] = 0.0f;
    EXPECT_NEAR(automaticExposure(half), 2.0, 1e-6) << "black background does not count";
    EXPECT_EQ(automaticExposure(filled(4, 4, glm::vec3(0.0f))), 0.0);
}

TEST(WritePicture, ExrKeepsEveryBit) {
    Image picture = filled(3, 2, glm::vec3(0.0f));
    const glm::vec3 odd(1e-20f, 12345.678f, 0.1f);
    for (int c = 0; c < 3; ++c) picture.at(1, 0, c) = odd[c];
    const std::string path = freshPath("picture.exr");
    ASSERT_TRUE(writePicture(path, picture, std::nullopt));
    const Pixels read = readPixels(path);
    ASSERT_EQ(read.width, 3);
    ASSERT_EQ(read.height, 2);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(read.at(1, 0, c), odd[c]);
    EXPECT_EQ(neighbours(path), std::vector<std::string>{"picture.exr"}) << "nothing is left beside it";
}

TEST(WritePicture, TheSamePictureIsTheSameBytes) {
    const auto bytes = [](const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    for (const char* name : {"picture.exr", "picture.png"}) {
        const std::string first = freshPath(name), second = freshPath(name);
        ASSERT_TRUE(writePicture(first, filled(3, 2, glm::vec3(0.5f)), std::nullopt));
        std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // dates in headers count seconds
        ASSERT_TRUE(writePicture(second, filled(3, 2, glm::vec3(0.5f)), std::nullopt));
        EXPECT_EQ(bytes(first), bytes(second)) << name;
    }
}

TEST(WritePicture, PngIsToneMapped) {
    const std::string path = freshPath("picture.PNG");
    ASSERT_TRUE(writePicture(path, filled(2, 2, glm::vec3(0.25f)), 1.0));
    const double shown = srgbFromLinear(static_cast<float>(toneMap(0.5, 0.0)));
    EXPECT_NEAR(readPixels(path).at(1, 1, 0), shown, 0.5 / 255.0 + 1e-6) << "half a byte's step";
}

TEST(WritePicture, NotFiniteIsRefusedWithTheFirstPixel) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        Image picture = filled(5, 4, glm::vec3(1.0f));
        picture.at(3, 2, 1) = bad;
        picture.at(1, 3, 2) = bad;
        const std::string path = freshPath("picture.exr");
        const auto written = writePicture(path, picture, std::nullopt);
        ASSERT_FALSE(written);
        EXPECT_NE(written.error().message.find("2 pixels"), std::string::npos) << written.error().message;
        EXPECT_NE(written.error().message.find("(3, 2)"), std::string::npos) << written.error().message;
        EXPECT_TRUE(neighbours(path).empty());
    }
}

TEST(WritePicture, AnOldPictureSurvivesAFailure) {
    const std::string path = freshPath("picture.exr");
    ASSERT_TRUE(writePicture(path, filled(2, 2, glm::vec3(7.0f)), std::nullopt));
    ASSERT_FALSE(writePicture(path, filled(2, 2, glm::vec3(NAN)), std::nullopt));
    EXPECT_EQ(readPixels(path).at(0, 0, 0), 7.0f);
}

}  // namespace
}  // namespace tyndall::test
