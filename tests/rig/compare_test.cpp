// The tolerances of golden images: the largest allowed difference passes, the next step fails.
#include <gtest/gtest.h>
#include <rig/compare.h>

#include <cmath>
#include <limits>

namespace tyndall::rig {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// One row of grey pixels.
Image row(std::vector<float> values) {
    const int width = static_cast<int>(values.size());
    return {width, 1, 1, std::move(values)};
}

bool same(const Image& image, const Image& expected, Tolerance tolerance) {
    return whyDifferent(image, expected, tolerance).empty();
}

TEST(Compare, NanAndInfinityAreCountedApartWithTheFirstPlace) {
    Image image = blankImage(3, 2, 2);
    image.at(1, 1, 1) = nan;
    image.at(2, 1, 0) = -infinity;
    image.at(2, 1, 1) = nan;
    const study::NonFinite found = study::countNonFinite(image);
    EXPECT_EQ(found.nan, 2u);
    EXPECT_EQ(found.infinite, 1u);
    EXPECT_EQ(found.first->x, 1);
    EXPECT_EQ(found.first->y, 1);
    EXPECT_EQ(found.first->channel, 1);
    EXPECT_EQ(whyNotFinite(image), "2 values are NaN and 1 are infinite, the first at (1, 1), channel 1");
}

TEST(Compare, NotFiniteNeverPassesNotEvenAgainstItself) {
    for (const Tolerance tolerance : {Tolerance::Exact, Tolerance::Float, Tolerance::Half, Tolerance::Byte})
        for (const float bad : {nan, infinity, -infinity}) {
            EXPECT_FALSE(same(row({1.0f, bad}), row({1.0f, bad}), tolerance));
            EXPECT_FALSE(same(row({1.0f, bad}), row({1.0f, 1.0f}), tolerance));
            EXPECT_NE(whyDifferent(row({1.0f, 1.0f}), row({1.0f, bad}), tolerance).find("expected image itself"),
                      std::string::npos);
        }
}

TEST(Compare, OtherShapesNeverPass) {
    EXPECT_FALSE(same(row({1.0f, 1.0f}), row({1.0f}), Tolerance::Byte));
    EXPECT_FALSE(same(blankImage(2, 1, 1), blankImage(1, 2, 1), Tolerance::Exact));
    EXPECT_FALSE(same(blankImage(2, 1, 1), blankImage(2, 1, 2), Tolerance::Exact));
}

TEST(Compare, ExactMeansEveryBit) {
    EXPECT_TRUE(same(row({0.1f, -2.0f}), row({0.1f, -2.0f}), Tolerance::Exact));
    EXPECT_FALSE(same(row({0.1f}), row({std::nextafter(0.1f, 1.0f)}), Tolerance::Exact));
    EXPECT_FALSE(same(row({0.0f}), row({-0.0f}), Tolerance::Exact));
}

TEST(Compare, FloatIsRelativeToTheLargestOfTheSameChannel) {
    // 2e-5 of 100 is 0.002, for all values of the channel.
    EXPECT_TRUE(same(row({100.0f, 1.0019f}), row({100.0f, 1.0f}), Tolerance::Float));
    EXPECT_FALSE(same(row({100.0f, 1.0021f}), row({100.0f, 1.0f}), Tolerance::Float));
    EXPECT_FALSE(same(row({100.0f, 0.9979f}), row({100.0f, 1.0f}), Tolerance::Float));
    // One channel's largest value does not count for another channel.
    Image bright = blankImage(1, 1, 2), off = bright;
    bright.values = {100.0f, 1.0f};
    off.values = {100.0f, 1.0001f};
    EXPECT_FALSE(same(off, bright, Tolerance::Float));
    // Over a black channel nothing is allowed.
    EXPECT_FALSE(same(row({1e-30f}), row({0.0f}), Tolerance::Float));
    EXPECT_TRUE(same(row({0.0f}), row({-0.0f}), Tolerance::Float));
}

TEST(Compare, HalfAllowsOneUnitInTheLastPlace) {
    const float ulp = 0x1p-10f;  // of values from 1 to 2
    EXPECT_TRUE(same(row({1.0f + ulp}), row({1.0f}), Tolerance::Half));
    EXPECT_FALSE(same(row({1.0f + 2 * ulp}), row({1.0f}), Tolerance::Half));
    // Below 1 the unit is half as large.
    EXPECT_TRUE(same(row({1.0f - ulp / 2}), row({1.0f}), Tolerance::Half));
    EXPECT_FALSE(same(row({1.0f - ulp}), row({1.0f}), Tolerance::Half));
    // The smallest denormal and both zeros.
    EXPECT_TRUE(same(row({0x1p-24f}), row({0.0f}), Tolerance::Half));
    EXPECT_TRUE(same(row({-0.0f}), row({0.0f}), Tolerance::Half));
    EXPECT_FALSE(same(row({0x1p-24f}), row({-0x1p-24f}), Tolerance::Half));
}

TEST(Compare, ByteAllowsThreeStepsAndMoreThanOneInAThousandthOfThePixels) {
    Image expected = blankImage(100, 20, 1);  // 2000 pixels: two of them are 0.1 %
    for (float& value : expected.values) value = 100.0f / 255.0f;
    Image image = expected;
    for (float& value : image.values) value = 101.0f / 255.0f;
    EXPECT_TRUE(same(image, expected, Tolerance::Byte));
    image.values[7] = 103.0f / 255.0f;
    image.values[1900] = 97.0f / 255.0f;
    EXPECT_TRUE(same(image, expected, Tolerance::Byte));
    image.values[8] = 102.0f / 255.0f;
    EXPECT_FALSE(same(image, expected, Tolerance::Byte));
    image.values[8] = 101.0f / 255.0f;
    image.values[7] = 104.0f / 255.0f;
    EXPECT_FALSE(same(image, expected, Tolerance::Byte));
}

TEST(Compare, ByteCountsPixelsNotChannels) {
    Image expected = blankImage(1000, 1, 4), image = expected;
    for (int c = 0; c < 4; ++c) image.at(500, 0, c) = 2.0f / 255.0f;
    EXPECT_TRUE(same(image, expected, Tolerance::Byte));
    image.at(501, 0, 0) = 2.0f / 255.0f;
    EXPECT_FALSE(same(image, expected, Tolerance::Byte));
}

TEST(Compare, FiguresOfADifference) {
    Image expected = blankImage(2, 2, 1), image = expected;
    expected.values = {3.0f, 4.0f, 0.0f, nan};
    image.values = {3.0f, 4.5f, 0.0f, 2.0f};
    const Difference apart = difference(image, expected);
    EXPECT_DOUBLE_EQ(apart.largest, 0.5);
    EXPECT_EQ(apart.at.x, 1);
    EXPECT_EQ(apart.at.y, 0);
    EXPECT_DOUBLE_EQ(apart.relativeL2, 0.1);  // 0.5 / sqrt(9 + 16)
    EXPECT_EQ(apart.differing, 2u);           // NaN counts here, but not in the figures
    EXPECT_EQ(difference(expected, expected).relativeL2, 0.0);
}

TEST(Compare, ReasonsNameThePlaceAndTheFigures) {
    const std::string reason = whyDifferent(row({1.0f, 2.5f}), row({1.0f, 2.0f}), Tolerance::Float);
    EXPECT_NE(reason.find("pixel (1, 0), channel 0"), std::string::npos) << reason;
    EXPECT_NE(reason.find("2.5 instead of 2"), std::string::npos) << reason;
}

}  // namespace
}  // namespace tyndall::rig
