// mayShade(): true for all boxes that a light's pyramid meets, and false for boxes clearly outside.
#include <gtest/gtest.h>
#include <tyndall/shadow_cache.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

namespace tyndall {
namespace {

Light lamp(const glm::dmat4& worldFromLight = glm::dmat4(1.0)) {
    Light light;
    light.worldFromLight = worldFromLight;
    light.fov = {0.9, 0.5};
    light.nearPlane = 0.5;
    light.farPlane = 10.0;
    return light;
}

/// By the light's own description, without a projection: looks along -Z, opens by half of fov each way.
bool inPyramid(const Light& light, const glm::dvec3& world) {
    const glm::dvec3 p =
        glm::transpose(glm::dmat3(light.worldFromLight)) * (world - glm::dvec3(light.worldFromLight[3]));
    const double axis = -p.z;
    return axis >= light.nearPlane && axis <= light.farPlane && std::abs(p.x) <= axis * std::tan(light.fov.x / 2) &&
           std::abs(p.y) <= axis * std::tan(light.fov.y / 2);
}

glm::dmat4 placed(const glm::dvec3& position) {
    return glm::translate(glm::dmat4(1.0), position);
}

TEST(MayShade, EveryBoxWithAPointInThePyramid) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&](double max) { return glm::dvec3(unit(random), unit(random), unit(random)) * max; };
    int met = 0, clear = 0;
    for (int round = 0; round < 20000; ++round) {
        const glm::dvec3 away = round % 3 == 0 ? vector(1e6) : glm::dvec3(0.0);
        const Light light = lamp(glm::rotate(placed(away + vector(3.0)), 3.0 * unit(random), vector(1.0)));
        const glm::dmat4 worldFromMesh =
            glm::scale(glm::rotate(placed(away + vector(8.0)), 3.0 * unit(random), vector(1.0)), vector(2.0));
        const glm::dvec3 a = vector(2.0), b = vector(2.0);
        const MeshBounds bounds{glm::min(a, b), glm::max(a, b)};
        bool meets = false;
        for (int sample = 0; sample < 50; ++sample) {
            const glm::dvec3 at(0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random));
            const glm::dvec3 inMesh =
                sample < 8 ? glm::dvec3(sample & 1 ? a.x : b.x, sample & 2 ? a.y : b.y, sample & 4 ? a.z : b.z)
                           : glm::mix(a, b, at);
            meets = meets || inPyramid(light, glm::dvec3(worldFromMesh * glm::dvec4(inMesh, 1.0)));
        }
        met += meets;
        const bool may = mayShade(light, worldFromMesh, bounds);
        clear += !may;
        ASSERT_TRUE(may || !meets) << "round " << round;
    }
    // Both results must occur.
    EXPECT_GT(met, 1000);
    EXPECT_GT(clear, 2000);
}

TEST(MayShade, AVertexOnAFaceOfThePyramidCountsWhicheverWayItIsRounded) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        const glm::dvec3 axis(unit(random), unit(random), unit(random));
        // Up to 1000 km out, where doubles are 1.2e-10 m apart.
        const Light light = lamp(glm::rotate(placed(axis * (round % 2 ? 1e6 : 1.0)), 3.0 * unit(random), axis));
        const double x = 4.0 * std::tan(light.fov.x / 2), y = 4.0 * std::tan(light.fov.y / 2);
        for (const glm::dvec3 on : {glm::dvec3(x, 0, -4), glm::dvec3(-x, 0, -4), glm::dvec3(0, y, -4),
                                    glm::dvec3(0, -y, -4), glm::dvec3(0, 0, -0.5), glm::dvec3(0, 0, -10.0)}) {
            EXPECT_TRUE(mayShade(light, light.worldFromLight, {on, on}));
        }
    }
}

TEST(MayShade, NothingBeyondOneOfTheSixFaces) {
    const Light light = lamp();
    const MeshBounds cube{glm::dvec3(-1.0), glm::dvec3(1.0)};
    const auto at = [](const glm::dvec3& position) { return placed(position); };
    EXPECT_TRUE(mayShade(light, at({0, 0, -5}), cube));
    // tan(0.45) = 0.483, tan(0.25) = 0.255: at 6 m, the far side of the cube, the pyramid is 2.9 and 1.53 m wide.
    for (const glm::dvec3 side : {glm::dvec3(3.95, 0, -5), glm::dvec3(0, 2.6, -5)})
        for (const double sign : {1.0, -1.0})
            EXPECT_FALSE(mayShade(light, at({sign * side.x, sign * side.y, -5}), cube));
    EXPECT_FALSE(mayShade(light, at({0, 0, -11.01}), cube)) << "beyond the far plane";
    EXPECT_FALSE(mayShade(light, at({0, 0, 0.51}), cube)) << "before the near plane";
    EXPECT_FALSE(mayShade(light, at({0, 0, 5}), cube)) << "behind the lamp";
    EXPECT_TRUE(mayShade(light, at({3.85, 0, -5}), cube));
    EXPECT_TRUE(mayShade(light, at({0, 0, -10.99}), cube));
    EXPECT_TRUE(mayShade(light, at({0, 0, 0.49}), cube));
}

TEST(MayShade, WhateverIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double value : {nan, infinity, -infinity}) {
        glm::dmat4 worldFromMesh(1.0);
        EXPECT_TRUE(mayShade(lamp(), worldFromMesh, {glm::dvec3(100.0), glm::dvec3(value)}));
        worldFromMesh[3] = {100.0, 100.0, value, 1.0};
        EXPECT_TRUE(mayShade(lamp(), worldFromMesh, {}));
        EXPECT_TRUE(mayShade(lamp(placed(glm::dvec3(value))), glm::dmat4(1.0), {}));
    }
}

}  // namespace
}  // namespace tyndall
