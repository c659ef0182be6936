// A set of occluders: its boxes hold all triangles, its spheres all boxes, before and after instances move.
#include <gtest/gtest.h>
#include <tyndall/occluder_set.h>

#include <optional>

#include "allocations.h"
#include "numbers.h"
#include "survey_scenes.h"

namespace tyndall {
namespace {

using namespace test;

glm::dvec3 inWorld(const OccluderBox& box, const glm::dvec3& p) {
    return glm::dvec3(box.worldFromBox * glm::dvec4(p, 1.0));
}

// Every triangle once, in a box of its instance that holds it.
void expectHoldsAllTriangles(const OccluderSet& set, const SurveyScene& scene) {
    std::size_t index = 0;
    for (const MeshInstance& instance : scene.instances) {
        std::multiset<std::array<float, 9>> expected, held;
        for (const auto& triangle : scene.trianglesOf(instance.mesh)) expected.insert(numbersOf(triangle));
        std::size_t boxes = 0;
        for (; held.size() < expected.size() && index < set.size(); ++index, ++boxes) {
            const OccluderBox box = set.box(index);
            EXPECT_EQ(box.worldFromBox, instance.worldFromMesh);
            EXPECT_FALSE(box.triangles.empty());
            for (const auto& triangle : box.triangles) {
                held.insert(numbersOf(triangle));
                for (const glm::vec3& corner : triangle) {
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(box.minimum, glm::dvec3(corner))));
                    EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::dvec3(corner), box.maximum)));
                }
            }
        }
        EXPECT_EQ(held, expected);
        EXPECT_LE(boxes, 64u);
    }
    EXPECT_EQ(index, set.size());
}

void expectSpheresHoldBoxes(const OccluderSet& set) {
    ASSERT_EQ(set.spheres().size(), set.size());
    for (std::size_t i = 0; i < set.size(); ++i) {
        const OccluderBox box = set.box(i);
        const BoundingSphere& sphere = set.spheres()[i];
        double farthest = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::bvec3 high((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
            farthest = std::max(farthest,
                                glm::distance(sphere.centre, inWorld(box, glm::mix(box.minimum, box.maximum, high))));
        }
        EXPECT_LE(farthest, sphere.radius) << i;
        EXPECT_LE(sphere.radius, farthest * (1.0 + 1e-5) + 1e-4) << i << ": no larger than needed";
    }
}

void expectEqual(const OccluderSet& a, const OccluderSet& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a.spheres()[i].centre, b.spheres()[i].centre) << i;
        EXPECT_EQ(a.spheres()[i].radius, b.spheres()[i].radius) << i;
        EXPECT_EQ(a.box(i).worldFromBox, b.box(i).worldFromBox) << i;
    }
}

TEST(OccluderSet, HoldsAllTrianglesOfAllInstances) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const SurveyScene scene = randomSurveyScene(seed);
        const Result<OccluderSet> set = OccluderSet::fromMeshes(scene.triangles(), scene.instances);
        ASSERT_TRUE(set) << set.error().message;
        EXPECT_EQ(set->instances(), scene.instances.size());
        expectHoldsAllTriangles(*set, scene);
        expectSpheresHoldBoxes(*set);
    }
}

// A lamp post with its arm is two sticks at a right angle: the space between them is in no box.
TEST(OccluderSet, HasBoxesThatFollowAMeshsShape) {
    SurveyScene scene;
    scene.meshes.emplace_back();
    for (int i = 0; i < 100; ++i) {
        const float at = 0.05f * static_cast<float>(i), next = 0.05f * static_cast<float>(i + 1);
        scene.meshes[0].addTriangle({0.0f, at, 0.0f}, {0.1f, at, 0.0f}, {0.0f, next, 0.1f});
        scene.meshes[0].addTriangle({at, 5.0f, 0.0f}, {next, 5.1f, 0.0f}, {at, 5.0f, 0.1f});
    }
    scene.instances = {{0, glm::dmat4(1.0)}};
    const OccluderSet set = OccluderSet::fromMeshes(scene.triangles(), scene.instances).value();
    expectHoldsAllTriangles(set, scene);
    const glm::dvec3 lamp(4.0, 1.0, 0.0);
    for (std::size_t i = 0; i < set.size(); ++i)
        EXPECT_FALSE(glm::all(glm::lessThan(set.box(i).minimum, lamp)) &&
                     glm::all(glm::lessThan(lamp, set.box(i).maximum)));
}

