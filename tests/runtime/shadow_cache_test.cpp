// ShadowCache: a map is stale when, and only when, something that it shows is another.
#include <gtest/gtest.h>
#include <tyndall/shadow_cache.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "allocations.h"

namespace tyndall {
namespace {

constexpr std::uint32_t size = 512;

VkBuffer buffer(std::uint64_t number) {
    return std::bit_cast<VkBuffer>(number);
}

Light lamp() {
    Light light;
    light.worldFromLight[3] = {1.0, 2.0, 3.0, 1.0};
    return light;
}

std::vector<Occluder> twoOccluders() {
    std::vector<Occluder> occluders(2);
    occluders[0] = {buffer(7), 64, 32, buffer(8), 128, 300, glm::dmat4(1.0)};
    occluders[1] = {buffer(7), 960, 32, buffer(8), 1328, 30, glm::dmat4(1.0)};
    occluders[1].worldFromMesh[3].x = 4.0;
    return occluders;
}

class ShadowCacheTest : public testing::Test {
protected:
    ShadowCacheTest() { cache.drawn(0, light, occluders, size); }
    bool stale(std::uint32_t side = size) const { return cache.stale(0, light, occluders, side); }

    /// One value changed by the least that it can be makes the map stale, and back again makes it fresh.
    void expectCounts(double& value) {
        const double was = value;
        for (const double other : {std::nextafter(was, 1e9), std::nextafter(was, -1e9), was + 1.0,
                                   std::numeric_limits<double>::quiet_NaN()}) {
            value = other;
            EXPECT_TRUE(stale()) << was << " became " << other;
            value = was;
            EXPECT_FALSE(stale());
        }
    }

    Light light = lamp();
    std::vector<Occluder> occluders = twoOccluders();
    ShadowCache cache;
};

TEST_F(ShadowCacheTest, EveryNumberOfTheLightsPyramidCounts) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) expectCounts(light.worldFromLight[column][row]);
    for (double* const value : {&light.fov.x, &light.fov.y, &light.nearPlane, &light.farPlane}) expectCounts(*value);
    EXPECT_TRUE(stale(size + 1));
    std::swap(light.worldFromLight[0][1], light.worldFromLight[3][1]);
    EXPECT_TRUE(stale()) << "the same values in other places";
}

TEST_F(ShadowCacheTest, WhatElseALightSaysDoesNot) {
    light.name = "another";
    light.colour = {0.5, 0.25, 1.0};
    light.intensity = 5.0;
    light.density = 1.0;
    light.ambient = 2.0;
    light.cookie = true;
    light.noise.emplace();
    light.clipPlanes.push_back({0.0, 1.0, 0.0, 0.0});
    EXPECT_FALSE(stale());
}

TEST_F(ShadowCacheTest, EverythingOfAnOccluderCounts) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) expectCounts(occluders[1].worldFromMesh[column][row]);
    const std::vector<std::function<void(Occluder&)>> changes = {
        [](Occluder& o) { o.vertices = buffer(9); }, [](Occluder& o) { o.vertexOffset += 4; },
        [](Occluder& o) { o.vertexStride += 4; },    [](Occluder& o) { o.indices = buffer(7); },
        [](Occluder& o) { o.indexOffset += 4; },     [](Occluder& o) { o.indexCount -= 3; }};
    for (std::size_t change = 0; change < changes.size(); ++change) {
        const Occluder was = occluders[0];
        changes[change](occluders[0]);
        EXPECT_TRUE(stale()) << "change " << change;
        occluders[0] = was;
        EXPECT_FALSE(stale());
    }
    std::swap(occluders[0].worldFromMesh, occluders[1].worldFromMesh);
    EXPECT_TRUE(stale()) << "two meshes that changed places";
}

TEST_F(ShadowCacheTest, OccludersThatComeAndGoCount) {
    const Occluder second = occluders[1];
    occluders.pop_back();
    EXPECT_TRUE(stale());
    occluders.push_back(second);
    EXPECT_FALSE(stale());
    occluders.insert(occluders.end(), {second, second});
    EXPECT_TRUE(stale()) << "a pair of the same does not cancel";
    occluders.clear();
    EXPECT_TRUE(stale());
    cache.drawn(0, light, occluders, size);
    EXPECT_FALSE(stale()) << "an empty map is a map too";
}

TEST_F(ShadowCacheTest, OrderAndWhatDrawsNothingDoNot) {
    std::swap(occluders[0], occluders[1]);
    EXPECT_FALSE(stale());
    Occluder nothing = occluders[0];
    nothing.indexCount = 0;
    occluders.push_back(nothing);
    EXPECT_FALSE(stale());
}

TEST_F(ShadowCacheTest, BothZerosAreOneAndSoAreAllNans) {
    light.worldFromLight[0][1] = -0.0;
    occluders[0].worldFromMesh[2][0] = -0.0;
    EXPECT_FALSE(stale());
    occluders[0].worldFromMesh[2][0] = std::numeric_limits<double>::quiet_NaN();
    cache.drawn(0, light, occluders, size);
    occluders[0].worldFromMesh[2][0] = -std::nan("17");
    EXPECT_FALSE(stale());
}

TEST_F(ShadowCacheTest, LightsAreApart) {
    cache.drawn(5, light, occluders, size);
    for (const std::size_t unknown : {1, 4, 6, 1000000}) EXPECT_TRUE(cache.stale(unknown, light, occluders, size));
    Light other = light;
    other.worldFromLight[3].y += 1.0;
    EXPECT_TRUE(cache.stale(5, other, occluders, size));
    cache.drawn(5, other, occluders, size);
    EXPECT_FALSE(cache.stale(5, other, occluders, size));
    EXPECT_FALSE(stale());
    cache.invalidate(5);
    cache.invalidate(1000000);
    EXPECT_TRUE(cache.stale(5, other, occluders, size));
    EXPECT_FALSE(stale());
    cache.invalidate();
    EXPECT_TRUE(stale());
}

TEST_F(ShadowCacheTest, AskingAndDrawingAgainAllocateNothing) {
    const std::size_t before = test::allocations();
    bool any = false;
    for (int frame = 0; frame < 100; ++frame) {
        any = any || stale();
        cache.drawn(0, light, occluders, size);
    }
    EXPECT_EQ(test::allocations(), before);
    EXPECT_FALSE(any);
}

}  // namespace
}  // namespace tyndall
