#include "visibility/light_volume.h"

#include <gtest/gtest.h>

#include "geometry/convex_polyhedron.h"
#include "numbers.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

ConvexPolyhedron cube() {
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) corners[i] = {(i & 1) ? 1.0 : -1.0, (i & 2) ? 1.0 : -1.0, (i & 4) ? 1.0 : -1.0};
    return hexahedron(corners);
}

TEST(ConvexPolyhedron, KeepsEulersFormula) {
    Random random(1);
    for (int trial = 0; trial < 100; ++trial) {
        ConvexPolyhedron solid = cube();
        EXPECT_EQ(solid.edges.size(), 12u);
        std::vector<glm::dvec4> planes;
        for (int i = 0; i < 10; ++i) {
            planes.push_back({glm::normalize(inCube(random, 1.0)), between(random, 0.1, 1.5)});
            ASSERT_TRUE(cut(solid, planes.back(), 1e-12));
            // A face that a plane removed has no edges.
            std::vector<int> sides(solid.faces, 0);
            for (const auto& edge : solid.edges)
                for (const auto face : edge.faces) ++sides[face];
            const auto faces = static_cast<int>(std::count_if(sides.begin(), sides.end(), [](int n) { return n > 0; }));
            for (const int n : sides) EXPECT_TRUE(n == 0 || n >= 3);
            EXPECT_EQ(static_cast<int>(solid.vertices.size()) - static_cast<int>(solid.edges.size()) + faces, 2);
        }
        for (const glm::dvec3& p : solid.vertices)
            for (const glm::dvec4& plane : planes) EXPECT_GE(glm::dot(plane, glm::dvec4(p, 1.0)), -1e-14);
    }
}

TEST(ConvexPolyhedron, GivesWayOnlyToPlanesThatLeaveSomething) {
    ConvexPolyhedron solid = cube();
    EXPECT_FALSE(cut(solid, {1.0, 0.0, 0.0, -1.0}, 1e-9)) << "touches";
    EXPECT_FALSE(cut(solid, {1.0, 0.0, 0.0, -1.0 + 1e-10}, 1e-9)) << "touches, but for rounding";
    EXPECT_FALSE(cut(solid, {1.0, 0.0, 0.0, -2.0}, 1e-9)) << "misses";
    EXPECT_EQ(solid.vertices.size(), 8u);
    EXPECT_TRUE(cut(solid, {1.0, 0.0, 0.0, 2.0}, 1e-9)) << "holds all of it";
    EXPECT_EQ(solid.faces, 6u);
    EXPECT_TRUE(cut(solid, {1.0, 0.0, 0.0, 0.0}, 1e-9));
    EXPECT_EQ(solid.vertices.size(), 8u);
    EXPECT_EQ(solid.edges.size(), 12u);
}

LightVolume volumeOf(const Light& light, const View& view) {
    ConvexPolyhedron seen;
    return lightVolume(light, view, lightPose(light.worldFromLight, view.worldFromView), {}, {}, seen);
}

