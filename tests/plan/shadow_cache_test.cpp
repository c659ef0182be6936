// ShadowCache: a map is stale if, and only if, something that it shows has changed.
#include <gtest/gtest.h>
#include <tyndall/shadow_cache.h>

#include <cmath>
#include <limits>

#include "allocations.h"

namespace tyndall {
namespace {

constexpr std::uint32_t cachedSide = 512;

Light cacheLamp() {
    Light light;
    light.worldFromLight[3] = {1.0, 2.0, 3.0, 1.0};
    return light;
}

std::vector<ShadowCaster> twoCasters() {
    std::vector<ShadowCaster> casters(2);
    casters[0].geometry = {7, 64, 32, 8, 128, 300};
    casters[1].geometry = {7, 960, 32, 8, 1328, 30};
    casters[1].worldFromMesh[3].x = 4.0;
    return casters;
}

class ShadowCacheTest : public testing::Test {
protected:
    ShadowCacheTest() { cache.drawn(0, light, casters, cachedSide); }
    bool stale(std::uint32_t side = cachedSide) const { return cache.stale(0, light, casters, side); }

    /// The smallest change of one value makes the map stale; the old value makes it fresh again.
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

    Light light = cacheLamp();
    std::vector<ShadowCaster> casters = twoCasters();
    ShadowCache cache;
};

TEST_F(ShadowCacheTest, EveryNumberOfTheLightsPyramidCounts) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) expectCounts(light.worldFromLight[column][row]);
    for (double* const value : {&light.fov.x, &light.fov.y, &light.nearPlane, &light.farPlane}) expectCounts(*value);
    EXPECT_TRUE(stale(cachedSide + 1));
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

TEST_F(ShadowCacheTest, EverythingOfACasterCounts) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) expectCounts(casters[1].worldFromMesh[column][row]);
    for (std::uint64_t& number : casters[0].geometry)
        for (const std::uint64_t change : {std::uint64_t{1}, std::uint64_t{1} << 63}) {
            number ^= change;
            EXPECT_TRUE(stale()) << "number " << &number - casters[0].geometry.data();
            number ^= change;
            EXPECT_FALSE(stale());
        }
    std::swap(casters[0].worldFromMesh, casters[1].worldFromMesh);
    EXPECT_TRUE(stale()) << "two meshes that changed places";
}

TEST_F(ShadowCacheTest, CastersThatComeAndGoCount) {
    const ShadowCaster second = casters[1];
    casters.pop_back();
    EXPECT_TRUE(stale());
    casters.push_back(second);
    EXPECT_FALSE(stale());
    casters.insert(casters.end(), {second, second});
    EXPECT_TRUE(stale()) << "a pair of the same does not cancel";
    casters.clear();
    EXPECT_TRUE(stale());
    cache.drawn(0, light, casters, cachedSide);
    EXPECT_FALSE(stale()) << "an empty map is a map too";
}

TEST_F(ShadowCacheTest, OrderAndWhatDrawsNothingDoNot) {
    std::swap(casters[0], casters[1]);
    EXPECT_FALSE(stale());
    ShadowCaster nothing = casters[0];
    nothing.geometry = {};
    casters.push_back(nothing);
    EXPECT_FALSE(stale());
}

TEST_F(ShadowCacheTest, BothZerosAreOneAndSoAreAllNans) {
    light.worldFromLight[0][1] = -0.0;
    casters[0].worldFromMesh[2][0] = -0.0;
    EXPECT_FALSE(stale());
    casters[0].worldFromMesh[2][0] = std::numeric_limits<double>::quiet_NaN();
    cache.drawn(0, light, casters, cachedSide);
    casters[0].worldFromMesh[2][0] = -std::nan("17");
    EXPECT_FALSE(stale());
}

TEST_F(ShadowCacheTest, LightsAreApart) {
    cache.drawn(5, light, casters, cachedSide);
    for (const std::size_t unknown : {1, 4, 6, 1000000}) EXPECT_TRUE(cache.stale(unknown, light, casters, cachedSide));
    Light other = light;
    other.worldFromLight[3].y += 1.0;
    EXPECT_TRUE(cache.stale(5, other, casters, cachedSide));
    cache.drawn(5, other, casters, cachedSide);
    EXPECT_FALSE(cache.stale(5, other, casters, cachedSide));
    EXPECT_FALSE(stale());
    cache.invalidate(5);
    cache.invalidate(1000000);
    EXPECT_TRUE(cache.stale(5, other, casters, cachedSide));
    EXPECT_FALSE(stale());
    cache.invalidate();
    EXPECT_TRUE(stale());
}

TEST_F(ShadowCacheTest, AskingAndDrawingAgainAllocateNothing) {
    const std::size_t before = test::allocations();
    bool any = false;
    for (int frame = 0; frame < 100; ++frame) {
        any = any || stale();
        cache.drawn(0, light, casters, cachedSide);
    }
    EXPECT_EQ(test::allocations(), before);
    EXPECT_FALSE(any);
}

}  // namespace
}  // namespace tyndall
