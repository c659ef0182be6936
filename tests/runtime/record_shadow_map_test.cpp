// recordShadowMap() against depths computed by hand.
#include <gtest/gtest.h>
#include <headless/buffer.h>

#include <cmath>

#include "record_scene.h"

namespace tyndall::test {
namespace {

constexpr double nearPlane = 0.5, farPlane = 20.0;

/// Reversed perspective depth at `axis` metres along the light's axis: linear in 1 / axis, 1 at the near plane
/// and 0 at the far plane.
double reversedDepth(double axis) {
    return (1.0 / axis - 1.0 / farPlane) / (1.0 / nearPlane - 1.0 / farPlane);
}

/// A light at the origin of its own space; field of view 90 degrees, so |x| <= axis is lit.
Light spot(const glm::dmat4& worldFromLight = glm::dmat4(1.0)) {
    Light light;
    light.worldFromLight = worldFromLight;
    light.fov = glm::dvec2(std::acos(0.0));
    light.nearPlane = nearPlane;
    light.farPlane = farPlane;
    return light;
}

/// A rectangle at `axis` metres, in light space unless worldFromMesh is given.
struct Rectangle {
    headless::Buffer vertices, indices;
    Occluder occluder;

    Rectangle(glm::vec2 low, glm::vec2 high, float axis, bool turned = false, std::uint32_t stride = 12) {
        std::vector<float> floats;
        for (const glm::vec2 corner : {low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)}) {
            for (const float value : {corner.x, corner.y, -axis}) floats.push_back(value);
            floats.resize(floats.size() + stride / 4 - 3, 1e30f);
        }
        const std::vector<std::uint32_t> order =
            turned ? std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2} : std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
        vertices = must(headless::Buffer::create(gpu().device, std::as_bytes(std::span(floats)),
                                                 VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "occluder vertices"));
        indices = must(headless::Buffer::create(gpu().device, std::as_bytes(std::span(order)),
                                                VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "occluder indices"));
        occluder.vertices = vertices.handle();
        occluder.vertexStride = stride;
        occluder.indices = indices.handle();
        occluder.indexCount = 6;
    }
};

std::vector<float> shadowMap(const Light& light, std::vector<Occluder> occluders) {
    const headless::Image map =
        makeImage({16, 16}, VK_FORMAT_D32_SFLOAT,
                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT, "shadow map");
    FrameData frame;
    run([&](VkCommandBuffer commands) {
        headless::transition(commands, map, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
        auto recorded = gpu().frozen.recordShadowMap(commands, frame, light, occluders, map.view(), map.format(), 16);
        headless::transition(commands, map, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                             VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        return recorded;
    });
    return texels<float>(map, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

// Depth is interpolated from vertices whose z / w is rounded to binary32: a few steps of 2^-24.
constexpr double depthStep = 8 * 0x1p-24;

using RecordShadowMap = GpuTest;

TEST_F(RecordShadowMap, HoldsThePlanesReversedDepth) {
    for (const double axis : {0.75, 2.0, 7.0, 19.0}) {
        const float wide = 2.0f * static_cast<float>(axis);
        const Rectangle wall({-wide, -wide}, {wide, wide}, static_cast<float>(axis));
        for (const float depth : shadowMap(spot(), {wall.occluder})) EXPECT_NEAR(depth, reversedDepth(axis), depthStep);
    }
}

TEST_F(RecordShadowMap, IsEmptyWithoutOccludersOrWhereTheyStandBesideTheCone) {
    const Rectangle beside({40.0f, -1.0f}, {50.0f, 1.0f}, 2.0f), behind({-9.0f, -9.0f}, {9.0f, 9.0f}, -2.0f),
        beyond({-90.0f, -90.0f}, {90.0f, 90.0f}, 21.0f), tooNear({-1.0f, -1.0f}, {1.0f, 1.0f}, 0.25f);
    Occluder nothing;
    for (const float depth : shadowMap(spot(), {})) EXPECT_EQ(depth, 0.0f);
    for (const float depth :
         shadowMap(spot(), {beside.occluder, behind.occluder, beyond.occluder, tooNear.occluder, nothing}))
        EXPECT_EQ(depth, 0.0f);
}

TEST_F(RecordShadowMap, PutsLightSpaceXToTheRightAndYToTheTop) {
    // Covers x < 0 and y > 0: the map's upper left quarter.
    const Rectangle quarter({-9.0f, 0.0f}, {0.0f, 9.0f}, 2.0f);
    const std::vector<float> map = shadowMap(spot(), {quarter.occluder});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_NEAR(map[y * 16 + x], x < 8 && y < 8 ? reversedDepth(2.0) : 0.0, depthStep) << x << ", " << y;
}

TEST_F(RecordShadowMap, TheNearestWinsWhicheverIsDrawnFirst) {
    const Rectangle nearer({-9.0f, -9.0f}, {9.0f, 9.0f}, 2.0f), farther({-9.0f, -9.0f}, {9.0f, 9.0f}, 5.0f);
    for (const float depth : shadowMap(spot(), {nearer.occluder, farther.occluder}))
        EXPECT_NEAR(depth, reversedDepth(2.0), depthStep);
    for (const float depth : shadowMap(spot(), {farther.occluder, nearer.occluder}))
        EXPECT_NEAR(depth, reversedDepth(2.0), depthStep);
}

TEST_F(RecordShadowMap, DrawsBothFaces) {
    for (const bool turned : {false, true}) {
        const Rectangle wall({-9.0f, -9.0f}, {9.0f, 9.0f}, 3.0f, turned);
        for (const float depth : shadowMap(spot(), {wall.occluder})) EXPECT_NEAR(depth, reversedDepth(3.0), depthStep);
    }
}

TEST_F(RecordShadowMap, ReadsInterleavedVerticesAndOffsets) {
    Rectangle wall({-9.0f, -9.0f}, {9.0f, 9.0f}, 3.0f, false, 32);
    for (const float depth : shadowMap(spot(), {wall.occluder})) EXPECT_NEAR(depth, reversedDepth(3.0), depthStep);
    // The second triangle alone: above the diagonal from lower left to upper right.
    wall.occluder.indexOffset = 12;
    wall.occluder.indexCount = 3;
    const std::vector<float> map = shadowMap(spot(), {wall.occluder});
    EXPECT_NEAR(map[1 * 16 + 2], reversedDepth(3.0), depthStep);
    EXPECT_EQ(map[14 * 16 + 13], 0.0f);
}

TEST_F(RecordShadowMap, FarFromTheOriginNothingIsLost) {
    // Light and mesh 100 km out, where binary32 world coordinates would be 7.8 mm apart; a depth step is much less.
    glm::dmat4 away(1.0);
    away[3] = glm::dvec4(1.0e5, -2.0e5, 1.0e5 + 0.123, 1.0);
    Rectangle wall({-9.0f, -9.0f}, {9.0f, 9.0f}, 2.0f);
    wall.occluder.worldFromMesh = away;
    // The doubles themselves are 2.9e-11 m apart there: nothing beside the bound.
    for (const float depth : shadowMap(spot(away), {wall.occluder})) EXPECT_NEAR(depth, reversedDepth(2.0), depthStep);
}

}  // namespace
}  // namespace tyndall::test
