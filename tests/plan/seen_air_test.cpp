// The part of a light's volume that the picture shows, against random points of the volume.
#include "visibility/seen_air.h"

#include <gtest/gtest.h>

#include "numbers.h"
#include "plan_scenes.h"
#include "visibility/light_volume.h"

namespace tyndall {
namespace {

using namespace test;

struct Shot {
    Light light;
    View view;
    DepthTiles tiles;
    std::vector<float> depths;
    LightPose pose;
    SeenAir air;
};

// A nearby projector seen at any angle, and depths from just before it to infinity.
Shot randomShot(Random& random, bool withTiles) {
    Shot shot;
    shot.light = projector();
    const glm::dmat4 worldFromView = rigidMotion(random, 50.0);
    const double aspect = between(random, 0.5, 2.0);
    shot.view = random() % 4 == 0 ? orthographicView(worldFromView, 2.0 * aspect, 2.0, 0.1, 30.0)
                                  : perspectiveView(worldFromView, between(random, 0.3, 2.0), aspect, 0.1,
                                                    random() % 2 ? between(random, 3.0, 10.0) : infinity);
    if (random() % 4 == 0 && !shot.view.orthographic) {  // a shifted lens
        shot.view.clipFromView[2][0] += 0.4;
        shot.view.clipFromView[2][1] -= 0.3;
    }
    glm::dmat4 viewFromLight = rigidMotion(random, 3.0);
    viewFromLight[3].z -= 4.0;
    shot.light.worldFromLight = worldFromView * viewFromLight;
    if (random() % 2) shot.light.clipPlanes = {glm::dvec4(glm::normalize(inCube(random, 1.0)), 0.0)};
    if (!shot.light.clipPlanes.empty()) {
        const glm::dvec3 through(shot.light.worldFromLight * glm::dvec4(0.0, 0.0, -3.0, 1.0));
        shot.light.clipPlanes[0].w = -glm::dot(glm::dvec3(shot.light.clipPlanes[0]), through);
    }
    shot.tiles.columns = static_cast<std::uint32_t>(1 + random() % 7);
    shot.tiles.rows = static_cast<std::uint32_t>(1 + random() % 5);
    for (std::uint32_t i = 0; i < shot.tiles.columns * shot.tiles.rows; ++i)
        shot.depths.push_back(random() % 3 == 0 ? INFINITY : static_cast<float>(between(random, 0.0, 8.0)));
    shot.tiles.farthest = shot.depths;

    shot.pose = lightPose(shot.light.worldFromLight, shot.view.worldFromView);
    ConvexPolyhedron seen;
    const LightVolume volume = lightVolume(shot.light, shot.view, shot.pose, {}, {}, seen);
    if (volume.hidden == Verdict::Drawn)
        shot.air = seenAir(seen, shapeOf(shot.light), shot.view, shot.pose,
                           withTiles ? std::optional(shot.tiles) : std::nullopt);
    return shot;
}

glm::dvec3 pointInPyramid(Random& random, const Light& light) {
    const double axis = std::cbrt(between(random, std::pow(light.nearPlane, 3.0), std::pow(light.farPlane, 3.0)));
    const glm::dvec2 slope = glm::tan(0.5 * light.fov);
    return axis * glm::dvec3(between(random, -slope.x, slope.x), between(random, -slope.y, slope.y), -1.0);
}

bool shown(const Shot& shot, const glm::dvec3& p, bool withTiles) {
    const View& view = shot.view;
    if (-p.z < view.nearPlane || -p.z > std::min(view.farPlane, view.sceneDepth)) return false;
    const glm::dvec4 clip = view.clipFromView * glm::dvec4(p, 1.0);
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
    if (std::fabs(ndc.x) > 1.0 || std::fabs(ndc.y) > 1.0) return false;
    if (insideBy(shot.light, view, p) < 0.0) return false;
    if (!withTiles) return true;
    const auto tile = [](double x, std::uint32_t count) {
        return std::min(static_cast<std::uint32_t>(0.5 * (x + 1.0) * count), count - 1);
    };
    const std::size_t place = tile(ndc.y, shot.tiles.rows) * shot.tiles.columns + tile(ndc.x, shot.tiles.columns);
    return -p.z <= shot.depths[place];
}

TEST(SeenAir, HoldsEveryPointThatAPixelShows) {
    Random random(1);
    int shownPoints = 0, hidden = 0;
    for (int trial = 0; trial < 600; ++trial) {
        const bool withTiles = trial % 3 != 0;
        const Shot shot = randomShot(random, withTiles);
        const SeenAir& air = shot.air;
        hidden += !air.any;
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 light = pointInPyramid(random, shot.light);
            const glm::dvec3 p(shot.pose.viewFromLight * glm::dvec4(light, 1.0));
            if (!shown(shot, p, withTiles)) continue;
            ++shownPoints;
            ASSERT_TRUE(air.any) << trial;
            constexpr double eps = 1e-9;
            EXPECT_GE(-p.z, air.nearDepth - eps) << trial;
            EXPECT_LE(-p.z, air.farDepth + eps) << trial;
            EXPECT_GE(-light.z, air.axisNear - eps) << trial;
            EXPECT_LE(-light.z, air.axisFar + eps) << trial;
            const glm::dvec2 slide = glm::dvec2(light) / -light.z;
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(slide, air.slopes.min - eps))) << trial;
            EXPECT_TRUE(glm::all(glm::lessThanEqual(slide, air.slopes.max + eps))) << trial;
        }
    }
    EXPECT_GT(shownPoints, 10000);
    EXPECT_GT(hidden, 20) << "some see nothing";
}

