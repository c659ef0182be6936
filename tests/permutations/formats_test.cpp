// The losses of each accumulation format: the stored sums against the oracle's, within bounds that follow from the
// format's rounding.
#include <algorithm>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class FormatTest : public GpuTest {};

Shot formatShot(int slices = 16) {
    Shot shot = sideView();
    shot.slices = slices;
    return shot;
}

double brightest(const OracleImage& image, int channel, bool quarters) {
    double max = 0.0;
    for (const PixelSum& pixel : image.pixels) {
        if (!quarters) max = std::max(max, pixel.rgba[channel].hi);
        for (const auto& quarter : pixel.quarter)
            if (quarters) max = std::max(max, quarter[channel].hi);
    }
    return max;
}

// A value that a 8-bit target adds is first converted to a 255th, "to nearest" as the Vulkan specification prefers and
// with an error of at most 0.6 of a step, as Direct3D's functional specification allows; sums of 255ths are exact.
Interval quantized(Interval sum, int fragments, double range) {
    const double slack = 0.6 / 255.0 * fragments * range;
    return {sum.lo - slack, sum.hi + slack};
}

TEST_F(FormatTest, EightBitsLoseAtMostHalfAStepForEachSlice) {
    const Shot shot = formatShot();
    const OracleImage expected = oracle(shot);
    DrawOptions options;
    options.accumulation = Accumulation::Rgba8;
    options.range = 1.05 * std::max(brightest(expected, 0, false), brightest(expected, 3, false));
    const Drawing drawing = draw(shot, options);
    EXPECT_NEAR(drawing.plan.scale, 1.0 / options.range, 1e-12 / options.range);
    std::vector<Allowed> allowed;
    for (const PixelSum& pixel : expected.pixels) {
        Allowed channels{};
        for (int c = 0; c < 4; ++c) channels[c] = quantized(pixel.rgba[c], pixel.fragments, options.range);
        allowed.push_back(channels);
    }
    EXPECT_EQ(whyOutside(drawing.sum, drawing.plan.scale, allowed), "");
    EXPECT_GT(litPixels(drawing.sum), 500);
}

// Slice i, counted from the farthest, goes to channel i mod 4.
TEST_F(FormatTest, RoutedEightBitsKeepEveryFourthSliceInAChannelOfItsOwn) {
    for (const Permutation& permutation : predictedPermutations()) {
        SCOPED_TRACE(permutation.name());
        Shot shot = shotFor(permutation, formatShot(20));
        shot.routed = true;
        const OracleImage expected = oracle(shot);
        DrawOptions options = optionsFor(permutation);
        options.accumulation = Accumulation::Rgba8Routed;
        options.range = 1.05 * brightest(expected, 3, true);
        const Drawing drawing = draw(shot, options);
        std::vector<Allowed> allowed;
        for (const PixelSum& pixel : expected.pixels) {
            Allowed channels{};
            // A channel gets five of twenty slices, but only those that cover the pixel.
            for (int q = 0; q < 4; ++q)
                channels[q] = quantized(pixel.quarter[q][3], std::min(pixel.fragments, 5), options.range);
            allowed.push_back(channels);
        }
        EXPECT_EQ(whyOutside(drawing.sum, drawing.plan.scale, allowed), "");
        EXPECT_GT(litPixels(drawing.sum), 500);

        // The grey value times the group's tint is the light's colour again.
        ASSERT_EQ(drawing.plan.groups.size(), 1u);
        const glm::dvec3 colour = shot.light.colour;
        const double max = std::max({colour.r, colour.g, colour.b});
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawing.plan.groups[0].tint[c], colour[c] / max, 1e-6);
    }
}

// binary16 keeps 11 bits: an addition that rounds toward zero, as it may, loses up to 2^-10 of the total so far. Below
// 2^-14 a total may be flushed to zero; this lamp is so bright that one such loss a slice does not show.
TEST_F(FormatTest, HalfFloatsLoseAtMostAnUlpOfTheTotalForEachSlice) {
    Shot shot = formatShot();
    shot.light.intensity *= 50.0;
    shot.light.ambient *= 50.0;
    const OracleImage expected = oracle(shot);
    DrawOptions options;
    options.accumulation = Accumulation::Rgba16f;
    const Drawing drawing = draw(shot, options);
    EXPECT_EQ(drawing.plan.scale, 1.0);
    std::vector<Allowed> allowed;
    for (const PixelSum& pixel : expected.pixels) {
        Allowed channels{};
        for (int c = 0; c < 4; ++c) {
            const double slack = 0x1p-10 * pixel.runningTotals[c] + 0x1p-14 * pixel.fragments;
            channels[c] = {pixel.rgba[c].lo - slack, pixel.rgba[c].hi + slack};
        }
        allowed.push_back(channels);
    }
    EXPECT_LT(vagueness(allowed), 0.06);
    EXPECT_EQ(whyOutside(drawing.sum, drawing.plan.scale, allowed), "");
    EXPECT_GT(litPixels(drawing.sum), 500);
}

}  // namespace
}  // namespace tyndall::test
