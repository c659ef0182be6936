// Laws of slices for any scene.
#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

// The area of the section is a quadratic of depth between the corners' depths and has kinks there, so the
// error of the midpoint rule is O(1/N^2). The constant holds for every shape below; the floats of the upload add 1e-6.
double midpointError(int slices) {
    return 20.0 / (slices * slices) + 1e-6;
}

TEST(Slices, SlabsAddUpToThePyramid) {
    Random random(1);
    for (int trial = 0; trial < 10; ++trial) {
        const Scene scene = randomScene(random);
        for (const int number : {16, 64, 256, 1024}) {
            const Plan result = planned({scene.light}, scene.view, slices(number));
            ASSERT_TRUE(result.lights[0].drawn) << reason(result.lights[0], scene.view);
            EXPECT_NEAR(summedVolume(result, result.lights[0]) / pyramidVolume(scene.light), 1.0, midpointError(number))
                << number << " slices, trial " << trial;
        }
    }
}

TEST(Slices, TwoHalvesMakeAWhole) {
    Random random(2);
    for (int trial = 0; trial < 10; ++trial) {
        Scene scene = randomScene(random);
        Light other = scene.light;
        const glm::dvec3 normal = glm::normalize(inCube(random, 1.0));
        const glm::dvec3 middle(scene.light.worldFromLight * glm::dvec4(0.2, -0.1, -3.0, 1.0));
        const glm::dvec4 cut(normal, -glm::dot(normal, middle));
        scene.light.clipPlanes = {cut};
        other.clipPlanes = {-3.0 * cut};
        const Plan result = planned({scene.light, other}, scene.view, slices(512));
        ASSERT_TRUE(result.lights[0].drawn && result.lights[1].drawn);
        const double first = summedVolume(result, result.lights[0]);
        const double second = summedVolume(result, result.lights[1]);
        EXPECT_GT(first, 0.02 * pyramidVolume(other));
        EXPECT_GT(second, 0.02 * pyramidVolume(other));
        EXPECT_NEAR((first + second) / pyramidVolume(other), 1.0, midpointError(512));
    }
}

TEST(Slices, LieInTheMiddleOfEqualSlabs) {
    Random random(3);
    for (const int number : {1, 2, 7, 100}) {
        const Scene scene = randomScene(random);
        const Plan result = planned({scene.light}, scene.view, slices(number));
        const PlannedLight& light = result.lights[0];
        const double slab = (light.farDepth - light.nearDepth) / number;
        const auto found = slicesOf(result, light);
        ASSERT_EQ(found.size(), static_cast<std::size_t>(number));
        int i = 0;
        for (const auto& [depth, corners] : found)
            EXPECT_EQ(depth, static_cast<float>(light.nearDepth + (i++ + 0.5) * slab))
                << "slice " << i << "/" << number;
        for (const SliceVertex& vertex : result.vertices) EXPECT_EQ(vertex.thickness, static_cast<float>(slab));
    }
}

TEST(Slices, ComeFarthestFirst) {
    Random random(4);
    const Scene scene = randomScene(random);
    const Plan result = planned({scene.light}, scene.view, slices(20));
    for (std::size_t i = 1; i < result.indices.size(); ++i)
        EXPECT_LE(result.vertices[result.indices[i - 1]].position.z, result.vertices[result.indices[i]].position.z);
}

TEST(Slices, SpanTheCornersOfThePyramid) {
    Random random(5);
    const Scene scene = randomScene(random);
    const Plan result = planned({scene.light}, scene.view, slices(4));
    double nearest = 1e9, farthest = 0.0;
    for (const double axis : {0.5, 6.0})
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0}) {
                const glm::dvec4 corner(x * axis * std::tan(20.0 * degrees), y * axis * std::tan(12.0 * degrees), -axis,
                                        1.0);
                const double depth =
                    -(glm::inverse(scene.view.worldFromView) * (scene.light.worldFromLight * corner)).z;
                nearest = std::min(nearest, depth);
                farthest = std::max(farthest, depth);
            }
    EXPECT_NEAR(result.lights[0].nearDepth, nearest, 1e-12);
    EXPECT_NEAR(result.lights[0].farDepth, farthest, 1e-12);
}

TEST(Slices, AcrossThePyramidsAxisAreItsSections) {
    Light light = projector();
    light.worldFromLight = lookingAt({0.0, 0.0, -2.0}, {0.0, 0.0, -3.0});
    const Plan result = planned({light}, wideView(glm::dmat4(1.0)), slices(4096));
    const auto found = slicesOf(result, result.lights[0]);
    ASSERT_EQ(found.size(), 4096u);
    for (const auto& [depth, corners] : found) {
        const glm::dvec2 half = (static_cast<double>(depth) - 2.0) * glm::tan(0.5 * light.fov);
        ASSERT_EQ(corners.size(), 4u);
        for (const glm::dvec2& corner : corners) {
            EXPECT_NEAR(std::fabs(corner.x), half.x, 1e-6);  // a float's step at 8 m
            EXPECT_NEAR(std::fabs(corner.y), half.y, 1e-6);
        }
    }
}

