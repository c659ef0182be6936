// Laws of a light's shape, over fields of view from 0.01 to 179 degrees.
#include "shape/pyramid.h"

#include <gtest/gtest.h>

#include "geometry/plane.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

Light lightOf(double horizontal, double vertical, double near, double far) {
    Light light;
    light.fov = glm::dvec2(horizontal, vertical) * degrees;
    light.nearPlane = near;
    light.farPlane = far;
    return light;
}

std::vector<Light> lights() {
    std::vector<Light> all = {projector(), lightOf(0.01, 0.01, 0.1, 5.0), lightOf(179.0, 179.0, 0.1, 5.0),
                              lightOf(0.01, 179.0, 1.0, 1.5), lightOf(90.0, 90.0, 1e-6, 1e9)};
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const double near = between(random, 0.01, 2.0);
        all.push_back(lightOf(between(random, 0.01, 179.0), between(random, 0.01, 179.0), near,
                              near + between(random, 0.01, 20.0)));
    }
    return all;
}

// tan(a / 2) = sin(a) / (1 + cos(a)).
glm::dvec2 slopeOfFov(const Light& light) {
    return glm::sin(light.fov) / (1.0 + glm::cos(light.fov));
}

TEST(Pyramid, IsAsWideAsItsFieldOfView) {
    for (const Light& light : lights()) {
        const glm::dvec2 slope = tanHalfFov(light), expected = slopeOfFov(light);
        EXPECT_NEAR(slope.x / expected.x, 1.0, 1e-12);
        EXPECT_NEAR(slope.y / expected.y, 1.0, 1e-12);
        EXPECT_NEAR(narrowness(pyramidOf(light)) / (2.0 * std::min(expected.x, expected.y)), 1.0, 1e-12);
    }
}

TEST(Pyramid, HasItsCornersInTheirOrder) {
    const Light light = lightOf(90.0, 2.0 * std::atan(0.5) / degrees, 1.0, 4.0);  // slopes 1 and 0.5
    const std::array<glm::dvec3, 8> corners = cornersOf(pyramidOf(light));
    const glm::dvec3 expected[] = {{-1, -0.5, -1}, {1, -0.5, -1}, {-1, 0.5, -1}, {1, 0.5, -1},
                                   {-4, -2, -4},   {4, -2, -4},   {-4, 2, -4},   {4, 2, -4}};
    for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_LT(glm::distance(corners[i], expected[i]), 1e-14) << i;
}

// A corner lies on its three planes, and inside the other three.
TEST(Pyramid, HoldsItsCornersBetweenItsPlanes) {
    for (const Light& light : lights()) {
        const Pyramid pyramid = pyramidOf(light);
        const FrustumPlanes planes = changed(planesOf(pyramid), unitPlane);
        const std::array<glm::dvec3, 8> corners = cornersOf(pyramid);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const double eps = 1e-13 * glm::length(corners[i]);
            const auto distance = [&](const glm::dvec4& plane) { return glm::dot(plane, glm::dvec4(corners[i], 1.0)); };
            const auto meets = [&](const glm::dvec4& on, const glm::dvec4& inside) {
                EXPECT_NEAR(distance(on), 0.0, eps) << i;
                EXPECT_GT(distance(inside), eps) << i;
            };
            (i & 1) ? meets(planes.right, planes.left) : meets(planes.left, planes.right);
            (i & 2) ? meets(planes.top, planes.bottom) : meets(planes.bottom, planes.top);
            (i & 4) ? meets(planes.far, planes.near) : meets(planes.near, planes.far);
        }
    }
}

TEST(Pyramid, KeepsExactlyThePointsWithinSlopesAndEnds) {
    Random random(2);
    int kept = 0;
    for (const Light& light : lights()) {
        const Pyramid pyramid = pyramidOf(light);
        SlopeRange slopes = SlopeRange::none();
        for (int i = 0; i < 2; ++i)
            add(slopes, slopeOfFov(light) * glm::dvec2(between(random, -1.0, 1.0), between(random, -1.0, 1.0)));
        const FrustumPlanes planes = frustumPlanes(pyramid, slopes, light.nearPlane, light.farPlane);
        for (int i = 0; i < 100; ++i) {
            const double axis = between(random, 0.5 * light.nearPlane, 1.2 * light.farPlane);
            const glm::dvec2 share(between(random, -0.5, 1.5), between(random, -0.5, 1.5));
            const glm::dvec3 point(axis * (slopes.min + share * (slopes.max - slopes.min)), -axis);
            const bool within = share.x > 0.0 && share.x < 1.0 && share.y > 0.0 && share.y < 1.0;
            const auto all = planes.all();
            const bool inPlanes = std::all_of(all.begin(), all.end(), [&](const glm::dvec4& plane) {
                return glm::dot(plane, glm::dvec4(point, 1.0)) >= 0.0;
            });
            EXPECT_EQ(inPlanes, within && axis >= light.nearPlane && axis <= light.farPlane);
            EXPECT_EQ(holds(pyramid, slopes, point), within);
            const SlopeRange itself{glm::dvec2(point) / axis, glm::dvec2(point) / axis};
            EXPECT_FALSE(holds(pyramid, itself, -axis * glm::dvec3(itself.min, -1.0))) << "behind the lamp";
            kept += inPlanes;
        }
    }
    EXPECT_GT(kept, 2000);
}