Light lampAt(const glm::dvec3& position, const glm::dvec3& direction) {
    Light light = projector();
    const glm::dvec3 up = std::fabs(direction.y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    light.worldFromLight = lookingAt(position, position + direction, up);
    return light;
}

TEST(LightVolume, SpansNearToFarAlongTheView) {
    const LightVolume volume = volumeOf(lampAt({0, 0, -2}, {0, 0, -1}), wideView(glm::dmat4(1.0)));
    EXPECT_EQ(volume.hidden, Verdict::Drawn);
    EXPECT_NEAR(volume.nearDepth, 2.5, 1e-14);
    EXPECT_NEAR(volume.farShown, 8.0, 1e-14);
    EXPECT_NEAR(volume.boundsMax.x, 6.0 * std::tan(20.0 * degrees), 1e-14);
    EXPECT_NEAR(volume.boundsMin.y, -6.0 * std::tan(12.0 * degrees), 1e-14);
}

TEST(LightVolume, StartsAtTheNearPlaneWithTheEyeInside) {
    View view = wideView(glm::dmat4(1.0));
    for (const glm::dvec3 direction :
         {glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        const LightVolume volume = volumeOf(lampAt(-3.0 * direction, direction), view);
        EXPECT_EQ(volume.hidden, Verdict::Drawn);
        EXPECT_NEAR(volume.nearDepth, view.nearPlane, 1e-14);
    }
    // Looking back along the beam, the seen part ends at the beam's start.
    EXPECT_NEAR(volumeOf(lampAt({0, 0, -3}, {0, 0, 1}), view).farShown, 2.5, 1e-14);
}

TEST(LightVolume, EndsAtTheFarPlaneAndAtTheScene) {
    const Light light = lampAt({0, 0, -2}, {0, 0, -1});
    View view = wideView(glm::dmat4(1.0));
    view.farPlane = 7.0;
    EXPECT_NEAR(volumeOf(light, view).farShown, 7.0, 1e-14);
    view.sceneDepth = 5.0;
    EXPECT_NEAR(volumeOf(light, view).farShown, 5.0, 1e-14);
}

TEST(LightVolume, IsCutByClipPlanes) {
    Light light = lampAt({0, 0, -2}, {0, 0, -1});
    light.clipPlanes = {{0.0, 0.0, 2.0, 10.0}};  // keeps z >= -5
    const LightVolume volume = volumeOf(light, wideView(glm::dmat4(1.0)));
    EXPECT_NEAR(volume.farShown, 5.0, 1e-14);
    ASSERT_EQ(volume.clipPlanes.size(), 1u);
    EXPECT_NEAR(volume.clipPlanes[0].w, 5.0, 1e-14) << "unit normal";
    EXPECT_EQ(boundingPlanes(volume).size(), 7u);
}

struct HiddenCase {
    const char* name;
    Light light;
    View view;
    Verdict hidden;
};

std::vector<HiddenCase> hiddenCases() {
    const View view = perspectiveView(glm::dmat4(1.0), 60.0 * degrees, 1.0, 0.1, 100.0);
    const auto with = [&](double nearPlane, double farPlane, double sceneDepth) {
        View changed = view;
        changed.nearPlane = nearPlane;
        changed.farPlane = farPlane;
        changed.sceneDepth = sceneDepth;
        return changed;
    };
    Light cutAway = lampAt({0, 0, -2}, {0, 0, -1});
    cutAway.clipPlanes = {{0.0, 1.0, 0.0, 0.0}, {0.0, -1.0, 0.0, -0.5}};
    Light grazed = lampAt({0, 0, -2}, {0, 0, -1});
    grazed.clipPlanes = {{0.0, 0.0, 1.0, 2.5}};  // the pyramid's own near side
    const Light ahead = lampAt({0, 0, -2}, {0, 0, -1});
    const Light backwards = lampAt({0, 0, 2}, {0, 0, 1});
    return {
        {"before the eye", ahead, view, Verdict::Drawn},
        {"behind, looking away", backwards, view, Verdict::BehindEye},
        {"behind, across", lampAt({-3, 0, 8}, {1, 0, 0}), view, Verdict::BehindEye},
        {"behind, ending at the eye's plane", lampAt({0, 0, 6}, {0, 0, -1}), view, Verdict::BehindEye},
        {"ending just before the near plane", lampAt({0, 0, 5.95}, {0, 0, -1}), view, Verdict::BeforeNear},
        {"ending just beyond the near plane", lampAt({0, 0, 5.8}, {0, 0, -1}), view, Verdict::Drawn},
        {"beyond far", ahead, with(0.1, 2.4, 1e300), Verdict::BeyondFar},
        {"touching far", ahead, with(0.1, 2.5, 1e300), Verdict::BeyondFar},
        {"reaching into far", ahead, with(0.1, 2.6, 1e300), Verdict::Drawn},
        {"behind the wall", ahead, with(0.1, infinity, 2.4), Verdict::BehindScene},
        {"wall before the near plane", ahead, with(0.1, infinity, 0.05), Verdict::BehindScene},
        {"cut away by two planes", cutAway, view, Verdict::ClipPlanes},
        {"touched by its clip plane", grazed, view, Verdict::ClipPlanes},
        {"left of the picture", lampAt({-20, 0, -5}, {0, 0, -1}), view, Verdict::BesideView},
        {"below the picture", lampAt({0, -20, -5}, {0, 0, -1}), view, Verdict::BesideView},
        {"shining into the picture from the left", lampAt({-8, 0, -5}, {1, 0, 0}), view, Verdict::Drawn},
        // None of its corners is in the picture, and no corner of the picture lies in it.
        {"across the picture", lampAt({-4, 0, -2.5}, {1, 0, 0}), view, Verdict::Drawn},
        {"around the eye", lampAt({0, 0, 3}, {0, 0, -1}), view, Verdict::Drawn},
    };
}

TEST(LightVolume, SaysWhatHidesIt) {
    for (const HiddenCase& c : hiddenCases()) {
        const LightVolume volume = volumeOf(c.light, c.view);
        EXPECT_EQ(volume.hidden, c.hidden) << c.name;
        if (c.hidden == Verdict::Drawn) {
            EXPECT_LT(volume.nearDepth, volume.farShown) << c.name;
        }
    }
}

// The same planes cut the solid, but its rounding must not change the slabs' depths.
TEST(LightVolume, KeepsExactlyToTheViewsDepths) {
    Random random(3);
    View view = perspectiveView(glm::dmat4(1.0), 60.0 * degrees, 1.5, 0.3, 7.3);
    int cutNear = 0, cutFar = 0, cutByScene = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        Light light = projector();
        light.worldFromLight = rigidMotion(random, 6.0);
        view.sceneDepth = trial % 2 ? 1.0e300 : 5.1;
        const LightVolume volume = volumeOf(light, view);
        if (volume.hidden != Verdict::Drawn) continue;
        EXPECT_GE(volume.nearDepth, view.nearPlane);
        EXPECT_LE(volume.farShown, std::min(view.farPlane, view.sceneDepth));
        cutNear += volume.nearDepth == view.nearPlane;
        cutFar += volume.farShown == view.farPlane;
        cutByScene += volume.farShown == view.sceneDepth;
    }
    EXPECT_GT(std::min({cutNear, cutFar, cutByScene}), 20);
}

// A light that the planner leaves out must not have a visible point.
TEST(LightVolume, HidesNothingThatShows) {
    Random random(2);
    const View view = perspectiveView(glm::dmat4(1.0), 60.0 * degrees, 1.5, 0.1, 30.0);
    int hidden = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        Light light = projector();
        light.worldFromLight = rigidMotion(random, 10.0);
        const LightVolume volume = volumeOf(light, view);
        if (volume.hidden == Verdict::Drawn) continue;
        ++hidden;
        for (int sample = 0; sample < 50; ++sample) {
            const double axis = between(random, light.nearPlane, light.farPlane);
            const glm::dvec2 slide(between(random, -1.0, 1.0), between(random, -1.0, 1.0));
            const glm::dvec4 point(axis * slide * glm::tan(0.5 * light.fov), -axis, 1.0);
            const glm::dvec4 clip = view.clipFromView * (light.worldFromLight * point);
            const bool shows =
                clip.w > 0.1 && clip.w < 30.0 && std::fabs(clip.x) < clip.w && std::fabs(clip.y) < clip.w;
            EXPECT_FALSE(shows);
        }
    }
    EXPECT_GT(hidden, 200);
    EXPECT_LT(hidden, 1800);
}

// Planes of pyramid and view that coincide, exactly or up to rounding.
TEST(LightVolume, StandsDegeneratePoses) {
    const View view = perspectiveView(glm::dmat4(1.0), 40.0 * degrees, 1.0, 0.5, 6.0);
    Light light = projector();
    light.fov = {40.0 * degrees, 40.0 * degrees};  // the same frustum as the view
    EXPECT_EQ(volumeOf(light, view).hidden, Verdict::Drawn);
    EXPECT_NEAR(volumeOf(light, view).farShown, 6.0, 1e-14);
    for (int turn = -50; turn <= 50; ++turn) {
        light.worldFromLight = pose(glm::angleAxis(turn * 1e-17 + turn * 1e-15, glm::dvec3(0.6, 0.8, 0.0)), {0, 0, 0});
        const LightVolume volume = volumeOf(light, view);
        EXPECT_EQ(volume.hidden, Verdict::Drawn);
        EXPECT_NEAR(volume.nearDepth, 0.5, 1e-12);
        EXPECT_NEAR(volume.farShown, 6.0, 1e-12);
    }
}

}  // namespace
}  // namespace tyndall