TEST(Slices, AreConvexCounterClockwiseAndWithinEveryPlane) {
    Random random(6);
    for (int trial = 0; trial < 50; ++trial) {
        Scene scene = randomScene(random);
        for (int extra = trial % 7; extra > 0; --extra) {
            const glm::dvec3 normal = glm::normalize(inCube(random, 1.0));
            const glm::dvec3 middle(scene.light.worldFromLight * glm::dvec4(0.0, 0.0, -4.0, 1.0));
            scene.light.clipPlanes.push_back({normal, 0.4 - glm::dot(normal, middle)});
        }
        const Plan result = planned({scene.light}, scene.view, slices(16));
        ASSERT_TRUE(result.lights[0].drawn);
        for (const SliceVertex& vertex : result.vertices) {
            // Half a float's step at 16 m, in each coordinate.
            EXPECT_GE(insideBy(scene.light, scene.view, glm::dvec3(vertex.position)), -2e-6);
            EXPECT_EQ(vertex.channelMask, 0xffffffffu);
        }
        for (const auto& [depth, corners] : slicesOf(result, result.lights[0])) {
            EXPECT_GE(corners.size(), 3u);
            EXPECT_LE(corners.size(), 12u);
            for (const glm::dvec2& corner : corners) EXPECT_GE(insideBy(corners, corner), -2e-6);
        }
        for (std::uint32_t i = 0; i < result.indices.size(); i += 3) {
            const glm::dvec2 a(result.vertices[result.indices[i]].position);
            const glm::dvec2 b(result.vertices[result.indices[i + 1]].position);
            const glm::dvec2 c(result.vertices[result.indices[i + 2]].position);
            EXPECT_GE(cross(b - a, c - a), -1e-5);
        }
    }
}

TEST(Slices, HoldExactlyTheVolumesPoints) {
    Random random(7);
    int inside = 0, outside = 0;
    for (int trial = 0; trial < 10; ++trial) {
        Scene scene = randomScene(random);
        const glm::dvec3 middle(scene.light.worldFromLight * glm::dvec4(0.0, 0.0, -4.0, 1.0));
        const glm::dvec3 normal = glm::normalize(inCube(random, 1.0));
        scene.light.clipPlanes = {{normal, 0.3 - glm::dot(normal, middle)}};
        const Plan result = planned({scene.light}, scene.view, slices(16));
        for (const auto& [depth, corners] : slicesOf(result, result.lights[0])) {
            for (int sample = 0; sample < 100; ++sample) {
                const glm::dvec2 around = corners[0] + glm::dvec2(inCube(random, 4.0));
                const double truth = insideBy(scene.light, scene.view, {around, -static_cast<double>(depth)});
                if (std::fabs(truth) < 1e-5) continue;  // undecided after rounding to float
                (truth > 0.0 ? inside : outside)++;
                EXPECT_EQ(insideBy(corners, around) > 0.0, truth > 0.0) << "at distance " << truth;
            }
        }
    }
    EXPECT_GT(inside, 500);
    EXPECT_GT(outside, 500);
}

// In air that scatters 1 everywhere, the shader's sum along a pixel's ray is the ray's length in the volume. Each end
// lies within a slab, so half a slab may be added or missed.
void expectChords(const Scene& scene, int number, Random& random) {
    const Plan result = planned({scene.light}, scene.view, slices(number));
    const PlannedLight& light = result.lights[0];
    const auto found = slicesOf(result, light);
    const glm::vec4 weight = constantsOf(result, 0).weight;
    const double slab = (light.farDepth - light.nearDepth) / number;
    for (int ray = 0; ray < 100; ++ray) {
        const double axis = between(random, 0.5, 6.0);
        const glm::dvec2 slide(between(random, -0.99, 0.99), between(random, -0.99, 0.99));
        const glm::dvec4 target(axis * slide * glm::tan(0.5 * scene.light.fov), -axis, 1.0);
        const glm::dvec3 aim(glm::inverse(scene.view.worldFromView) * (scene.light.worldFromLight * target));
        const auto at = [&](double depth) {
            return scene.view.orthographic ? glm::dvec3(aim.x, aim.y, -depth) : aim * (depth / -aim.z);
        };
        double sum = 0.0;
        for (const auto& [depth, corners] : found) {
            const glm::dvec3 point = at(depth);
            if (insideBy(corners, glm::dvec2(point)) <= 0.0) continue;
            const double slant = weight.z > 0.0f ? glm::length(point / -point.z) : 1.0;
            const double thickness = weight.y > 0.0f ? slab : 1.0;
            sum += weight.x * thickness * slant;
        }
        const double metre = glm::length(at(1.0) - at(0.0));
        const double chord = depthInside(scene.light, scene.view, at(0.0), at(1.0)) * metre;
        EXPECT_GT(chord, 0.0);
        EXPECT_NEAR(sum, chord, (slab + 1e-5) * metre);
    }
}

