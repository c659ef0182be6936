#include <gtest/gtest.h>
#include <tyndall/view.h>

#include "numbers.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

glm::dvec3 projected(const View& view, const glm::dvec3& point) {
    const glm::dvec4 clip = view.clipFromView * glm::dvec4(point, 1.0);
    return glm::dvec3(clip) / clip.w;
}

TEST(PerspectiveView, ReversesDepth) {
    const View view = perspectiveView(glm::dmat4(1.0), 1.0, 1.5, 0.1, 100.0);
    EXPECT_NEAR(projected(view, {0.0, 0.0, -0.1}).z, 1.0, 1e-14);
    EXPECT_NEAR(projected(view, {0.0, 0.0, -100.0}).z, 0.0, 1e-14);
    EXPECT_NEAR(projected(view, {3.0, 1.0, -5.0}).z, 0.1 / 99.9 * (100.0 / 5.0 - 1.0), 1e-14);
    EXPECT_FALSE(view.orthographic);
}

TEST(PerspectiveView, ReachesInfinity) {
    const View view = perspectiveView(glm::dmat4(1.0), 1.0, 1.5, 0.1, infinity);
    EXPECT_NEAR(projected(view, {0.0, 0.0, -0.1}).z, 1.0, 1e-14);
    EXPECT_NEAR(projected(view, {0.0, 0.0, -1e6}).z, 1e-7, 1e-20);
    EXPECT_EQ(view.farPlane, infinity);
}

TEST(PerspectiveView, PutsTheEdgesAtOne) {
    const View view = perspectiveView(glm::dmat4(1.0), 1.0, 1.5, 0.1, 100.0);
    const double top = 7.0 * std::tan(0.5);
    EXPECT_NEAR(projected(view, {0.0, top, -7.0}).y, -1.0, 1e-14) << "Vulkan's y points down";
    EXPECT_NEAR(projected(view, {1.5 * top, 0.0, -7.0}).x, 1.0, 1e-14);
}

TEST(PerspectiveView, KeepsThePose) {
    Random random(1);
    const glm::dmat4 pose = rigidMotion(random, 10.0);
    EXPECT_EQ(perspectiveView(pose, 1.0, 1.5, 0.1, 100.0).worldFromView, pose);
    EXPECT_EQ(orthographicView(pose, 1.0, 1.5, 0.1, 100.0).worldFromView, pose);
}

TEST(OrthographicView, IsLinear) {
    const View view = orthographicView(glm::dmat4(1.0), 4.0, 3.0, 0.5, 10.5);
    EXPECT_TRUE(view.orthographic);
    for (const double share : {0.0, 0.25, 1.0}) {
        const glm::dvec3 at = projected(view, {-2.0, 1.5, -(0.5 + 10.0 * share)});
        EXPECT_NEAR(at.x, -0.5, 1e-15);
        EXPECT_NEAR(at.y, -0.5, 1e-15);
        EXPECT_NEAR(at.z, 1.0 - share, 1e-14);
    }
}

}  // namespace
}  // namespace tyndall
