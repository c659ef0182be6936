// What surfaces need of a light, against random points that a view shows.
#include <gtest/gtest.h>
#include <tyndall/plan.h>

#include <glm/gtc/matrix_transform.hpp>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

SurfaceLight needsOf(const Light& light, const View& view, const Surroundings& surroundings = {}) {
    std::vector<SurfaceLight> needs;
    const Result<void> done = Planner().surfaces(std::span(&light, 1), view, 1024, surroundings, needs);
    EXPECT_TRUE(done) << done.error().message;
    return needs.at(0);
}

Surroundings with(const OccluderSet& occluders) {
    Surroundings known;
    known.occluders = &occluders;
    return known;
}

Surroundings with(const BlockerSet& blockers) {
    Surroundings known;
    known.blockers = &blockers;
    return known;
}

Light shadowed() {
    Light light = projector();
    light.shadow = true;
    return light;
}

OccluderSet cubeAt(const glm::dvec3& centre, double half) {
    OccluderBox box;
    box.minimum = glm::dvec3(-half);
    box.maximum = glm::dvec3(half);
    box.worldFromBox = glm::translate(glm::dmat4(1.0), centre);
    return OccluderSet::fromBoxes(std::span(&box, 1)).value();
}

// Whether the segment meets the cube: the parameters at which it crosses each pair of faces, intersected.
bool meets(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& centre, double half) {
    double first = 0.0, last = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double direction = to[axis] - from[axis];
        const double a = (centre[axis] - half - from[axis]) / direction,
                     b = (centre[axis] + half - from[axis]) / direction;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

TEST(SurfaceLight, KnowsEveryPointThatTheViewShowsAndTheLightReaches) {
    Random random(3);
    int shown = 0, shaded = 0, spared = 0, unlit = 0;
    for (int i = 0; i < 400; ++i) {
        Light light = shadowed();
        light.worldFromLight = rigidMotion(random, 2.0);
        const View view = perspectiveView(rigidMotion(random, 4.0), 40.0 * degrees, 1.5, 0.05, 30.0);
        const glm::dvec3 lamp(light.worldFromLight[3]);
        const glm::dvec3 centre =
            lamp + glm::dmat3(light.worldFromLight) * glm::dvec3(between(random, -1.5, 1.5), 0.0, -2.0);
        const double half = between(random, 0.05, 0.3);
        const OccluderSet occluders = cubeAt(centre, half);
        const SurfaceLight needs = needsOf(light, view, with(occluders));
        unlit += !needs.lit;
        spared += needs.lit && !needs.shadow;
        for (int point = 0; point < 400; ++point) {
            const glm::dvec3 w(between(random, 0.5, 6.0));
            const glm::dvec2 slope = glm::tan(0.5 * light.fov);
            const glm::dvec4 inLight(between(random, -slope.x, slope.x) * w.x, between(random, -slope.y, slope.y) * w.x,
                                     -w.x, 1.0);
            const glm::dvec3 world(light.worldFromLight * inLight);
            const glm::dvec4 clip = view.clipFromView * (glm::inverse(view.worldFromView) * glm::dvec4(world, 1.0));
            if (!(clip.w > 0.05) || std::fabs(clip.x) > clip.w || std::fabs(clip.y) > clip.w || clip.w > 30.0) continue;
            ++shown;
            EXPECT_TRUE(needs.lit);
            if (!meets(lamp + 0.5 / w.x * (world - lamp), world, centre, half)) continue;
            ++shaded;
            EXPECT_TRUE(needs.shadow);
        }
    }
    EXPECT_GT(shown, 5000);
    EXPECT_GT(shaded, 100);
    EXPECT_GT(spared, 20) << "a map is drawn where none is needed";
    EXPECT_GT(unlit, 20) << "a light is drawn that no surface in the view gets";
}

TEST(SurfaceLight, TakesNoNoticeOfTheAir) {
    const View view = wideView(lookingAt({0.0, 0.0, 3.0}, {0.0, 0.0, -3.0}));
    Light light = projector();
    light.density = 0.0;
    EXPECT_TRUE(needsOf(light, view).lit) << "no air that scatters";
    light.density = 1e6;
    light.albedo = 1e-3;
    EXPECT_TRUE(needsOf(light, view).lit) << "air that absorbs everything";
    light.noise.emplace();
    light.noise->gain = 0.0;
    EXPECT_TRUE(needsOf(light, view).lit) << "no dust";
}

TEST(SurfaceLight, IsUnlitWithoutStrength) {
    const View view = wideView(lookingAt({0.0, 0.0, 3.0}, {0.0, 0.0, -3.0}));
    Light black = projector(), off = projector();
    black.colour = glm::dvec3(0.0);
    off.intensity = 0.0;
    EXPECT_FALSE(needsOf(black, view).lit);
    EXPECT_FALSE(needsOf(off, view).lit);
    off.ambient = 1.0;
    EXPECT_TRUE(needsOf(off, view).lit);
}

TEST(SurfaceLight, NeedsAMapWhereOccludersAreUnknownAndTheLightThrowsShadows) {
    const View view = wideView(lookingAt({0.0, 0.0, 3.0}, {0.0, 0.0, -3.0}));
    EXPECT_TRUE(needsOf(shadowed(), view).shadow);
    EXPECT_FALSE(needsOf(projector(), view).shadow);
}

TEST(SurfaceLight, EndsAtTheWallsThatThePlanEndsAt) {
    const View view = wideView(lookingAt({0.0, 0.0, 3.0}, {0.0, 0.0, -3.0}));
    const glm::dvec3 a(-9, -9, -4), b(9, -9, -4), c(9, 9, -4), d(-9, 9, -4);
    const BlockerSet blockers = BlockerSet::fromBlockers({Blocker{{{a, b, c}, {a, c, d}}}}).value();
    const Light light = shadowed();
    const Plan made = plan(std::span(&light, 1), view, {}, with(blockers)).value();
    const SurfaceLight needs = needsOf(light, view, with(blockers));
    ASSERT_EQ(needs.walls.size(), 1u);
    EXPECT_EQ(needs.walls, made.walls);
    EXPECT_TRUE(needsOf(projector(), view, with(blockers)).walls.empty()) << "light without shadow goes through";
}

TEST(SurfaceLight, AnswersBadInputWithAnErrorAndNothingElse) {
    Light light = projector();
    light.farPlane = 0.1;
    std::vector<SurfaceLight> needs(3);
    const Result<void> done = Planner().surfaces(std::span(&light, 1), wideView(glm::dmat4(1.0)), 1024, {}, needs);
    ASSERT_FALSE(done);
    EXPECT_NE(done.error().message.find("farPlane"), std::string::npos) << done.error().message;
    EXPECT_TRUE(needs.empty());
}

}  // namespace
}  // namespace tyndall