TEST(Slices, WeighAsMuchAsTheRayIsLong) {
    Random random(8);
    for (int trial = 0; trial < 5; ++trial) {
        Scene scene = randomScene(random);
        expectChords(scene, 40, random);
        scene.view = orthographicView(scene.view.worldFromView, 8.0, 8.0, 0.01, 100.0);
        expectChords(scene, 40, random);
    }
}

TEST(Slices, StayPutWhenTheWorldMoves) {
    Random random(9);
    for (const double distance : {1.0, 1e5, 1e6}) {
        Scene scene = randomScene(random);
        const glm::dvec3 middle(scene.light.worldFromLight * glm::dvec4(0.0, 0.0, -4.0, 1.0));
        scene.light.clipPlanes = {{0.6, 0.8, 0.0, 0.3 - glm::dot({0.6, 0.8, 0.0}, middle)}};
        const glm::dmat4 motion = rigidMotion(random, distance);
        Scene there = scene;
        there.light.worldFromLight = motion * scene.light.worldFromLight;
        there.light.clipPlanes[0] = moved(motion, scene.light.clipPlanes[0]);
        there.view.worldFromView = motion * scene.view.worldFromView;

        for (const Geometry geometry : {Geometry::ExactPolygons, Geometry::StretchedQuads}) {
            PlanOptions options = slices(16);
            options.geometry = geometry;
            const Plan before = planned({scene.light}, scene.view, options);
            const Plan after = planned({there.light}, there.view, options);
            // The moved matrices themselves are rounded to 1e-10 m at 1e6 m; planes at some metres from the eye
            // and crossings of flat angles amplify that a little. Then one float step at 16 m.
            const double tolerance = 1e-8 + 1e-6;
            ASSERT_EQ(before.vertices.size(), after.vertices.size());
            EXPECT_EQ(before.indices, after.indices);
            for (std::size_t i = 0; i < before.vertices.size(); ++i)
                for (int axis = 0; axis < 3; ++axis)
                    EXPECT_NEAR(before.vertices[i].position[axis], after.vertices[i].position[axis], tolerance);
            EXPECT_NEAR(before.lights[0].nearDepth, after.lights[0].nearDepth, 1e-8);
            EXPECT_NEAR(before.lights[0].farDepth, after.lights[0].farDepth, 1e-8);
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row)
                    EXPECT_NEAR(constantsOf(before, 0).lightFromView[column][row],
                                constantsOf(after, 0).lightFromView[column][row], tolerance);
        }
    }
}

TEST(Slices, OfManyLightsAreThoseOfEach) {
    Random random(10);
    Scene scene = randomScene(random);
    Light second = scene.light;
    second.worldFromLight[3].x += 1.0;
    const Plan both = planned({scene.light, second}, scene.view, slices(8));
    const Plan alone = planned({second}, scene.view, slices(8));
    const PlannedLight& light = both.lights[1];
    ASSERT_EQ(light.indexCount, alone.lights[0].indexCount);
    EXPECT_EQ(light.firstIndex, both.lights[0].indexCount);
    for (std::uint32_t i = 0; i < light.indexCount; ++i)
        EXPECT_EQ(both.vertices[both.indices[light.firstIndex + i]].position,
                  alone.vertices[alone.indices[i]].position);
    ASSERT_EQ(both.groups.size(), 1u);
    EXPECT_EQ(lightsOf(both, 0), (std::vector<std::size_t>{0, 1}));
}

TEST(Slices, KeepToTheGuardBandHoweverLargeTheLight) {
    Light light = projector();
    light.fov = {178.0 * degrees, 178.0 * degrees};
    light.farPlane = 1e8;
    light.worldFromLight = lookingAt({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    View view = perspectiveView(lookingAt({3.0, 0.0, 0.0}, {3.0, 1.0, -2.0}), 60.0 * degrees, 16.0 / 9.0, 0.1, 50.0);
    for (const Geometry geometry : {Geometry::ExactPolygons, Geometry::StretchedQuads}) {
        PlanOptions options = slices(50);
        options.geometry = geometry;
        const Plan result = planned({light}, view, options);
        ASSERT_TRUE(result.lights[0].drawn) << reason(result.lights[0], view);
        EXPECT_GT(result.lights[0].indexCount, 100u);
        const SliceConstants& constants = constantsOf(result, 0);
        for (const SliceVertex& vertex : result.vertices) {
            const glm::vec4 p(glm::vec3(constants.boundsMin) +
                                  (glm::vec3(constants.boundsMax) - glm::vec3(constants.boundsMin)) * vertex.position,
                              1.0f);
            // Polygons narrow with the frustum, quads are as wide as its far end.
            const double depth = geometry == Geometry::ExactPolygons ? -p.z : 50.0;
            EXPECT_LE(std::fabs(p.x), 8.001 * depth * std::tan(30.0 * degrees) * 16.0 / 9.0);
            EXPECT_LE(std::fabs(p.y), 8.001 * depth * std::tan(30.0 * degrees));
        }
    }
}

}  // namespace
}  // namespace tyndall