TEST(Pyramid, ProjectsPointsToSlopesAndBack) {
    Random random(3);
    for (const Light& light : lights()) {
        const Pyramid pyramid = pyramidOf(light);
        const glm::dvec2 slope = slopeOfFov(light) * glm::dvec2(between(random, -1.0, 1.0), between(random, -1.0, 1.0));
        const double axis = between(random, light.nearPlane, light.farPlane);
        const glm::dvec3 point = pointAt(pyramid, slope, axis);
        EXPECT_DOUBLE_EQ(axisOf(point), axis);
        EXPECT_LT(glm::distance(slopeOf(pyramid, point), slope), 1e-15 * (1.0 + glm::length(slope)));
        EXPECT_LT(glm::distance(point, {axis * slope.x, axis * slope.y, -axis}), 1e-15 * (1.0 + glm::length(point)));
    }
}

double maxCornerDistance(const Pyramid& pyramid, const glm::dvec3& from) {
    double max = 0.0;
    for (const glm::dvec3& corner : cornersOf(pyramid)) max = std::max(max, glm::distance(corner, from));
    return max;
}

// The distance to the farthest corner is a convex function of the centre: a local minimum is the global one.
TEST(Pyramid, HasTheSmallestSphereAroundIt) {
    for (const Light& light : lights()) {
        const Pyramid pyramid = pyramidOf(light);
        const Sphere sphere = boundingSphere(pyramid);
        const double needed = maxCornerDistance(pyramid, sphere.centre);
        EXPECT_LE(needed, sphere.radius);
        EXPECT_GE(needed, sphere.radius * (1.0 - 2e-9));
        for (const glm::dvec3 aside : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
            for (const double step : {1e-2, -1e-2, 1e-1, -1e-1})
                EXPECT_GE(maxCornerDistance(pyramid, sphere.centre + step * needed * aside), needed * (1.0 - 1e-12));
    }
}

TEST(Pyramid, KnowsItsEdges) {
    for (const Light& light : lights()) {
        const Pyramid pyramid = pyramidOf(light);
        const double farthest = maxCornerDistance(pyramid, glm::dvec3(0.0));
        EXPECT_NEAR(maxDistance(pyramid) / farthest, 1.0, 1e-14);
        EXPECT_EQ(maxDistance(light), maxDistance(pyramid));
        EXPECT_NEAR(std::cos(halfDiagonalAngle(pyramid)) * farthest / light.farPlane, 1.0, 1e-12);
    }
}

// Against the edges of a light whose four slopes are 1 and 0.5.
TEST(Pyramid, MeetsAPlaneAtMostSoFarAlongItsAxis) {
    const Pyramid pyramid = pyramidOf(lightOf(90.0, 2.0 * std::atan(0.5) / degrees, 1.0, 4.0));
    EXPECT_NEAR(maxAxisOn({0.0, 0.0, 1.0, 3.0}, pyramid), 3.0, 1e-14) << "head on";
    EXPECT_EQ(maxAxisOn({0.0, 0.0, 1.0, 7.0}, pyramid), 4.0) << "beyond the far plane";
    EXPECT_EQ(maxAxisOn({1.0, 0.0, 0.0, 3.0}, pyramid), 4.0) << "parallel to the axis";
    const double tilt = 0.3;  // n = (sin, 0, cos): w cos - s w sin = d, largest at the slope 1
    EXPECT_NEAR(maxAxisOn({std::sin(tilt), 0.0, std::cos(tilt), 2.0}, pyramid), 2.0 / (std::cos(tilt) - std::sin(tilt)),
                1e-13);
    EXPECT_NEAR(maxAxisOn({0.0, -std::sin(tilt), std::cos(tilt), 2.0}, pyramid),
                2.0 / (std::cos(tilt) - 0.5 * std::sin(tilt)), 1e-13);
}

}  // namespace
}  // namespace tyndall
