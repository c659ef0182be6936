// The depths that a light's shadow map stores, and its resolution.
#include "shape/shadow_projection.h"

#include <gtest/gtest.h>
#include <tyndall/light.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

glm::dvec3 mapped(const Light& light, const glm::dvec3& point) {
    const glm::dvec4 clip = lightClipFromLight(light) * glm::dvec4(point, 1.0);
    return glm::dvec3(clip) / clip.w;
}

TEST(LightClip, RunsFromOneAtNearToZeroAtFar) {
    const Light light = projector();
    EXPECT_NEAR(mapped(light, {0.1, 0.1, -light.nearPlane}).z, 1.0, 1e-15);
    EXPECT_NEAR(mapped(light, {0.1, 0.1, -light.farPlane}).z, 0.0, 1e-15);
    // n / (f - n) * (f / w - 1) with n = 0.5, f = 6, w = 2
    EXPECT_NEAR(mapped(light, {0.3, 0.1, -2.0}).z, 0.5 / 5.5 * 2.0, 1e-15);
}

TEST(LightClip, PutsTheEdgesOfTheFieldOfViewAtOne) {
    const Light light = projector();
    for (const double axis : {0.5, 2.0, 6.0}) {
        const double right = axis * std::tan(20.0 * degrees);
        const double up = axis * std::tan(12.0 * degrees);
        const glm::dvec3 corner = mapped(light, {right, up, -axis});
        EXPECT_NEAR(corner.x, 1.0, 1e-14);
        EXPECT_NEAR(corner.y, -1.0, 1e-14) << "up is at the top, where Vulkan's y is -1";
        EXPECT_NEAR(mapped(light, {-0.5 * right, 0.0, -axis}).x, -0.5, 1e-14);
    }
}

TEST(ShadowDepth, IsWhatTheProjectionStores) {
    Random random(1);
    for (int trial = 0; trial < 100; ++trial) {
        Light light = projector();
        light.nearPlane = between(random, 1e-3, 1.0);
        light.farPlane = light.nearPlane + between(random, 0.1, 100.0);
        const ShadowDepth depth = shadowDepth(light);
        const double axis = between(random, light.nearPlane, light.farPlane);
        EXPECT_NEAR(depth.constant + depth.overAxis / axis, mapped(light, {0.01, 0.02, -axis}).z, 1e-14);
    }
}

TEST(TexelSlopes, DivideTheMapsSide) {
    const Light light = projector();
    const glm::dvec2 all = texelSlopes(shapeOf(light), 256, 256.0);
    EXPECT_NEAR(all.x, 2.0 * std::tan(20.0 * degrees), 1e-15);
    EXPECT_NEAR(all.y, 2.0 * std::tan(12.0 * degrees), 1e-15);
    EXPECT_NEAR(texelSlopes(shapeOf(light), 256, 1.5).x, 1.5 / 256.0 * all.x, 1e-16);
}

// Against the intersections of two rays, a texel apart, with the plane.
TEST(MapErrorShare, IsTheDepthBetweenNeighbouringTexels) {
    Random random(2);
    const LightShape shape = shapeOf(projector());
    constexpr std::uint32_t mapSize = 4096;
    for (int trial = 0; trial < 200; ++trial) {
        const glm::dvec3 normal =
            glm::normalize(glm::dvec3(between(random, -0.5, 0.5), between(random, -0.5, 0.5), 1.0));
        const double distance = between(random, 1.0, 3.0);
        const glm::dvec2 slope(between(random, -0.3, 0.3), between(random, -0.2, 0.2));
        const auto axisAt = [&](const glm::dvec2& s) {
            return distance / (normal.z - normal.x * s.x - normal.y * s.y);
        };
        const glm::dvec2 texel(2.0 * std::tan(20.0 * degrees) / mapSize, 2.0 * std::tan(12.0 * degrees) / mapSize);
        const glm::dvec2 next =
            slope + glm::dvec2(normal.x < 0.0 ? -texel.x : texel.x, normal.y < 0.0 ? -texel.y : texel.y);
        const double axis = axisAt(slope);
        EXPECT_NEAR(mapErrorShare(shape, glm::dvec4(normal, distance), mapSize, axis) * axis, axisAt(next) - axis,
                    3e-3 * (axisAt(next) - axis));
    }
}

}  // namespace
}  // namespace tyndall
