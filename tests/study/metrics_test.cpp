// The figures of a comparison: closed forms of tiny pictures, and laws for all pictures.
#include <gtest/gtest.h>
#include <study/metrics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace tyndall::study {
namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

Image row(std::vector<float> values) {
    const int width = static_cast<int>(values.size());
    return {width, 1, 1, std::move(values)};
}

Metrics measured(const Image& image, const Image& reference) {
    const auto metrics = compare(image, reference);
    EXPECT_TRUE(metrics) << (metrics ? "" : metrics.error().message);
    return metrics ? *metrics : Metrics{};
}

/// Values over many orders of magnitude, a tenth of them 0.
Image random(int width, int height, int channels, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> exponent(-20.0f, 10.0f), chance(0.0f, 1.0f);
    Image image{width, height, channels, {}};
    for (int k = 0; k < width * height * channels; ++k)
        image.values.push_back(chance(generator) < 0.1f ? 0.0f : std::exp2(exponent(generator)));
    return image;
}

TEST(Metrics, ClosedFormOfTwoPixels) {
    const Metrics m = measured(row({1.0f, 2.0f}), row({1.0f, 3.0f}));
    EXPECT_DOUBLE_EQ(m.relativeL2, std::sqrt(1.0 / 10.0));
    EXPECT_DOUBLE_EQ(m.relativeMeanSquare, 0.5 / (9.0 + 1e-4 * 5.0)) << "mean square of the reference is 5";
    EXPECT_EQ(m.maximumAbsolute, 1.0);
    EXPECT_EQ(m.worst.place.x, 1);
    EXPECT_EQ(m.worst.image, 2.0);
    EXPECT_EQ(m.worst.reference, 3.0);
    EXPECT_EQ(m.meanDifference, -0.5);
    EXPECT_EQ(m.energy, -0.25);
    EXPECT_EQ(m.compared, 2u);
}

TEST(Metrics, APictureIsItself) {
    const Image picture = random(17, 9, 3, 1);
    const Metrics m = measured(picture, picture);
    EXPECT_EQ(m.relativeL2, 0.0);
    EXPECT_EQ(m.relativeMeanSquare, 0.0);
    EXPECT_EQ(m.maximumAbsolute, 0.0);
    EXPECT_EQ(m.meanDifference, 0.0);
    EXPECT_EQ(m.energy, 0.0);
    EXPECT_EQ(m.banding.longestRun, 0);
    EXPECT_EQ(m.deadZone.count, 0u);
    EXPECT_TRUE(m.finite());
    EXPECT_EQ(m.compared, 17u * 9u * 3u);
}

TEST(Metrics, TheWorstValueIsNamedWithItsChannel) {
    Image reference = random(7, 5, 3, 2), image = reference;
    image.values[(3 * 7 + 4) * 3 + 2] += 5000.0f;
    const Metrics m = measured(image, reference);
    EXPECT_EQ(m.worst.place.x, 4);
    EXPECT_EQ(m.worst.place.y, 3);
    EXPECT_EQ(m.worst.place.channel, 2);
    image.values[(3 * 7 + 5) * 3] = reference.values[(3 * 7 + 5) * 3] - 6000.0f;
    EXPECT_EQ(measured(image, reference).worst.place.x, 5) << "too dark counts as much as too bright";
    EXPECT_EQ(measured(row({1.0f, 3.0f, 1.0f, 3.0f}), row({1.0f, 2.0f, 2.0f, 2.0f})).worst.place.x, 1) << "the first";
}

TEST(Metrics, ScalingBothByAPowerOfTwoScalesOnlyWhatHasAUnit) {
    const Image image = random(16, 8, 3, 3), reference = random(16, 8, 3, 4);
    Image smallImage = image, smallReference = reference;
    const float scale = std::exp2(-12.0f);
    for (float& value : smallImage.values) value *= scale;
    for (float& value : smallReference.values) value *= scale;
    const Metrics m = measured(image, reference), s = measured(smallImage, smallReference);
    EXPECT_EQ(s.relativeL2, m.relativeL2);
    EXPECT_EQ(s.relativeMeanSquare, m.relativeMeanSquare);
    EXPECT_EQ(s.energy, m.energy);
    EXPECT_EQ(s.deadZone.share, m.deadZone.share);
    EXPECT_EQ(s.maximumAbsolute, m.maximumAbsolute * scale);
    EXPECT_EQ(s.meanDifference, m.meanDifference * scale);
    EXPECT_EQ(s.deadZone.largest.reference, m.deadZone.largest.reference * scale);
}

