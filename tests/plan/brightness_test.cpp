// The bound of a pixel's radiance from a light, against the integral and against the sum over planned slices.
#include "needs/brightness.h"

#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

struct Sums {
    double integral = 0.0, slices = 0.0;
};

// Light that a metre of air at that point scatters towards the eye, in the strongest channel.
double scattered(const Light& light, const View& view, const glm::dvec3& p) {
    const glm::dvec3 lamp = lightFromView(light, view, p);
    const double strongest = std::max({light.colour.r, light.colour.g, light.colour.b});
    return light.density * strongest / (4.0 * glm::pi<double>()) *
           (light.intensity / glm::dot(lamp, lamp) + light.ambient);
}

Sums alongRay(const Scene& scene, const std::map<float, Corners>& slices, const std::map<float, double>& thickness,
              const glm::dvec3& direction) {  // for a metre of depth
    const double slant = glm::length(direction);
    Sums sums;
    constexpr int steps = 4000;
    const double far = 25.0, h = far / steps;
    for (int i = 0; i < steps; ++i) {
        const glm::dvec3 p = direction * (h * (i + 0.5));
        if (insideBy(scene.light, scene.view, p) > 0.0)
            sums.integral += scattered(scene.light, scene.view, p) * h * slant;
    }
    for (const auto& [depth, corners] : slices) {
        const glm::dvec3 p = direction * static_cast<double>(depth);
        if (insideBy(corners, glm::dvec2(p)) > 0.0)
            sums.slices += scattered(scene.light, scene.view, p) * thickness.at(depth) * slant;
    }
    return sums;
}

TEST(Brightness, IsReachedByNoPixelAndBySomeNearly) {
    Random random(1);
    double integralShare = 0.0, sliceShare = 0.0;
    int lit = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Scene scene = randomScene(random);
        scene.view = perspectiveView(scene.view.worldFromView, 0.9, 1.5, 0.1, std::numeric_limits<double>::infinity());
        glm::dmat4 viewFromLight = rigidMotion(random, 2.5);
        viewFromLight[3].z -= 4.0;
        scene.light.worldFromLight = scene.view.worldFromView * viewFromLight;
        scene.light.colour = {between(random, 0.0, 1.0), between(random, 0.0, 1.0), between(random, 0.1, 1.0)};
        scene.light.nearPlane = between(random, 0.05, 1.0);
        scene.light.ambient = random() % 2 ? between(random, 0.0, 20.0) : 0.0;
        PlanOptions options = slices(1 + static_cast<int>(random() % 64));
        options.spacing = random() % 2 ? Spacing::Adaptive : Spacing::Even;
        const Plan plan = planned({scene.light}, scene.view, options);
        const PlannedLight& light = plan.lights[0];
        if (!light.drawn) continue;
        const std::map<float, Corners> drawn = slicesOf(plan, light);
        std::map<float, double> thickness;
        for (const SliceVertex& vertex : plan.vertices) thickness[-vertex.position.z] = vertex.thickness;
        for (int ray = 0; ray < 30; ++ray) {
            const glm::dvec3 direction(0.483 * 1.5 * between(random, -1.0, 1.0), 0.483 * between(random, -1.0, 1.0),
                                       -1.0);
            const Sums sums = alongRay(scene, drawn, thickness, direction);
            if (sums.integral == 0.0) continue;
            ++lit;
            // The error of the oracle's midpoint rule is less than a hundredth: h / d is at most 6 mm over 5 cm.
            EXPECT_LE(sums.integral, 1.01 * light.brightest) << trial;
            EXPECT_LE(sums.slices, (1.0 + 1e-5) * light.brightest) << trial;
            integralShare = std::max(integralShare, sums.integral / light.brightest);
            sliceShare = std::max(sliceShare, sums.slices / light.brightest);
        }
    }
    EXPECT_GT(lit, 500);
    EXPECT_GT(integralShare, 0.2);
    EXPECT_GT(sliceShare, 0.2);
}

// The integral is closest to the bound if the eye looks past the lamp within its near plane's width.
TEST(Brightness, HoldsBesideTheLamp) {
    Light light = projector();
    light.fov = {1.4, 1.4};
    light.nearPlane = 0.1;
    light.farPlane = 20.0;
    for (const double angle : {0.0, 0.4, 0.8, 1.2, 1.57})
        for (const int count : {1, 2, 7, 100})
            for (const Spacing spacing : {Spacing::Even, Spacing::Adaptive}) {
                Scene scene{light, wideView(glm::dmat4(1.0))};
                scene.light.worldFromLight =
                    lookingAt({0.0, 0.0, -5.0}, {std::sin(angle), 0.0, -5.0 - std::cos(angle)}, {0.0, 1.0, 0.0});
                PlanOptions options = slices(count);
                options.spacing = spacing;
                const Plan plan = planned({scene.light}, scene.view, options);
                const std::map<float, Corners> drawn = slicesOf(plan, plan.lights[0]);
                std::map<float, double> thickness;
                for (const SliceVertex& vertex : plan.vertices) thickness[-vertex.position.z] = vertex.thickness;
                for (double x = -0.5; x < 0.5; x += 0.0173)
                    for (const double y : {0.0, 0.011}) {
                        const Sums sums = alongRay(scene, drawn, thickness, {x, y, -1.0});
                        EXPECT_LE(sums.integral, 1.05 * plan.lights[0].brightest);
                        EXPECT_LE(sums.slices, (1.0 + 1e-5) * plan.lights[0].brightest) << angle << " " << count;
                    }
            }
}

// A partly hidden slab counts as a whole one if its slice is seen, and counts more on a slanted ray.
TEST(Brightness, CountsHalfHiddenSlabsAskance) {
    Scene scene{projector(), perspectiveView(glm::dmat4(1.0), 3.0, 1.0, 0.1, std::numeric_limits<double>::infinity())};
    scene.light.worldFromLight = lookingAt({-20.0, -1.0, -2.0}, {-20.0, 3.0, -2.0}, {1.0, 0.0, 0.0});
    scene.light.intensity = 0.0;
    scene.light.ambient = 1.0;
    const Plan whole = planned({scene.light}, scene.view, slices(1));
    const SliceVertex slice = whole.vertices.at(0);
    const float hidden = -1.001f * slice.position.z;
    Surroundings surroundings;
    surroundings.depth = DepthTiles{1, 1, std::span(&hidden, 1)};
    const Result<Plan> part = plan(std::span(&scene.light, 1), scene.view, slices(1), surroundings);
    ASSERT_TRUE(part);
    ASSERT_EQ(part->lights[0].slices, 1);
    double brightest = 0.0;
    for (const SliceVertex& vertex : part->vertices) {
        const glm::dvec3 p(vertex.position);
        brightest =
            std::max(brightest, scattered(scene.light, scene.view, p) * vertex.thickness * glm::length(p) / -p.z);
    }
    EXPECT_GT(brightest, 0.3 * part->lights[0].brightest);
    EXPECT_LE(brightest, (1.0 + 1e-5) * part->lights[0].brightest);
}

}  // namespace
}  // namespace tyndall
