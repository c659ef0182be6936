// Depth tiles of a drawn depth buffer, against every pixel of it.
#include <gtest/gtest.h>
#include <tyndall/depth_survey.h>

#include "allocations.h"
#include "numbers.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

// Forward: 0 near and 1 far, as many engines draw. The library's views are reversed.
View forward(View view) {
    glm::dmat4 flip(1.0);
    flip[2].z = -1.0;
    flip[3].z = 1.0;
    view.clipFromView = flip * view.clipFromView;
    return view;
}

std::vector<std::pair<std::string, View>> views() {
    const glm::dmat4 eye = lookingAt({1.0, 2.0, 3.0}, {0.0, 0.0, 0.0});
    const View endless = perspectiveView(eye, 0.9, 1.5, 0.1, infinity),
               ended = perspectiveView(eye, 0.9, 1.5, 0.1, 50.0), flat = orthographicView(eye, 3.0, 2.0, 0.1, 50.0);
    return {{"endless reversed", endless}, {"reversed", ended},         {"orthographic reversed", flat},
            {"endless", forward(endless)}, {"forward", forward(ended)}, {"orthographic", forward(flat)}};
}

float stored(const View& view, double metres) {
    const glm::dvec4 clip = view.clipFromView * glm::dvec4(0.0, 0.0, -metres, 1.0);
    return static_cast<float>(clip.z / clip.w);
}

float background(const View& view) {
    return stored(view, 0.2) > stored(view, 0.3) ? 0.0f : 1.0f;
}

// A tile overlaps a pixel where their ranges do, in units of 1 / (tiles * side).
bool overlap(std::size_t tile, std::size_t tiles, std::size_t pixel, std::size_t side) {
    return tile * side < (pixel + 1) * tiles && pixel * tiles < (tile + 1) * side;
}

// What a tile may say of a surface at most. Forward floats near 1 are 6e-8 apart, which is 6e-7 z^2 metres with a near
// plane of 0.1 m and 3e-6 m in an orthographic view of 50 m.
double largest(double metres) {
    return metres * (1.0 + 2e-5) + 3.0 * 6e-7 * metres * metres + 1e-5;
}

TEST(DepthSurvey, KnowsTheFarthestOfEveryPixelInATile) {
    Random random(1);
    for (const auto& [name, view] : views())
        for (const auto& [width, height] :
             {std::pair(1u, 1u), {5u, 3u}, {16u, 9u}, {17u, 10u}, {64u, 36u}, {101u, 57u}}) {
            std::vector<double> metres;
            std::vector<float> depths;
            for (unsigned i = 0; i < width * height; ++i) {
                metres.push_back(random() % 20 == 0 ? infinity : between(random, 0.2, 40.0));
                depths.push_back(metres.back() == infinity ? background(view) : stored(view, metres.back()));
            }
            DepthSurvey survey;
            const Result<void> done = surveyDepth(depths, width, height, view, survey);
            ASSERT_TRUE(done) << done.error().message;
            ASSERT_EQ(survey.columns, std::min(width, 16u));
            ASSERT_EQ(survey.rows, std::min(height, 9u));
            ASSERT_EQ(survey.tiles.size(), std::size_t{survey.columns} * survey.rows);
            double farthest = 0.0;
            for (std::size_t row = 0; row < survey.rows; ++row)
                for (std::size_t column = 0; column < survey.columns; ++column) {
                    double expected = 0.0;
                    for (std::size_t y = 0; y < height; ++y)
                        for (std::size_t x = 0; x < width; ++x)
                            if (overlap(column, survey.columns, x, width) && overlap(row, survey.rows, y, height))
                                expected = std::max(expected, metres[y * width + x]);
                    farthest = std::max(farthest, expected);
                    const double tile = survey.tiles[row * survey.columns + column];
                    if (expected == infinity) {
                        EXPECT_EQ(tile, infinity) << name;
                        continue;
                    }
                    // A tile is a 32-bit float.
                    EXPECT_GE(tile * (1.0 + 1e-7), expected) << name;
                    EXPECT_LE(tile, largest(expected)) << name;
                }
            if (farthest == infinity)
                EXPECT_EQ(survey.farthest, View{}.sceneDepth) << name;
            else
                EXPECT_TRUE(survey.farthest >= farthest && survey.farthest <= largest(farthest)) << name;
            const DepthTiles tiles = survey.asTiles();
            EXPECT_EQ(tiles.columns, survey.columns);
            EXPECT_EQ(tiles.rows, survey.rows);
            EXPECT_EQ(tiles.farthest.data(), survey.tiles.data());
        }
}

