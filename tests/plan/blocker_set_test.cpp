// A set of blockers: the largest planes of a scene, with all of their triangles and bounds that hold them.
#include <gtest/gtest.h>
#include <tyndall/blocker_set.h>

#include "survey_scenes.h"

namespace tyndall {
namespace {

using namespace test;

// By the definition of BlockerBounds.
void expectBounded(const BlockerSet& set) {
    ASSERT_EQ(set.bounds().size(), set.blockers().size());
    for (std::size_t i = 0; i < set.blockers().size(); ++i) {
        const BlockerBounds& bounds = set.bounds()[i];
        EXPECT_NEAR(glm::length(glm::dvec3(bounds.plane)), 1.0, 1e-12);
        double area = 0.0, farthest = 0.0;
        for (const std::array<glm::dvec3, 3>& t : set.blockers()[i].triangles) {
            area += 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
            for (const glm::dvec3& corner : t) {
                farthest = std::max(farthest, glm::distance(corner, bounds.centre));
                EXPECT_LE(std::fabs(glm::dot(bounds.plane, glm::dvec4(corner, 1.0))), 5e-4) << i;
            }
        }
        EXPECT_NEAR(bounds.area, area, 1e-9 * area);
        EXPECT_DOUBLE_EQ(bounds.radius, farthest);
    }
}

bool sameBlockers(const BlockerSet& a, const BlockerSet& b) {
    return std::ranges::equal(a.blockers(), b.blockers(), {}, &Blocker::triangles, &Blocker::triangles);
}

// Mesh 0: a floor tile of 4 x 4 m. Mesh 1: a wall of 3 x 2 m. Mesh 2: a crumb. Four tiles in one plane.
SurveyScene tiledRoom() {
    SurveyScene scene;
    scene.meshes.resize(3);
    scene.meshes[0].addRectangle({0, 0, 0}, {0, 0, 4}, {4, 0, 0});
    scene.meshes[1].addRectangle({0, 0, 0}, {3, 0, 0}, {0, 2, 0});
    scene.meshes[2].addTriangle({0, 0, 0}, {0.1f, 0, 0}, {0, 0, 0.1f});
    const auto at = [](double x, double y, double z) {
        glm::dmat4 matrix(1.0);
        matrix[3] = {x, y, z, 1.0};
        return matrix;
    };
    scene.instances = {{0, at(0, 0, 0)}, {1, at(1, 0, 2)},      {0, at(4, 0, 0)},
                       {2, at(1, 1, 1)}, {0, at(0, 0.0001, 4)}, {0, at(4, 0, 4)}};
    return scene;
}

TEST(BlockerSet, CollectsATilesPlaneOverAllInstances) {
    const SurveyScene scene = tiledRoom();
    const BlockerSet set = BlockerSet::fromMeshes(scene.triangles(), scene.instances).value();
    ASSERT_EQ(set.blockers().size(), 2u) << "the crumb has a thousandth of no area";
    EXPECT_EQ(set.blockers()[0].triangles.size(), 8u);
    EXPECT_NEAR(set.bounds()[0].area, 64.0, 1e-9);
    EXPECT_NEAR(std::fabs(set.bounds()[0].plane.y), 1.0, 1e-12);
    EXPECT_EQ(set.blockers()[1].triangles.size(), 2u);
    EXPECT_NEAR(set.bounds()[1].area, 6.0, 1e-9);
    expectBounded(set);
}

TEST(BlockerSet, KeepsTheLargestPlanes) {
    SurveyScene scene;
    scene.meshes.resize(1);
    for (int i = 0; i < 100; ++i) {
        const float side = 1.0f + 0.01f * static_cast<float>((37 * i) % 100);  // in no order
        scene.meshes[0].addRectangle({0, static_cast<float>(i), 0}, {side, 0, 0}, {0, 0, side});
    }
    scene.instances = {{0, glm::dmat4(1.0)}};
    const BlockerSet set = BlockerSet::fromMeshes(scene.triangles(), scene.instances).value();
    ASSERT_EQ(set.blockers().size(), 64u);
    for (std::size_t i = 0; i < 64; ++i) {
        const double side = 1.0 + 0.01 * static_cast<double>(99 - i);
        EXPECT_NEAR(set.bounds()[i].area, side * side, 1e-5) << i;
    }
    expectBounded(set);
}

TEST(BlockerSet, BoundsWhatItFindsInAnyScene) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const SurveyScene scene = randomSurveyScene(seed);
        const BlockerSet set = BlockerSet::fromMeshes(scene.triangles(), scene.instances).value();
        EXPECT_GT(set.blockers().size(), 10u);
        expectBounded(set);
    }
}

