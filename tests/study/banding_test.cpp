// The longest run of equal values on a gradient, tested with steps of a known length.
#include <gtest/gtest.h>
#include <study/metrics.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <limits>

namespace tyndall::study {
namespace {

constexpr double threshold = MetricOptions{}.bandingThreshold;

/// 256 pixels that rise by 1/256 each, above 1: a step changes by at least 1/512 of the value.
Image ramp() {
    Image image{256, 1, 1, {}};
    for (int x = 0; x < 256; ++x) image.values.push_back(1.0f + static_cast<float>(x) / 256.0f);
    return image;
}

Image inStepsOf(int pixels, Image image) {
    const float step = static_cast<float>(pixels) / 256.0f;
    for (float& value : image.values) value = std::floor(value / step) * step;
    return image;
}

Image transposed(const Image& image) {
    Image turned{image.height, image.width, image.channels, std::vector<float>(image.values.size())};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < image.channels; ++c)
                turned.values[(x * image.height + y) * image.channels + c] =
                    image.values[(y * image.width + x) * image.channels + c];
    return turned;
}

class Steps : public testing::TestWithParam<int> {};

TEST_P(Steps, AreAsLongAsTheyWereMade) {
    const int pixels = GetParam();
    const Banding found = findBanding(inStepsOf(pixels, ramp()), ramp(), threshold, 0.0);
    EXPECT_EQ(found.longestRun, pixels);
    EXPECT_TRUE(found.alongRow);
    EXPECT_EQ(found.start.x, 0);
    EXPECT_EQ(found.change, (pixels - 1) / 256.0);
    EXPECT_DOUBLE_EQ(found.relativeChange, (pixels - 1) / (256.0 + pixels - 1)) << "of the larger end";
}

TEST_P(Steps, AreFoundDownAColumnAndBackwards) {
    const int pixels = GetParam();
    const Banding down = findBanding(transposed(inStepsOf(pixels, ramp())), transposed(ramp()), threshold, 0.0);
    EXPECT_EQ(down.longestRun, pixels);
    EXPECT_FALSE(down.alongRow);
    Image image = inStepsOf(pixels, ramp()), reference = ramp();
    std::ranges::reverse(image.values);
    std::ranges::reverse(reference.values);
    EXPECT_EQ(findBanding(image, reference, threshold, 0.0).longestRun, pixels) << "a falling gradient is one too";
}

INSTANTIATE_TEST_SUITE_P(OfPixels, Steps, testing::Values(2, 4, 8, 32, 128));

TEST(Banding, AFlatReferenceHasNone) {
    const Image flat{16, 16, 1, std::vector<float>(256, 0.5f)};
    EXPECT_EQ(findBanding(flat, flat, threshold, 0.0).longestRun, 0);
}

TEST(Banding, AnEqualImageHasNone) {
    EXPECT_EQ(findBanding(ramp(), ramp(), threshold, 0.0).longestRun, 0);
}

TEST(Banding, ATurnOfTheReferenceEndsARun) {
    const Image image{7, 1, 1, std::vector<float>(7, 1.0f)};
    const Image roof{7, 1, 1, {1.0f, 2.0f, 3.0f, 4.0f, 3.0f, 2.0f, 1.5f}};
    const Banding found = findBanding(image, roof, threshold, 0.0);
    EXPECT_EQ(found.longestRun, 4) << "up to the top, and from it down again";
    EXPECT_EQ(found.start.x, 0);
    const Image ledge{7, 1, 1, {1.0f, 2.0f, 3.0f, 3.0f, 4.0f, 5.0f, 6.0f}};
    EXPECT_EQ(findBanding(image, ledge, threshold, 0.0).longestRun, 4) << "flat between the third and the fourth";
    EXPECT_EQ(findBanding(image, ledge, threshold, 0.0).start.x, 3);
}

TEST(Banding, LooksAtEachChannelOfEachLine) {
    Image image{8, 3, 2, {}}, reference = image;
    for (int k = 0; k < 48; ++k) image.values.push_back(static_cast<float>(k + 1));
    reference.values = image.values;
    for (int x = 3; x < 8; ++x) image.values[(2 * 8 + x) * 2 + 1] = 7.0f;
    const Banding found = findBanding(image, reference, threshold, 0.0);
    EXPECT_EQ(found.longestRun, 5);
    EXPECT_EQ(found.start.x, 3);
    EXPECT_EQ(found.start.y, 2);
    EXPECT_EQ(found.start.channel, 1);
}

TEST(Banding, RoundingToHalfFloatsIsNone) {
    // 2048 pixels from 1 to 2: half floats step by 2^-10 there, so pairs of pixels become equal, and the
    // reference moves by 2^-11 over a pair.
    Image reference{2048, 1, 1, {}};
    for (int x = 0; x < 2048; ++x) reference.values.push_back(1.0f + static_cast<float>(x) / 2048.0f);
    Image image = reference;
    for (float& value : image.values) value = glm::unpackHalf1x16(glm::packHalf1x16(value));
    ASSERT_NE(image.values, reference.values);
    EXPECT_EQ(findBanding(image, reference, threshold, 0.0).longestRun, 0);
    EXPECT_GT(findBanding(image, reference, 0.0, 0.0).longestRun, 1);
}

TEST(Banding, TheThresholdIsOnTheRunNotOnItsSteps) {
    // Each step is 1e-4 of the value, far below the threshold; fifty of them are above it.
    Image reference{51, 1, 1, {}};
    for (int x = 0; x < 51; ++x) reference.values.push_back(1.0f + 1e-4f * static_cast<float>(x));
    const Image image{51, 1, 1, std::vector<float>(51, 1.0f)};
    EXPECT_EQ(findBanding(image, reference, threshold, 0.0).longestRun, 51);
    EXPECT_EQ(findBanding(image, reference, 0.01, 0.0).longestRun, 0);
}

TEST(Banding, TheThresholdIsRelative) {
    // The reference moves by 0.5 at 1000, half of the threshold's share of it.
    const Image flat{3, 1, 1, std::vector<float>(3, 1000.0f)}, rising{3, 1, 1, {1000.0f, 1000.25f, 1000.5f}};
    EXPECT_EQ(findBanding(flat, rising, threshold, 0.0).longestRun, 0);
    EXPECT_EQ(findBanding(flat, rising, 0.0004, 0.0).longestRun, 3);
}

TEST(Banding, StepsInTheDarkAreNone) {
    const Image black{3, 1, 1, std::vector<float>(3, 0.0f)}, rising{3, 1, 1, {1e-9f, 2e-9f, 3e-9f}};
    EXPECT_EQ(findBanding(black, rising, threshold, 0.0).longestRun, 3);
    EXPECT_EQ(findBanding(black, rising, threshold, 1e-6).longestRun, 3) << "2e-9 is more than a thousandth of it";
    EXPECT_EQ(findBanding(black, rising, threshold, 3e-6).longestRun, 0);
    Image image{4, 1, 1, {0.0f, 0.0f, 0.0f, 1.0f}}, reference{4, 1, 1, {1e-6f, 2e-6f, 3e-6f, 1.0f}};
    EXPECT_EQ(compare(image, reference)->banding.longestRun, 0) << "1e-6 of the brightest is dark";
}

TEST(Banding, TheLongestOfTwoIsNamedInARowAndInAColumn) {
    Image reference{9, 7, 1, {}};
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x) reference.values.push_back(1.0f + static_cast<float>(x + 10 * y));
    Image image = reference;
    for (int y = 3; y < 7; ++y) image.values[static_cast<std::size_t>(y * 9 + 5)] = 1.0f;
    const Banding column = findBanding(image, reference, threshold, 0.0);
    EXPECT_EQ(column.longestRun, 4);
    EXPECT_FALSE(column.alongRow);
    EXPECT_EQ(column.start.x, 5);
    EXPECT_EQ(column.start.y, 3);
    for (int x = 1; x < 7; ++x) image.values[static_cast<std::size_t>(2 * 9 + x)] = 1.0f;
    const Banding row = findBanding(image, reference, threshold, 0.0);
    EXPECT_EQ(row.longestRun, 6);
    EXPECT_TRUE(row.alongRow);
    EXPECT_EQ(row.start.x, 1);
    EXPECT_EQ(row.start.y, 2);
}

TEST(Banding, WhatIsNoNumberEndsARun) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const Image reference{5, 1, 1, {1.0f, 2.0f, 3.0f, 4.0f, 5.0f}};
    EXPECT_EQ(findBanding({5, 1, 1, std::vector<float>(5, infinite)}, reference, threshold, 0.0).longestRun, 0);
    const Image flat{5, 1, 1, std::vector<float>(5, 1.0f)};
    EXPECT_EQ(findBanding(flat, {5, 1, 1, {1.0f, 2.0f, 3.0f, infinite, infinite}}, threshold, 0.0).longestRun, 3);
    EXPECT_EQ(findBanding(flat, {5, 1, 1, {1.0f, 2.0f, NAN, 4.0f, 5.0f}}, threshold, 0.0).longestRun, 2);
}

}  // namespace
}  // namespace tyndall::study