TEST(OccluderSet, BoundsWhatHasMovedAndNothingElse) {
    SurveyScene scene = randomSurveyScene(3);
    OccluderSet set = OccluderSet::fromMeshes(scene.triangles(), scene.instances).value();
    const OccluderSet before = set;
    Random random(4);
    for (std::size_t moving = 0; moving < scene.instances.size(); moving += 2) {
        const glm::dmat4 there = rigidMotion(random, 50.0);
        scene.instances[moving].worldFromMesh = there;
        const std::size_t allocated = allocations();
        const Result<bool> moved = set.move(moving, there);
        EXPECT_EQ(allocations(), allocated);
        ASSERT_TRUE(moved && *moved);
        EXPECT_FALSE(set.move(moving, there).value()) << "stands there already";
    }
    expectEqual(set, OccluderSet::fromMeshes(scene.triangles(), scene.instances).value());
    expectHoldsAllTriangles(set, scene);
    expectSpheresHoldBoxes(set);
    std::size_t changed = 0;
    for (std::size_t i = 0; i < set.size(); ++i) changed += set.spheres()[i].centre != before.spheres()[i].centre;
    EXPECT_GT(changed, 0u);
    EXPECT_LT(changed, set.size()) << "every second instance stays";
}

TEST(OccluderSet, TakesBoxesOfTheCallersOwn) {
    Random random(5);
    std::vector<std::array<glm::vec3, 3>> triangles{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    std::vector<OccluderBox> boxes;
    for (int i = 0; i < 10; ++i) {
        OccluderBox& box = boxes.emplace_back();
        box.worldFromBox = rigidMotion(random, 10.0);
        box.worldFromBox[1] += 0.5 * box.worldFromBox[0];  // sheared
        box.maximum = glm::dvec3(1.0, 1.0, i % 2 ? 0.0 : 2.0);
        if (i % 3 == 0) box.triangles = triangles;
    }
    OccluderSet set = OccluderSet::fromBoxes(boxes).value();
    triangles.clear();  // the set has its own
    ASSERT_EQ(set.size(), 10u);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_EQ(set.box(i).worldFromBox, boxes[i].worldFromBox);
        EXPECT_EQ(set.box(i).maximum, boxes[i].maximum);
        EXPECT_EQ(set.box(i).triangles.size(), i % 3 == 0 ? 1u : 0u);
    }
    EXPECT_EQ(set.box(0).triangles[0][1], glm::vec3(1, 0, 0));
    expectSpheresHoldBoxes(set);
    EXPECT_TRUE(set.move(7, glm::dmat4(1.0)).value());
    EXPECT_EQ(set.box(7).worldFromBox, glm::dmat4(1.0));
    expectSpheresHoldBoxes(set);
}

// A set can be copied and moved about: nothing in it points into the set that it came from.
TEST(OccluderSet, IsAValue) {
    const SurveyScene scene = randomSurveyScene(6);
    std::optional<OccluderSet> first = OccluderSet::fromMeshes(scene.triangles(), scene.instances).value();
    const OccluderSet copy = *first;
    first.reset();
    expectHoldsAllTriangles(copy, scene);
}

TEST(OccluderSet, RefusesMeshesThatMakeNoSense) {
    expectMeshesRefused(OccluderSet::fromMeshes, "occluder set: ");
}

void expectRefused(void (*change)(OccluderBox&), const std::string& words) {
    std::vector<std::array<glm::vec3, 3>> triangles(1);
    triangles[0][2].y = std::numeric_limits<float>::quiet_NaN();
    std::vector<OccluderBox> boxes(2);
    boxes[1].maximum = glm::dvec3(1.0);
    EXPECT_TRUE(OccluderSet::fromBoxes(boxes)) << "without a change";
    change(boxes[1]);
    if (words.find("triangle") != std::string::npos) boxes[1].triangles = triangles;
    const Result<OccluderSet> set = OccluderSet::fromBoxes(boxes);
    ASSERT_FALSE(set) << words;
    EXPECT_EQ(set.error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(set.error().place, "occluder set");
    EXPECT_EQ(set.error().message.find("occluder set: box 1 has " + words), 0u) << set.error().message;
}

TEST(OccluderSet, RefusesBoxesThatAreNone) {
    expectRefused([](OccluderBox& b) { b.minimum.y = nan; }, "the corner");
    expectRefused([](OccluderBox& b) { b.maximum.z = infinity; }, "the corner");
    expectRefused([](OccluderBox& b) { b.minimum.x = 2.0; }, "the corner");
    expectRefused([](OccluderBox& b) { b.worldFromBox[3].x = nan; }, "a worldFromBox");
    expectRefused([](OccluderBox& b) { b.worldFromBox[1].w = 1.0; }, "a worldFromBox");
    expectRefused([](OccluderBox&) {}, "a triangle with a corner at (0, nan, 0): it must lie between (0, 0, 0) and");
}

TEST(OccluderSet, RefusesToMoveWhatItHasNotOrNowhere) {
    const SurveyScene scene = randomSurveyScene(7);
    OccluderSet set = OccluderSet::fromMeshes(scene.triangles(), scene.instances).value();
    const OccluderSet before = set;
    const Result<bool> none = set.move(set.instances(), glm::dmat4(1.0));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("is to move"), std::string::npos);
    glm::dmat4 nowhere(1.0);
    nowhere[3].y = nan;
    const Result<bool> lost = set.move(1, nowhere);
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().message.find("occluder set: instance 1 has a worldFromMesh that is not affine"), 0u);
    expectEqual(set, before);
}

}  // namespace
}  // namespace tyndall