TEST(Metrics, BrighterByAShareIsThatShare) {
    const Image reference = random(16, 8, 3, 5);
    Image image = reference;
    for (float& value : image.values) value *= 1.25f;
    const Metrics m = measured(image, reference);
    // 1.25 r is rounded to 24 bits, so each term is within 2^-24 * 1.25 / 0.25 = 3e-7 of its share.
    EXPECT_NEAR(m.relativeL2, 0.25, 1e-7);
    EXPECT_NEAR(m.energy, 0.25, 1e-7);
    EXPECT_LT(m.relativeMeanSquare, 0.0625) << "values below the floor count less, none counts more";
    EXPECT_GT(m.relativeMeanSquare, 0.0);
}

TEST(Metrics, ExchangingThePicturesTurnsTheSignAndKeepsTheMaximum) {
    const Image a = random(16, 8, 3, 6), b = random(16, 8, 3, 7);
    const Metrics ab = measured(a, b), ba = measured(b, a);
    EXPECT_EQ(ab.meanDifference, -ba.meanDifference);
    EXPECT_EQ(ab.maximumAbsolute, ba.maximumAbsolute);
    EXPECT_EQ(ab.worst.place.x, ba.worst.place.x);
    EXPECT_EQ(ab.worst.image, ba.worst.reference);
}

TEST(Metrics, DoNotDependOnTheOrderOfThePixels) {
    Image image = random(32, 32, 1, 8), reference = random(32, 32, 1, 9);
    const Metrics before = measured(image, reference);
    std::vector<std::size_t> order(image.values.size());
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937 generator(10);
    for (int shuffle = 0; shuffle < 8; ++shuffle) {
        std::ranges::shuffle(order, generator);
        Image shuffledImage = image, shuffledReference = reference;
        for (std::size_t k = 0; k < order.size(); ++k) {
            shuffledImage.values[k] = image.values[order[k]];
            shuffledReference.values[k] = reference.values[order[k]];
        }
        const Metrics after = measured(shuffledImage, shuffledReference);
        EXPECT_EQ(after.relativeL2, before.relativeL2);
        EXPECT_EQ(after.relativeMeanSquare, before.relativeMeanSquare);
        EXPECT_EQ(after.meanDifference, before.meanDifference);
        EXPECT_EQ(after.energy, before.energy);
    }
}

TEST(Metrics, SmallTermsSurviveLargeOnesThatCancel) {
    // In doubles added one after the other 1 is lost beside 1e30.
    const Metrics m = measured(row({1e30f, 1.0f, 0.0f, 0.0f}), row({0.0f, 0.0f, 1e30f, 0.0f}));
    EXPECT_EQ(m.meanDifference, 0.25);
}

TEST(Metrics, AShiftByOnePixelIsTheSlope) {
    Image reference{64, 4, 1, {}}, image = reference;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 64; ++x) {
            reference.values.push_back(static_cast<float>(x + 1) / 64.0f);
            image.values.push_back(static_cast<float>(x + 2) / 64.0f);
        }
    const Metrics m = measured(image, reference);
    EXPECT_EQ(m.maximumAbsolute, 1.0 / 64.0);
    EXPECT_EQ(m.meanDifference, 1.0 / 64.0);
    EXPECT_DOUBLE_EQ(m.energy, 2.0 / 65.0) << "the mean of 1 to 64 is 65 / 2";
    EXPECT_DOUBLE_EQ(m.relativeL2, std::sqrt(64.0 / (64.0 * 65.0 * 129.0 / 6.0))) << "sum of squares";
    EXPECT_EQ(m.banding.longestRun, 0);
}