TEST(BlockerSet, FindsBlockersAgainWhereAnInstanceHasMoved) {
    SurveyScene scene = tiledRoom();
    BlockerSet set = BlockerSet::fromMeshes(scene.triangles(), scene.instances).value();
    const BlockerSet before = set;
    EXPECT_FALSE(set.update(scene.triangles(), scene.instances).value());
    EXPECT_TRUE(sameBlockers(set, before));
    scene.instances[2].worldFromMesh[3].y = 1.0;  // a tile leaves the floor
    EXPECT_TRUE(set.update(scene.triangles(), scene.instances).value());
    EXPECT_TRUE(sameBlockers(set, BlockerSet::fromMeshes(scene.triangles(), scene.instances).value()));
    ASSERT_EQ(set.blockers().size(), 3u);
    EXPECT_EQ(set.blockers()[0].triangles.size(), 6u);
    expectBounded(set);
    scene.instances.pop_back();
    EXPECT_TRUE(set.update(scene.triangles(), scene.instances).value());
    EXPECT_EQ(set.blockers()[0].triangles.size(), 4u);
    EXPECT_FALSE(set.update(scene.triangles(), scene.instances).value());

    const BlockerSet moved = set;
    scene.instances[0].worldFromMesh[3].x = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(set.update(scene.triangles(), scene.instances));
    EXPECT_TRUE(sameBlockers(set, moved)) << "unchanged by what is refused";
}

TEST(BlockerSet, TakesBlockersOfTheCallersOwn) {
    const Blocker wall{{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {9, 0, 0}, {1, 5, 0}}}}};
    const BlockerSet set = BlockerSet::fromBlockers({wall, Blocker{}}).value();
    ASSERT_EQ(set.bounds().size(), 2u);
    EXPECT_DOUBLE_EQ(set.bounds()[0].area, 20.5);
    EXPECT_EQ(set.bounds()[0].centre, glm::dvec3(1, 0, 0)) << "a corner of the largest triangle";
    EXPECT_DOUBLE_EQ(set.bounds()[0].radius, 8.0);
    EXPECT_EQ(set.bounds()[1].area, 0.0);
    EXPECT_EQ(set.bounds()[1].plane, glm::dvec4(0.0)) << "without any area";
}

TEST(BlockerSet, RefusesMeshesThatMakeNoSense) {
    expectMeshesRefused(BlockerSet::fromMeshes, "blocker set: ");
}

TEST(BlockerSet, RefusesCornersThatAreNotFinite) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Blocker wall{{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}};
        wall.triangles[0][2].z = bad;
        const Result<BlockerSet> set = BlockerSet::fromBlockers({Blocker{}, wall});
        ASSERT_FALSE(set);
        EXPECT_EQ(set.error().code, ErrorCode::InvalidArgument);
        EXPECT_EQ(set.error().message.find("blocker set: blocker 1 has a corner at (0, 1, "), 0u);
    }
}

TEST(BlockerSet, RefusesWhatIsNotFlat) {
    Blocker wall{{{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 4e-4}}}}};
    EXPECT_TRUE(BlockerSet::fromBlockers({wall}));
    wall.triangles[1][2].z = 0.001;
    const Result<BlockerSet> set = BlockerSet::fromBlockers({wall});
    ASSERT_FALSE(set);
    EXPECT_NE(set.error().message.find("blocker 0 has a corner at (0, 1, 0.001), 0.001 m off the plane"),
              std::string::npos)
        << set.error().message;
}

}  // namespace
}  // namespace tyndall
