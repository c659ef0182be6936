// Slices routed into four channels of one grey value, and the colour of the result.
#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

PlanOptions routed(int number, Geometry geometry = Geometry::ExactPolygons) {
    PlanOptions options = slices(number);
    options.accumulation = Accumulation::Rgba8Routed;
    options.geometry = geometry;
    return options;
}

TEST(Routed, SliceGoesToItsNumberModuloFour) {
    Random random(1);
    const Scene scene = randomScene(random);
    const std::uint32_t masks[] = {0x000000ffu, 0x0000ff00u, 0x00ff0000u, 0xff000000u};  // red is the lowest byte
    for (const Geometry geometry : {Geometry::ExactPolygons, Geometry::StretchedQuads}) {
        const Plan result = planned({scene.light}, scene.view, routed(12, geometry));
        const PlannedLight& light = result.lights[0];
        for (const SliceVertex& vertex : result.vertices) {
            const double depth = geometry == Geometry::ExactPolygons
                                     ? -vertex.position.z
                                     : light.farDepth + (light.nearDepth - light.farDepth) * vertex.position.z;
            const double number = 12.0 * (light.farDepth - depth) / (light.farDepth - light.nearDepth) - 0.5;
            EXPECT_EQ(vertex.channelMask, masks[std::lround(number) % 4]) << "slice " << number;
        }
    }
}

TEST(Routed, NumberIsTheSlabsEvenWhereSlicesAreEmpty) {
    // The beam enters a narrow picture from far outside: its nearest slices are off the guard band.
    const View view = perspectiveView(glm::dmat4(1.0), 5.0 * degrees, 1.0, 0.1, 100.0);
    Light light = projector();
    light.worldFromLight = lookingAt({-2.0, 0.0, -2.0}, {-1.0, 0.0, -3.0});
    const Plan result = planned({light}, view, routed(64));
    const PlannedLight& drawn = result.lights[0];
    const auto found = slicesOf(result, drawn);
    EXPECT_GT(found.size(), 10u);
    EXPECT_LT(found.size(), 64u);
    for (const SliceVertex& vertex : result.vertices) {
        const double fromFar = drawn.farDepth + static_cast<double>(vertex.position.z);
        const auto number = std::lround(64.0 * fromFar / (drawn.farDepth - drawn.nearDepth) - 0.5);
        EXPECT_EQ(vertex.channelMask, 0xffu << (8 * (number % 4)));
    }
}

// Compositing gives tint * grey / scale; grey is the luminance of the shader's result.
TEST(Routed, GreyTimesTintIsTheColour) {
    Random random(3);
    Scene scene = randomScene(random);
    scene.light.colour = {0.1, 0.6, 0.3};
    scene.light.density = 0.05;
    PlanOptions options = routed(8);
    options.range = 4.0;
    const Plan result = planned({scene.light}, scene.view, options);
    const glm::dvec3 shaderColour(constantsOf(result, 0).colour);
    EXPECT_EQ(constantsOf(result, 0).colour.w, 1.0f);
    const double grey = glm::dot(shaderColour, glm::dvec3(0.2126, 0.7152, 0.0722));
    const glm::dvec3 composited = grey * glm::dvec3(result.groups.at(0).tint) / result.scale;
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(composited[channel], scene.light.colour[channel] * 0.05 / (4.0 * glm::pi<double>()), 1e-9);
    EXPECT_EQ(result.scale, 0.25);
}

TEST(Routed, StrongestChannelUsesTheWholeRange) {
    Random random(4);
    Scene scene = randomScene(random);
    scene.light.colour = {0.0, 0.0, 0.5};
    const Plan result = planned({scene.light}, scene.view, routed(8));
    EXPECT_EQ(result.groups.at(0).tint, glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST(Routed, LightsOfOneChromaticityShareAGroup) {
    Random random(5);
    const Scene scene = randomScene(random);
    std::vector<Light> lights(6, scene.light);
    lights[0].colour = {0.9, 0.6, 0.3};
    lights[1].colour = {0.3, 0.2, 0.1};
    lights[2].colour = {0.3, 0.6, 0.9};
    lights[3].worldFromLight[3] += scene.view.worldFromView[2] * 1000.0;  // behind the eye
    lights[4].colour = {3.0, 2.0, 1.0};
    lights[5].colour = {1.0, 1.0, 1.0};
    Plan result = planned(lights, scene.view, routed(8));
    ASSERT_EQ(result.groups.size(), 3u);
    EXPECT_EQ(lightsOf(result, 0), (std::vector<std::size_t>{0, 1, 4}));
    EXPECT_EQ(lightsOf(result, 1), (std::vector<std::size_t>{2}));
    EXPECT_EQ(lightsOf(result, 2), (std::vector<std::size_t>{5}));
    for (std::size_t group = 0; group < 3; ++group)
        for (const std::size_t light : lightsOf(result, group)) EXPECT_EQ(result.lights[light].group, group);

    PlanOptions options = slices(8);
    result = planned(lights, scene.view, options);
    ASSERT_EQ(result.groups.size(), 1u);
    EXPECT_EQ(lightsOf(result, 0), (std::vector<std::size_t>{0, 1, 2, 4, 5}));
    EXPECT_EQ(result.groups[0].tint, glm::vec3(1.0f));
}

TEST(Routed, NothingDrawnMakesNoGroup) {
    Random random(6);
    Scene scene = randomScene(random);
    scene.light.colour = glm::dvec3(0.0);
    EXPECT_TRUE(planned({scene.light}, scene.view, routed(8)).groups.empty());
    EXPECT_TRUE(planned({}, scene.view, slices(8)).groups.empty());
}

}  // namespace
}  // namespace tyndall
