// Compositing alone, on accumulation targets that the tests fill themselves.
#include <gtest/gtest.h>

#include <cmath>

#include "record_scene.h"

namespace tyndall::test {
namespace {

/// A plan with one group and nothing to accumulate.
Plan emptyPlan(Accumulation accumulation, double scale, glm::vec3 tint) {
    Plan plan;
    plan.accumulation = accumulation;
    plan.scale = scale;
    plan.groups.push_back({tint, 0, 0});
    return plan;
}

void composite(const Stage& stage, const Plan& plan, const ShaftTargets& targets) {
    FrameData frame;
    must(gpu().frozen.upload(frame, plan));
    run([&](VkCommandBuffer commands) { return gpu().frozen.recordComposite(commands, frame, plan, 0, targets); });
    ASSERT_EQ(stage.extent.width, targets.extent.width);
}

template <class Texel>
void setAccumulation(Stage& stage, Texel&& texel) {
    std::vector<Rgba> values;
    for (std::uint32_t y = 0; y < stage.extent.height; ++y)
        for (std::uint32_t x = 0; x < stage.extent.width; ++x) values.push_back(texel(x, y));
    fill(stage.accumulation, values, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

/// White in the left half, black in the right.
Rgba halves(std::uint32_t x, std::uint32_t) {
    return x < 8 ? Rgba{1.0f, 1.0f, 1.0f, 1.0f} : Rgba{};
}

/// The red channel of `halves`, blurred over a depth, for row 5.
std::vector<float> blurredRow(VkCompareOp compare, float leftDepth, float rightDepth) {
    Stage stage({16, 12});
    setAccumulation(stage, halves);
    stage.setDepth([&](std::uint32_t x, std::uint32_t) { return x < 8 ? leftDepth : rightDepth; });
    ShaftTargets targets = stage.targets();
    targets.blur = true;
    targets.depthCompare = compare;
    composite(stage, emptyPlan(Accumulation::Rgba32f, 1.0, glm::vec3(1.0f)), targets);
    const std::vector<Rgba> picture = stage.picture();
    std::vector<float> row;
    for (std::size_t x = 0; x < 16; ++x) row.push_back(picture[5 * 16 + x][0]);
    return row;
}

using RecordComposite = GpuTest;

TEST_F(RecordComposite, AddsTheTintedSumOverTheScale) {
    Stage stage({16, 12});
    stage.setColour({0.25f, 0.5f, 0.75f, 0.875f});
    setAccumulation(stage, [](std::uint32_t x, std::uint32_t y) {
        return Rgba{static_cast<float>(x), static_cast<float>(y), 3.0f, 99.0f};
    });
    composite(stage, emptyPlan(Accumulation::Rgba32f, 4.0, {1.0f, 0.5f, 0.25f}), stage.targets());
    const std::vector<Rgba> picture = stage.picture();
    for (std::uint32_t y = 0; y < 12; ++y)
        for (std::uint32_t x = 0; x < 16; ++x)
            // Powers of two throughout: exact. Alpha is the caller's own.
            EXPECT_EQ(picture[y * 16 + x], (Rgba{0.25f + static_cast<float>(x) / 4.0f,
                                                 0.5f + static_cast<float>(y) / 8.0f, 0.75f + 3.0f / 16.0f, 0.875f}))
                << x << ", " << y;
}

TEST_F(RecordComposite, RoutedSumsTheFourChannels) {
    Stage stage({16, 12}, Accumulation::Rgba8Routed);
    std::vector<std::array<std::uint8_t, 4>> values;
    for (std::uint8_t i = 0; i < 16 * 12; ++i) values.push_back({i, 1, 2, 4});
    fill(stage.accumulation, values, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    composite(stage, emptyPlan(Accumulation::Rgba8Routed, 2.0, {1.0f, 0.5f, 0.25f}), stage.targets());
    const std::vector<Rgba> picture = stage.picture();
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const float sum = static_cast<float>(i + 7) / 255.0f / 2.0f;
        // Four unorm conversions and three additions, each within an ulp (2^-23 of at most the sum).
        const float bound = sum * 7.0f * 0x1p-23f;
        EXPECT_NEAR(picture[i][0], sum, bound);
        EXPECT_NEAR(picture[i][1], sum * 0.5f, bound);
        EXPECT_NEAR(picture[i][2], sum * 0.25f, bound);
        EXPECT_EQ(picture[i][3], 0.0f);
    }
}

TEST_F(RecordComposite, BlursAcrossTheBackgroundAndEvenSurfaces) {
    // The binomial kernel's columns are 1 2 1: three quarters beside the edge, one quarter across it.
    for (const float depth : {0.0f, 0.3f, 1.0f}) {
        const std::vector<float> row = blurredRow(VK_COMPARE_OP_GREATER_OR_EQUAL, depth, depth);
        EXPECT_FLOAT_EQ(row[6], 1.0f);
        EXPECT_FLOAT_EQ(row[7], 0.75f);
        EXPECT_FLOAT_EQ(row[8], 0.25f);
        EXPECT_FLOAT_EQ(row[9], 0.0f);
    }
}

TEST_F(RecordComposite, BlurStopsAtDepthEdges) {
    std::vector<float> sharp(16, 0.0f);
    std::fill(sharp.begin(), sharp.begin() + 8, 1.0f);
    // Reversed depth is near / d: twice as far; a surface before the background; an eighth farther, just beyond
    // the tolerance of a tenth.
    EXPECT_EQ(blurredRow(VK_COMPARE_OP_GREATER_OR_EQUAL, 0.5f, 0.25f), sharp);
    EXPECT_EQ(blurredRow(VK_COMPARE_OP_GREATER, 0.001f, 0.0f), sharp);
    EXPECT_EQ(blurredRow(VK_COMPARE_OP_GREATER_OR_EQUAL, 0.01f, 0.0088f), sharp);
    // The same surfaces in conventional depth, where 0.99 and 0.995 look alike but are twice as far apart.
    EXPECT_EQ(blurredRow(VK_COMPARE_OP_LESS_OR_EQUAL, 0.99f, 0.995f), sharp);
    EXPECT_EQ(blurredRow(VK_COMPARE_OP_LESS, 0.5f, 1.0f), sharp);
}

TEST_F(RecordComposite, BlurFadesWithTheDistanceBetweenSurfaces) {
    // A twentieth apart: half the weight, (1 + 2) / (1 + 2 + 0.5) beside the edge. The same surfaces in
    // conventional depth.
    for (const auto& row : {blurredRow(VK_COMPARE_OP_GREATER_OR_EQUAL, 0.4f, 0.38f),
                            blurredRow(VK_COMPARE_OP_LESS_OR_EQUAL, 0.6f, 0.62f)}) {
        EXPECT_NEAR(row[7], 3.0f / 3.5f, 1e-5f);
        EXPECT_NEAR(row[8], 0.5f / 3.5f, 1e-5f);
    }
}

TEST_F(RecordComposite, BlurKeepsConstantsAndReachesEveryNeighbour) {
    // Far from square: a swapped axis would read beyond the neighbour.
    for (const VkExtent2D extent : {VkExtent2D{36, 12}, VkExtent2D{12, 36}}) {
        Stage stage(extent);
        setAccumulation(stage, [](std::uint32_t x, std::uint32_t y) {
            return x == 7 && y == 5 ? Rgba{16.0f, 0.0f, 1.0f, 0.0f} : Rgba{0.0f, 0.0f, 1.0f, 0.0f};
        });
        ShaftTargets targets = stage.targets();
        targets.blur = true;
        composite(stage, emptyPlan(Accumulation::Rgba32f, 1.0, glm::vec3(1.0f)), targets);
        const std::vector<Rgba> picture = stage.picture();
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const int x = static_cast<int>(i % extent.width), y = static_cast<int>(i / extent.width);
            const int dx = std::abs(x - 7), dy = std::abs(y - 5);
            const float expected = dx < 2 && dy < 2 ? static_cast<float>((2 - dx) * (2 - dy)) : 0.0f;
            EXPECT_FLOAT_EQ(picture[i][0], expected) << x << ", " << y;
            EXPECT_FLOAT_EQ(picture[i][2], 1.0f) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace tyndall::test