// The maximum distance of two points that one ray shows.
TEST(SeenAir, NoRayRunsFartherThroughIt) {
    Random random(2);
    int rays = 0;
    double closest = 0.0;
    for (int trial = 0; trial < 300; ++trial) {
        const bool withTiles = trial % 2;
        const Shot shot = randomShot(random, withTiles);
        if (!shot.air.any) continue;
        for (int i = 0; i < 40; ++i) {
            const glm::dvec3 start(shot.pose.viewFromLight * glm::dvec4(pointInPyramid(random, shot.light), 1.0));
            if (!shown(shot, start, withTiles)) continue;
            double first = infinity, last = -infinity;
            const double far = std::min(shot.view.farPlane, 40.0);
            for (int k = 0; k <= 400; ++k) {
                const double depth = shot.view.nearPlane + (far - shot.view.nearPlane) * k / 400.0;
                const glm::dvec3 p =
                    shot.view.orthographic ? glm::dvec3(start.x, start.y, -depth) : start * (depth / -start.z);
                if (!shown(shot, p, withTiles)) continue;
                const double along = shot.view.orthographic ? depth : glm::length(p);
                first = std::min(first, along);
                last = std::max(last, along);
            }
            if (!(last > first)) continue;
            ++rays;
            EXPECT_LE(last - first, shot.air.maxLength * (1.0 + 1e-9)) << trial;
            closest = std::max(closest, (last - first) / shot.air.maxLength);
        }
    }
    EXPECT_GT(rays, 1000);
    EXPECT_GT(closest, 0.8) << "the bound is met somewhere";
}

TEST(SeenAir, IsNoLargerThanWhatTheTilesLeave) {
    // A projector that shines to the right, 5 m before the eye; the picture's left half ends at 4.9 m, so only what
    // lies right of the middle is seen, 3 m and more from the lamp.
    Light light = projector();
    light.worldFromLight = lookingAt({-3.0, 0.0, -5.0}, {0.0, 0.0, -5.0});
    const View view = perspectiveView(glm::dmat4(1.0), 1.5, 1.0, 0.1, infinity);
    const LightPose pose = lightPose(light.worldFromLight, view.worldFromView);
    ConvexPolyhedron seen;
    ASSERT_EQ(lightVolume(light, view, pose, {}, {}, seen).hidden, Verdict::Drawn);
    const auto air = [&](float left, float right) {
        const float depths[] = {left, right};
        return seenAir(seen, shapeOf(light), view, pose, DepthTiles{2, 1, depths});
    };
    EXPECT_NEAR(air(2.0f, INFINITY).axisNear, 3.0, 1e-3);
    EXPECT_NEAR(air(2.0f, INFINITY).axisFar, 6.0, 1e-3);
    EXPECT_NEAR(air(INFINITY, 2.0f).axisFar, 3.0, 1e-3);
    EXPECT_NEAR(air(5.0f, 5.0f).farDepth, 5.0, 1e-3);
    EXPECT_FALSE(air(2.0f, 2.0f).any);
    EXPECT_NEAR(air(INFINITY, INFINITY).axisNear, 0.5, 1e-3);
}

}  // namespace
}  // namespace tyndall
