// Compositing of an accumulated sum: it adds up and tints the channels of a routed target, adds to the picture without
// replacing it, and keeps the blur from crossing depth edges.
#include <algorithm>
#include <cmath>

#include "draw.h"
#include "permutation.h"

namespace tyndall::test {
namespace {

class CompositeTest : public GpuTest {};

const std::array<Accumulation, 4> kFormats{Accumulation::Rgba8, Accumulation::Rgba8Routed, Accumulation::Rgba16f,
                                           Accumulation::Rgba32f};

std::array<double, 3> shafts(const Drawing& drawing, Accumulation format, int x, int y) {
    const Picture& sum = drawing.sum;
    const auto& texel = sum.at(std::clamp(x, 0, sum.width - 1), std::clamp(y, 0, sum.height - 1));
    if (format != Accumulation::Rgba8Routed) return {texel[0], texel[1], texel[2]};
    const double grey = static_cast<double>(texel[0]) + texel[1] + texel[2] + texel[3];
    return {grey, grey, grey};
}

// The three by three binomial weights, each reduced by ten times the relative difference in depth.
std::array<double, 3> blurred(const Drawing& drawing, Accumulation format, const Texture& depth, int x, int y) {
    const auto depthAt = [&](int i, int j) {
        return static_cast<double>(depth.at(std::clamp(i, 0, depth.width - 1), std::clamp(j, 0, depth.height - 1)));
    };
    std::array<double, 3> total{};
    double weights = 0.0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const double here = depthAt(x, y), there = depthAt(x + i, y + j);
            const double difference = std::abs(here - there) / std::max({here, there, 1e-30});
            const double weight = (2 - std::abs(i)) * (2 - std::abs(j)) * std::max(0.0, 1.0 - 10.0 * difference);
            const auto value = shafts(drawing, format, x + i, y + j);
            for (int c = 0; c < 3; ++c) total[c] += weight * value[c];
            weights += weight;
        }
    for (double& channel : total) channel /= weights;
    return total;
}

void expectComposited(const Shot& shot, bool blur) {
    for (const Accumulation format : kFormats) {
        SCOPED_TRACE(static_cast<int>(format));
        DrawOptions options;
        options.accumulation = format;
        options.range = 4.0;
        options.composite = true;
        options.blur = blur;
        const Drawing drawing = draw(shot, options);
        ASSERT_EQ(whyNotFinite(drawing.picture), "");
        const glm::vec3 tint = drawing.plan.groups.at(0).tint;
        const Texture depth =
            shot.sceneDepth.texels.empty() ? constantTexture(shot.width, shot.height, {0.0f}) : shot.sceneDepth;
        double brightest = 0.0, worst = 0.0;
        for (int y = 0; y < shot.height; ++y)
            for (int x = 0; x < shot.width; ++x) {
                const auto sum = blur ? blurred(drawing, format, depth, x, y) : shafts(drawing, format, x, y);
                for (int c = 0; c < 3; ++c) {
                    const double shaft = sum[c] * tint[c] / drawing.plan.scale;
                    brightest = std::max(brightest, shaft);
                    worst = std::max(worst, std::abs(drawing.picture.at(x, y)[c] - (kBackground[c] + shaft)));
                }
                EXPECT_EQ(drawing.picture.at(x, y)[3], kBackground[3]);
            }
        EXPECT_GT(brightest, 0.1);
        // Nine taps with a weight of a dozen roundings each (ten times a relative difference), of values up to
        // the brightest and the background; 1 + 10 * 4 half-ulps in a weight weigh the difference of two taps.
        EXPECT_LT(worst, 60.0 * kFloatEps * (brightest + 0.5));
    }
}

TEST_F(CompositeTest, AddsTheSumToThePicture) {
    expectComposited(sideView(), false);
}

TEST_F(CompositeTest, BlursWithinASurfaceAndNotAcrossItsEdge) {
    Shot shot = sideView();
    shot.sceneDepth = planeDepth(shot, {0.0, 0.6, 0.3}, {-0.5, 0.2, 1.0});
    // A pillar in front, its edges in the middle of the shafts, and a hole to the background.
    shot.sceneDepth = makeTexture(shot.width, shot.height, 1, [&](int x, int y, int) {
        if (x > 60 && x < 70) return storedSceneDepth(shot.eye, 3.9);
        return y > 50 && y < 60 ? 0.0 : static_cast<double>(shot.sceneDepth.at(x, y));
    });
    expectComposited(shot, true);
}

}  // namespace
}  // namespace tyndall::test
