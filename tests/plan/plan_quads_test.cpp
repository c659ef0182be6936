// The published geometry: unit-cube quads, stretched over the bounds and cut by clip distances.
#include <gtest/gtest.h>

#include "plan_scenes.h"
#include "visibility/light_volume.h"
#include "visibility/view_pose.h"

namespace tyndall {
namespace {

using namespace test;

PlanOptions quads(int number) {
    PlanOptions options = slices(number);
    options.geometry = Geometry::StretchedQuads;
    return options;
}

// The output of vs_main for a vertex.
struct Stretched {
    glm::dvec3 position;
    double thickness;
    double kept;  // minimum clip distance
};

Stretched stretched(const SliceConstants& constants, const glm::dvec3& unit, double thickness) {
    const glm::dvec3 low(constants.boundsMin), extent(glm::dvec3(constants.boundsMax) - low);
    Stretched result{low + extent * unit, std::fabs(extent.z) * thickness, 1e300};
    for (const glm::vec4& plane : constants.clipPlanes)
        result.kept = std::min(result.kept, glm::dot(glm::dvec4(plane), glm::dvec4(result.position, 1.0)));
    return result;
}

TEST(Quads, AreTheUnitSquareAtSlabMidpoints) {
    Random random(1);
    const Scene scene = randomScene(random);
    const Plan result = planned({scene.light}, scene.view, quads(10));
    ASSERT_EQ(result.vertices.size(), 40u);
    ASSERT_EQ(result.indices.size(), 60u);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(result.vertices[i].position.z, static_cast<float>((static_cast<double>(i / 4) + 0.5) / 10.0));
        EXPECT_EQ(result.vertices[i].thickness, 0.1f);
        EXPECT_EQ(result.vertices[i].channelMask, 0xffffffffu);
    }
    // Ten unit squares, a tenth thick each.
    EXPECT_NEAR(summedVolume(result, result.lights[0]), 1.0, 1e-6);
}

TEST(Quads, LieAtTheDepthsOfThePolygonsAndAroundThem) {
    Random random(2);
    for (int trial = 0; trial < 20; ++trial) {
        const Scene scene = randomScene(random);
        const Plan exact = planned({scene.light}, scene.view, slices(16));
        const Plan published = planned({scene.light}, scene.view, quads(16));
        const SliceConstants& constants = constantsOf(published, 0);
        EXPECT_EQ(exact.lights[0].nearDepth, published.lights[0].nearDepth);
        EXPECT_EQ(exact.lights[0].farDepth, published.lights[0].farDepth);

        const auto polygons = slicesOf(exact, exact.lights[0]);
        ASSERT_EQ(polygons.size(), 16u);
        std::size_t slice = 0;  // polygons by depth ascending, quads farthest first
        for (const auto& [depth, corners] : polygons) {
            const SliceVertex& quad = published.vertices[4 * (15 - slice++)];
            const Stretched at = stretched(constants, quad.position, quad.thickness);
            // Two float roundings of bounds and one of the share, at 16 m.
            EXPECT_NEAR(-at.position.z, depth, 4e-6);
            EXPECT_NEAR(at.thickness, exact.vertices[0].thickness, 1e-6);
            for (const glm::dvec2& corner : corners) {
                EXPECT_GE(corner.x, constants.boundsMin.x);
                EXPECT_GE(corner.y, constants.boundsMin.y);
                EXPECT_LE(corner.x, constants.boundsMax.x);
                EXPECT_LE(corner.y, constants.boundsMax.y);
            }
        }
    }
}

// The volume's outermost corner lies between two slices; the rounded bounds must still hold it.
TEST(Quads, HoldTheWholeVolumeAfterRounding) {
    Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
        const Scene scene = randomScene(random);
        const SliceConstants constants = constantsOf(planned({scene.light}, scene.view, quads(16)), 0);
        ConvexPolyhedron seen;
        const LightVolume volume = lightVolume(
            scene.light, scene.view, lightPose(scene.light.worldFromLight, scene.view.worldFromView), {}, {}, seen);
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_LE(static_cast<double>(constants.boundsMin[axis]), volume.boundsMin[axis]);
            EXPECT_GE(static_cast<double>(constants.boundsMax[axis]), volume.boundsMax[axis]);
        }
    }
}

TEST(Quads, AreCutToTheVolume) {
    Random random(3);
    int inside = 0, outside = 0;
    for (int trial = 0; trial < 10; ++trial) {
        Scene scene = randomScene(random);
        for (int extra = trial % 3; extra > 0; --extra) {
            const glm::dvec3 middle(scene.light.worldFromLight * glm::dvec4(0.0, 0.0, -4.0, 1.0));
            const glm::dvec3 normal = glm::normalize(inCube(random, 1.0));
            scene.light.clipPlanes.push_back({2.0 * normal, 0.6 - 2.0 * glm::dot(normal, middle)});
        }
        const Plan result = planned({scene.light}, scene.view, quads(16));
        const SliceConstants& constants = constantsOf(result, 0);
        for (int sample = 0; sample < 500; ++sample) {
            const glm::dvec3 unit(glm::dvec3(0.5) + inCube(random, 0.5));
            const Stretched at = stretched(constants, unit, 0.0);
            const double truth = insideBy(scene.light, scene.view, at.position);
            if (std::fabs(truth) < 1e-5) continue;
            (truth > 0.0 ? inside : outside)++;
            EXPECT_EQ(at.kept > 0.0, truth > 0.0);
            if (truth > 0.0) {
                EXPECT_NEAR(at.kept, truth, 4e-6) << "clip distances are metres";
            }
        }
    }
    EXPECT_GT(inside, 300);
    EXPECT_GT(outside, 300);
}

TEST(Quads, AreShared) {
    Random random(4);
    Scene scene = randomScene(random);
    Light second = scene.light;
    second.worldFromLight[3].x += 1.0;
    const Plan result = planned({scene.light, second}, scene.view, quads(8));
    EXPECT_EQ(result.vertices.size(), 32u);
    EXPECT_EQ(result.lights[1].firstIndex, 0u);
    EXPECT_EQ(result.lights[1].indexCount, 48u);
    EXPECT_NE(constantsOf(result, 0).boundsMin, constantsOf(result, 1).boundsMin);
}

TEST(Polygons, ComeWithBoundsAndPlanesThatChangeNothing) {
    Random random(5);
    const Scene scene = randomScene(random);
    const Plan result = planned({scene.light}, scene.view, slices(8));
    const SliceConstants& constants = constantsOf(result, 0);
    for (const SliceVertex& vertex : result.vertices) {
        const Stretched at = stretched(constants, vertex.position, vertex.thickness);
        EXPECT_EQ(at.position, glm::dvec3(vertex.position));
        EXPECT_EQ(at.thickness, vertex.thickness);
        EXPECT_EQ(at.kept, 1.0);
    }
}

}  // namespace
}  // namespace tyndall