TEST(Metrics, ABlackReference) {
    const Metrics same = measured(row({0.0f, 0.0f}), row({0.0f, -0.0f}));
    EXPECT_EQ(same.relativeL2, 0.0);
    EXPECT_EQ(same.relativeMeanSquare, 0.0);
    EXPECT_EQ(same.energy, 0.0);
    EXPECT_EQ(same.deadZone.count, 0u) << "nothing was there to be lost";
    const Metrics darker = measured(row({0.0f, -1.0f}), row({0.0f, 0.0f}));
    EXPECT_EQ(darker.relativeL2, infinite);
    EXPECT_EQ(darker.relativeMeanSquare, infinite);
    EXPECT_EQ(darker.energy, -infinite);
    EXPECT_EQ(darker.meanDifference, -0.5);
}

TEST(Metrics, WhatIsNoNumberIsCountedApartAndLeftOut) {
    const Metrics m = measured(row({notANumber, 2.0f, 3.0f, infinite, 5.0f}), row({1.0f, 2.0f, -infinite, 4.0f, 4.0f}));
    EXPECT_EQ(m.image.nan, 1u);
    EXPECT_EQ(m.image.infinite, 1u);
    EXPECT_EQ(m.image.first->x, 0);
    EXPECT_EQ(m.reference.nan, 0u);
    EXPECT_EQ(m.reference.infinite, 1u);
    EXPECT_EQ(m.reference.first->x, 2);
    EXPECT_FALSE(m.finite());
    EXPECT_EQ(m.compared, 2u);
    EXPECT_EQ(m.maximumAbsolute, 1.0);
    EXPECT_EQ(m.worst.place.x, 4);
    EXPECT_EQ(m.meanDifference, 0.5);
    const Metrics nothing = measured(row({notANumber}), row({1.0f}));
    EXPECT_EQ(nothing.compared, 0u);
    EXPECT_EQ(nothing.relativeL2, 0.0);
    EXPECT_FALSE(nothing.finite());
    EXPECT_TRUE(std::isnan(notANumber) && !measured(row({1.0f}), row({notANumber})).finite());
}

TEST(Metrics, OneBadPixelIsFoundAmongMany) {
    const Image reference = random(640, 360, 3, 11);
    for (const std::size_t at : {std::size_t{0}, std::size_t{345678}, reference.values.size() - 1}) {
        Image image = reference;
        image.values[at] = notANumber;
        const Metrics m = measured(image, reference);
        EXPECT_EQ(m.image.count(), 1u);
        EXPECT_EQ((m.image.first->y * 640 + m.image.first->x) * 3 + m.image.first->channel, static_cast<int>(at));
    }
}

TEST(Metrics, DifferentPicturesAreRefused) {
    const Image wide{3, 2, 1, std::vector<float>(6)}, tall{2, 3, 1, std::vector<float>(6)};
    const Image grey{2, 2, 1, std::vector<float>(4)}, colour{2, 2, 3, std::vector<float>(12)};
    const Image short_{2, 2, 1, std::vector<float>(3)}, empty{0, 2, 1, {}};
    EXPECT_NE(compare(wide, tall).error().message.find("3x2 pixels and the reference 2x3"), std::string::npos);
    EXPECT_NE(compare(grey, colour).error().message.find("1 channels and the reference 3"), std::string::npos);
    EXPECT_NE(compare(grey, short_).error().message.find("the reference holds 3 values"), std::string::npos);
    EXPECT_NE(compare(empty, grey).error().message.find("the image has no pixels"), std::string::npos);
}

TEST(DeadZone, IsTheBrightestReferenceThatBecameNothing) {
    const Metrics m = measured(row({0.0f, 0.0f, 0.0f, 0.5f, -0.0f}), row({0.0f, 0.125f, 0.25f, 0.5f, 0.0625f}));
    EXPECT_EQ(m.deadZone.count, 3u);
    EXPECT_EQ(m.deadZone.share, 0.6);
    EXPECT_EQ(m.deadZone.largest.reference, 0.25);
    EXPECT_EQ(m.deadZone.largest.place.x, 2);
}

}  // namespace
}  // namespace tyndall::study
