// The begin, direction and end of a pixel's ray. The reference and its Monte Carlo check share this code, so their
// agreement does not test it.
#include <gtest/gtest.h>

#include <cmath>

#include "light_ray.h"
#include "scenes.h"
#include "study_scene.h"
#include "surfaces.h"

namespace tyndall::test {
namespace {

using study::ViewRay;

View orthographic(double halfWidth, double halfHeight, double nearPlane, double farPlane) {
    View view;
    view.orthographic = true;
    view.nearPlane = nearPlane;
    view.farPlane = farPlane;
    view.clipFromView = glm::dmat4(0.0);
    view.clipFromView[0][0] = 1.0 / halfWidth;
    view.clipFromView[1][1] = -1.0 / halfHeight;
    view.clipFromView[2][2] = 1.0 / (farPlane - nearPlane);
    view.clipFromView[3][2] = farPlane / (farPlane - nearPlane);
    view.clipFromView[3][3] = 1.0;
    return view;
}

glm::dvec3 pointAt(const ViewRay& ray, double depth) {
    return ray.origin + ray.direction * (ray.perDepth * depth);
}

TEST(ViewRay, PassesThroughWhatTheProjectionPutsOnItsPixel) {
    View shifted = eye({0, 0, 0}, {0, 0, -1}, 1.1);
    shifted.clipFromView[2][0] = 0.3;  // an off-centre picture, and a turned one
    shifted.clipFromView[1][0] = 0.2;
    for (const View& view : {eye({1, 2, 3}, {0.3, -0.5, 1.0}, 1.1), shifted, orthographic(3.0, 2.0, 0.5, 20.0)})
        for (const auto& [x, y] : {std::pair{0.5, 0.5}, {31.5, 0.5}, {16.0, 9.0}, {3.25, 17.5}}) {
            const ViewRay ray = study::viewRay(view, 32, 18, x, y);
            EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-15);
            for (const double depth : {0.7, 3.0, 19.0}) {
                const glm::dvec3 p = pointAt(ray, depth);
                EXPECT_NEAR(-p.z, depth, 1e-13);
                const glm::dvec4 clip = view.clipFromView * glm::dvec4(p, 1.0);
                EXPECT_NEAR(32.0 * (0.5 + 0.5 * clip.x / clip.w), x, 1e-12);
                EXPECT_NEAR(18.0 * (0.5 + 0.5 * clip.y / clip.w), y, 1e-12);
                EXPECT_NEAR(study::depthOf(view, ray, clip.z / clip.w), depth, 1e-11);
            }
        }
}

TEST(ViewRay, NothingDrawnIsTheFarPlane) {
    const ViewRay ray = study::viewRay(eye({0, 0, 0}, {0, 0, -1}, 1.0, 0.1, 50.0), 4, 4, 1.5, 0.5);
    EXPECT_NEAR(study::depthOf(eye({0, 0, 0}, {0, 0, -1}, 1.0, 0.1, 50.0), ray, 0.0), 50.0, 1e-10);
    View infinite = eye({0, 0, 0}, {0, 0, -1}, 1.0, 0.1, 50.0);
    infinite.clipFromView[2][2] = 0.0;
    infinite.clipFromView[3][2] = 0.1;
    EXPECT_NEAR(study::depthOf(infinite, ray, 0.02), 5.0, 1e-13);
    EXPECT_EQ(study::depthOf(infinite, ray, 0.0), std::numeric_limits<double>::infinity());
}

TEST(Surfaces, EndRaysWhereTheyCanBeSeen) {
    const View view = eye({1.0, 2.0, 3.0}, {0.0, 0.0, -1.0});
    const ViewRay ray = study::viewRay(view, 1, 1, 0.5, 0.5);
    // Counter-clockwise as seen from +Z, where the eye is.
    const auto at = [](double z, bool facing, bool both) {
        study::Triangle t{{-50, -50, z}, {50, -50, z}, {0, 80, z}, both};
        if (!facing) std::swap(t.b, t.c);
        return t;
    };
    const auto hit = [&](std::vector<study::Triangle> triangles, double begin = 0.0, double end = 100.0) {
        return study::Surfaces(view, triangles).firstHit(ray, begin, end);
    };
    constexpr double none = std::numeric_limits<double>::infinity();
    EXPECT_EQ(hit({}), none);
    EXPECT_NEAR(hit({at(-1.1, true, false)}), 4.1, 1e-15 * 4.1);  // not a float's 4.1
    EXPECT_EQ(hit({at(-1.1, false, false)}), none);
    EXPECT_NEAR(hit({at(-1.1, false, true)}), 4.1, 1e-14);
    EXPECT_NEAR(hit({at(-1.1, false, false), at(-2.0, true, false)}), 5.0, 1e-14);
    EXPECT_NEAR(hit({at(-1.1, true, false), at(-2.0, true, false)}, 4.5), 5.0, 1e-14);
    EXPECT_EQ(hit({at(-1.1, true, false)}, 0.0, 4.0), none);
    EXPECT_EQ(hit({at(5.0, true, true)}), none);  // behind the eye
}

// Even light, a wide pyramid and ambient alone: radiance is the visible length of the ray.
TEST(Reference, RaysEndAtNearPlaneFarPlaneAndSurface) {
    Light light = plainLight();
    light.intensity = 0.0;
    light.ambient = 4.0 * 3.14159265358979323846;
    light.density = 1.0;
    light.fov = glm::dvec2(2.8);
    light.nearPlane = 1e-3;
    light.farPlane = 100.0;
    light.worldFromLight = lookAlong({0, 0, 0}, {0, 1, 0});
    study::ReferenceScene scene = oneRay(light, {0.0, 50.0, 5.0}, {0.0, 0.0, -1.0});
    scene.view.nearPlane = 2.0;
    scene.view.farPlane = 30.0;
    EXPECT_NEAR(radianceOf(scene).x, 28.0, 1e-12);
    scene.triangles = pane({-9, 0, -1}, {9, 0, -1}, {9, 99, -1}, {-9, 99, -1});
    EXPECT_NEAR(radianceOf(scene).x, 4.0, 1e-12);
    scene.mode = study::Mode::Hardware;
    EXPECT_NEAR(radianceOf(scene).x, 28.0, 1e-12);  // triangles are not what hardware saw
    const View& view = scene.view;
    const glm::dvec4 clip = view.clipFromView * glm::dvec4(0.0, 0.0, -12.5, 1.0);
    scene.depth = {1, 1, 1, {static_cast<float>(clip.z / clip.w)}};
    EXPECT_NEAR(radianceOf(scene).x, 10.5, 1e-3);  // as finely as a float holds this reversed depth
    scene.depth.values[0] = 0.0f;
    EXPECT_NEAR(radianceOf(scene).x, 28.0, 1e-12);
    scene.depth.values[0] = 1.0f;
    EXPECT_EQ(radianceOf(scene).x, 0.0);
    scene.view = orthographic(1.0, 1.0, 2.0, 30.0);
    scene.view.worldFromView = lookAlong({0.0, 50.0, 5.0}, {0.0, 0.0, -1.0});
    scene.depth.values[0] = 0.25f;  // 30 - 0.25 * 28
    EXPECT_NEAR(radianceOf(scene).x, 21.0, 1e-12);
}

}  // namespace
}  // namespace tyndall::test
