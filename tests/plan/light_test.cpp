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

}  // namespace
}  // namespace tyndall
