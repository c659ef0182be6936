#include "geometry/slice_polygon.h"

#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

const glm::dvec2 low(-1.0, -2.0);
const glm::dvec2 high(3.0, 1.0);

SlicePolygon cutBy(const std::vector<glm::dvec4>& planes, double depth = 5.0) {
    return slicePolygon(low, high, planes, depth);
}

TEST(SlicePolygon, IsTheRectangleWithoutPlanes) {
    const SlicePolygon polygon = cutBy({});
    EXPECT_EQ(polygon.count, 4u);
    EXPECT_DOUBLE_EQ(area(polygon), 12.0) << "counter-clockwise";
}

TEST(SlicePolygon, ReadsAPlaneAtItsDepth) {
    // Keeps x - 0.5 * z - 3 >= 0; at depth 5 z is -5, so x >= 0.5.
    EXPECT_NEAR(area(cutBy({{1.0, 0.0, -0.5, -3.0}})), 2.5 * 3.0, 1e-14);
    EXPECT_NEAR(area(cutBy({{1.0, 0.0, -0.5, -3.0}}, 7.0)), 3.5 * 3.0, 1e-14);
}

TEST(SlicePolygon, GainsACornerForACorner) {
    const SlicePolygon polygon = cutBy({{-1.0, -1.0, 0.0, 3.0}});  // cuts off the corner (3, 1) by 1
    EXPECT_EQ(polygon.count, 5u);
    EXPECT_NEAR(area(polygon), 11.5, 1e-14);
}

TEST(SlicePolygon, SplitsWithoutLossByAnyLine) {
    Random random(1);
    for (int trial = 0; trial < 1000; ++trial) {
        const double angle = between(random, 0.0, 6.3);
        const glm::dvec4 plane(std::cos(angle), std::sin(angle), between(random, -1.0, 1.0),
                               between(random, -3.0, 3.0));
        EXPECT_NEAR(area(cutBy({plane})) + area(cutBy({-plane})), 12.0, 1e-12);
    }
}

TEST(SlicePolygon, DoesNotDependOnTheOrderOfPlanes) {
    Random random(2);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<glm::dvec4> planes;
        for (int i = 0; i < 12; ++i) {
            const double angle = between(random, 0.0, 6.3);
            planes.push_back({std::cos(angle), std::sin(angle), 0.0, between(random, 0.2, 2.0)});
        }
        const double forward = area(cutBy(planes));
        std::reverse(planes.begin(), planes.end());
        EXPECT_NEAR(area(cutBy(planes)), forward, 1e-12);
        EXPECT_GT(forward, 0.04 * 3.14) << "holds the circle of radius 0.2";
    }
}

TEST(SlicePolygon, IsEmptyWhereNothingIsLeft) {
    EXPECT_EQ(cutBy({{1.0, 0.0, 0.0, -3.5}}).count, 0u) << "beyond the rectangle";
    EXPECT_EQ(cutBy({{1.0, 0.0, 0.0, -3.0}}).count, 0u) << "touches along a side";
    EXPECT_EQ(cutBy({{1.0, 1.0, 0.0, -4.0}}).count, 0u) << "touches in a corner";
    EXPECT_EQ(cutBy({{0.0, 0.0, 1.0, 4.0}}).count, 0u) << "parallel, the slice on the wrong side";
    EXPECT_EQ(cutBy({{1.0, 0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0, 0.0}}).count, 0u) << "a line";
    EXPECT_EQ(cutBy({{1.0, 0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0, 1e-17}}).count, 0u) << "a sliver";
    // A polygon with distinct corners whose area is below 1e-16 of the square of 5 m.
    EXPECT_EQ(cutBy({{1.0, 1.0, 0.0, -4.0 + 1e-8}}).count, 0u) << "a corner of a hundredth of a micrometre";
    EXPECT_EQ(cutBy({{1.0, 1.0, 0.0, -4.0 + 1e-6}}).count, 3u) << "a corner of a micrometre";
}

TEST(SlicePolygon, KeepsAllOfAParallelPlanesRightSide) {
    EXPECT_DOUBLE_EQ(area(cutBy({{0.0, 0.0, 1.0, 6.0}})), 12.0);
    EXPECT_DOUBLE_EQ(area(cutBy({{0.0, 0.0, 1.0, 5.0}})), 12.0) << "lies in the plane";
}

TEST(SlicePolygon, MakesOneCornerWhereThreeLinesMeet) {
    const SlicePolygon polygon = cutBy({{1.0, 1.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}, {2.0, 1.0, 0.0, 0.0}});
    for (std::size_t i = 0; i < polygon.count; ++i)
        EXPECT_GT(glm::distance(polygon.corners[i], polygon.corners[(i + 1) % polygon.count]), 1e-9);
}

TEST(SlicePolygon, MakesOneCornerOfTwoWhereverCountingBegins) {
    // Each plane cuts off a corner of the rectangle by less than rounding. That makes two neighbouring corners of one,
    // also of the first and the last.
    for (const glm::dvec2 corner : {low, glm::dvec2(high.x, low.y), high, glm::dvec2(low.x, high.y)}) {
        const glm::dvec2 inward = glm::sign(0.5 * (low + high) - corner);
        const double offset = -glm::dot(inward, corner) - 1e-13;
        const SlicePolygon polygon = cutBy({{inward.x, inward.y, 0.0, offset}});
        EXPECT_EQ(polygon.count, 4u) << corner.x << ", " << corner.y;
        EXPECT_NEAR(area(polygon), 12.0, 1e-12);
    }
}

}  // namespace
}  // namespace tyndall
