// A slice in two parts.
#include <gtest/gtest.h>

#include <set>

#include "geometry/slice_polygon.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

SlicePolygon randomPolygon(Random& random) {
    std::vector<glm::dvec4> planes;
    for (int i = 0; i < 8; ++i) {
        const double angle = between(random, 0.0, 6.3);
        planes.push_back({std::cos(angle), std::sin(angle), 0.0, between(random, 0.3, 2.0)});
    }
    return slicePolygon({-1.0, -1.5}, {2.0, 1.0}, planes, 5.0);
}

TEST(PolygonSplit, LosesNothingAndDoublesNothing) {
    Random random(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const SlicePolygon whole = randomPolygon(random);
        const double angle = between(random, 0.0, 6.3);
        const glm::dvec2 normal(std::cos(angle), std::sin(angle));
        const double offset = between(random, -1.5, 1.5);
        SlicePolygon inside, outside;
        split(whole, normal, offset, inside, outside);
        EXPECT_NEAR(area(inside) + area(outside), area(whole), 1e-12);
        EXPECT_GE(area(inside), 0.0);
        EXPECT_GE(area(outside), 0.0);
        for (std::size_t i = 0; i < inside.count; ++i) EXPECT_GE(glm::dot(normal, inside.corners[i]) + offset, -1e-12);
        for (std::size_t i = 0; i < outside.count; ++i) EXPECT_LE(glm::dot(normal, outside.corners[i]) + offset, 1e-12);
    }
}

TEST(PolygonSplit, SharesItsCornersBitForBit) {
    Random random(2);
    int both = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const SlicePolygon whole = randomPolygon(random);
        const double angle = between(random, 0.0, 6.3);
        SlicePolygon inside, outside;
        split(whole, {std::cos(angle), std::sin(angle)}, between(random, -1.0, 1.0), inside, outside);
        if (inside.count == 0 || outside.count == 0) continue;
        ++both;
        const auto corners = [](const SlicePolygon& polygon) {
            std::set<std::pair<double, double>> set;
            for (std::size_t i = 0; i < polygon.count; ++i) set.insert({polygon.corners[i].x, polygon.corners[i].y});
            return set;
        };
        const auto in = corners(inside), out = corners(outside), all = corners(whole);
        int shared = 0;
        for (const auto& corner : in) shared += out.contains(corner);
        EXPECT_EQ(shared, 2);
        // No corner of the whole is lost.
        for (const auto& corner : all) EXPECT_TRUE(in.contains(corner) || out.contains(corner));
    }
    EXPECT_GT(both, 500);
}

TEST(PolygonSplit, ThroughCornersLeavesNoSliver) {
    const SlicePolygon square = slicePolygon({-1.0, -1.0}, {1.0, 1.0}, {}, 5.0);
    SlicePolygon inside, outside;
    split(square, {1.0, -1.0}, 0.0, inside, outside);  // the diagonal
    EXPECT_EQ(inside.count, 3u);
    EXPECT_EQ(outside.count, 3u);
    split(square, {1.0, 0.0}, 1.0, inside, outside);  // its left side
    EXPECT_EQ(inside.count, 4u);
    EXPECT_EQ(outside.count, 0u);
    split(square, {1.0, 0.0}, -1.0, inside, outside);  // its right side
    EXPECT_EQ(inside.count, 0u);
    EXPECT_EQ(outside.count, 4u);
    split(SlicePolygon{}, {1.0, 0.0}, 0.0, inside, outside);
    EXPECT_EQ(inside.count + outside.count, 0u);
}

}  // namespace
}  // namespace tyndall