// A reversed float is exact near 0: the margin alone keeps a surface's last slice.
TEST(DepthSurvey, TakesASurfaceToBeALittleFarther) {
    const View view = perspectiveView(glm::dmat4(1.0), 0.9, 1.5, 0.1, infinity);
    for (const double metres : {0.5, 3.0, 70.0, 5000.0}) {
        const float depth = stored(view, metres);
        DepthSurvey survey;
        ASSERT_TRUE(surveyDepth(std::span(&depth, 1), 1, 1, view, survey));
        EXPECT_GT(survey.tiles[0], metres * (1.0 + 5e-6));
        EXPECT_LT(survey.tiles[0], metres * (1.0 + 2e-5));
    }
}

// Few numbers are left for what is far away in a forward buffer, or near in a long orthographic one.
TEST(DepthSurvey, TakesASurfaceToBeFartherByTheRoundingOfItsDepth) {
    Random random(2);
    const glm::dmat4 eye(1.0);
    const View steep = forward(perspectiveView(eye, 0.9, 1.5, 0.01, infinity)),
               longFlat = orthographicView(eye, 3.0, 2.0, 0.1, 1e5);
    int rounded = 0;
    for (int i = 0; i < 2000; ++i)
        for (const auto& [view, metres] :
             {std::pair(steep, between(random, 10.0, 2000.0)), std::pair(longFlat, between(random, 0.2, 100.0))}) {
            const float depth = stored(view, metres);
            DepthSurvey survey;
            ASSERT_TRUE(surveyDepth(std::span(&depth, 1), 1, 1, view, survey));
            EXPECT_GE(survey.farthest, metres);
            const glm::dvec4 back = glm::inverse(view.clipFromView) * glm::dvec4(0.0, 0.0, depth, 1.0);
            rounded += -back.z / back.w * (1.0 + 1e-5) < metres;
        }
    EXPECT_GT(rounded, 100) << "a share of the distance alone does not do";
}

TEST(DepthSurvey, HidesNothingBehindWhatIsNoDepth) {
    for (const auto& [name, view] : views())
        for (const float odd : {background(view), NAN, background(view) == 0.0f ? -1.0f : 2.0f})
            for (const std::size_t at : {0u, 1u, 2u}) {
                std::vector<float> depths(3, stored(view, 5.0));
                depths[at] = odd;
                DepthSurvey survey;
                ASSERT_TRUE(surveyDepth(depths, 1, 3, view, survey));
                for (std::size_t i = 0; i < 3; ++i)
                    EXPECT_EQ(survey.tiles[i] == infinity, i == at) << name << ", " << odd;
            }
}

TEST(DepthSurvey, KeepsItsMemory) {
    const View view = views()[0].second;
    const std::vector<float> depths(64 * 36, stored(view, 5.0));
    DepthSurvey survey;
    ASSERT_TRUE(surveyDepth(depths, 64, 36, view, survey));
    const std::size_t before = allocations();
    ASSERT_TRUE(surveyDepth(depths, 64, 36, view, survey));
    EXPECT_EQ(allocations(), before);
}

TEST(DepthSurvey, RefusesWhatIsNoDepthBuffer) {
    const View view = views()[0].second;
    const std::vector<float> depths(12, 0.5f);
    const auto expectRefused = [&](std::uint32_t width, std::uint32_t height, const View& of,
                                   const std::string& words) {
        DepthSurvey survey;
        survey.tiles = {7.0f};
        const Result<void> done = surveyDepth(depths, width, height, of, survey);
        ASSERT_FALSE(done) << words;
        EXPECT_EQ(done.error().code, ErrorCode::InvalidArgument);
        EXPECT_NE(done.error().message.find(words), std::string::npos) << done.error().message;
        EXPECT_EQ(survey.tiles, std::vector{7.0f}) << "unchanged";
    };
    expectRefused(4, 4, view, "depth survey: there are 12 depths for 4 x 4 pixels");
    expectRefused(0, 3, view, "depth survey: there are 12 depths for 0 x 3 pixels");
    View oblique = view;
    oblique.clipFromView[0].z = 0.1;
    expectRefused(4, 3, oblique, "depth must not depend on x and y");
    View bad = view;
    bad.nearPlane = -1.0;
    expectRefused(4, 3, bad, "view: nearPlane is -1");
}

}  // namespace
}  // namespace tyndall
