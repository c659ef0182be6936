// A Planner stops allocating after a few frames.
#include <gtest/gtest.h>

#include "allocations.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

// Lights of all kinds among boxes, walls and depths, seen from a path around them.
struct Stage {
    Stage(const Stage&) = delete;  // its surroundings hold pointers into it
    std::vector<Light> lights;
    OccluderSet occluders;
    BlockerSet blockers;
    std::vector<float> depth;
    std::vector<LightSurvey> surveys;
    TextureSurvey pattern;
    Surroundings surroundings;

    Stage() {
        Random random(1);
        std::vector<glm::vec4> texels;
        for (int i = 0; i < 64; ++i) texels.push_back(glm::vec4(i % 2 ? 1.0f : 0.0f));
        pattern = surveyTexture(8, 8, texels, true);
        std::vector<OccluderBox> boxes;
        std::vector<Blocker> walls;
        for (int i = 0; i < 40; ++i) {
            Light light = projector();
            light.name = "a name that is too long to be kept within the string itself";
            light.worldFromLight = rigidMotion(random, 4.0);
            light.shadow = i % 2;
            light.cookie = i % 3 == 0;
            if (i % 5 == 0) light.noise = Noise{};
            if (i % 7 == 0) light.clipPlanes = {{0.0, 1.0, 0.0, 2.0}};
            light.intensity = i % 4 ? 100.0 : 1e-6;
            light.colour = {1.0, 0.25 * (i % 4), 0.5};
            lights.push_back(light);
            surveys.push_back({&pattern, &pattern});
            OccluderBox box;
            box.worldFromBox = rigidMotion(random, 6.0);
            box.minimum = glm::dvec3(-0.3);
            box.maximum = glm::dvec3(0.3);
            boxes.push_back(box);
        }
        for (const double y : {-3.0, 6.0})
            walls.push_back(
                {{{{{-50, y, -50}, {50, y, -50}, {50, y, 50}}}, {{{-50, y, -50}, {50, y, 50}, {-50, y, 50}}}}});
        for (int i = 0; i < 64; ++i) depth.push_back(static_cast<float>(between(random, 5.0, 20.0)));
        occluders = OccluderSet::fromBoxes(boxes).value();
        blockers = BlockerSet::fromBlockers(std::move(walls)).value();
        surroundings.occluders = &occluders;
        surroundings.blockers = &blockers;
        surroundings.depth = DepthTiles{8, 8, depth};
        surroundings.surveys = surveys;
    }
};

View viewOnPath(int frame) {
    const double angle = 0.06 * frame;
    return perspectiveView(lookingAt({9.0 * std::cos(angle), 1.0, 9.0 * std::sin(angle)}, {0.0, 0.0, 0.0}), 0.9, 1.5,
                           0.1, std::numeric_limits<double>::infinity());
}

TEST(Planner, AllocatesNothingInTheSteadyState) {
    Stage stage;
    for (const Spacing spacing : {Spacing::Even, Spacing::Adaptive})
        for (const Geometry geometry : {Geometry::ExactPolygons, Geometry::StretchedQuads})
            for (const Accumulation format : {Accumulation::Rgba16f, Accumulation::Rgba8Routed})
                for (const bool everything : {false, true}) {
                    PlanOptions options = slices(32);
                    options.spacing = spacing;
                    options.geometry = geometry;
                    options.accumulation = format;
                    options.everything = everything;
                    options.displayStep = 1.0 / 256.0;
                    options.pictureHeight = 720;
                    Planner planner;
                    Plan plan;
                    std::size_t drawn = 0, steady = 0;
                    for (int frame = 0; frame < 200; ++frame) {
                        options.time = 0.02 * frame;
                        const View view = viewOnPath(frame % 100);  // the second round repeats the first
                        glm::dmat4 moving(1.0);
                        moving[3].y = 0.1 * (frame % 100);
                        const std::size_t before = allocations();
                        const bool done =
                            stage.occluders.move(0, moving) &&
                            planner.plan(stage.lights, view, options, stage.surroundings, plan).has_value();
                        if (frame >= 100) steady += allocations() - before;
                        ASSERT_TRUE(done);
                        drawn += plan.parts.size();
                    }
                    EXPECT_EQ(steady, 0u);
                    EXPECT_GT(drawn, 500u);
                }
}

TEST(Planner, CountsAllocationsAtAll) {
    const Stage stage;
    const std::size_t before = allocations();
    ASSERT_TRUE(plan(stage.lights, viewOnPath(0), slices(32), stage.surroundings));
    EXPECT_GT(allocations(), before);
}

TEST(Planner, PlansAsPlanDoesWhateverItPlannedBefore) {
    const Stage stage;
    Planner planner;
    Plan reused;
    for (int frame = 0; frame < 100; frame += 9) {
        PlanOptions options = slices(frame % 2 ? 16 : 40);
        options.displayStep = frame % 3 ? 1.0 / 256.0 : 0.0;
        ASSERT_TRUE(planner.plan(stage.lights, viewOnPath(frame), options, stage.surroundings, reused));
        const Result<Plan> fresh = plan(stage.lights, viewOnPath(frame), options, stage.surroundings);
        ASSERT_TRUE(fresh);
        ASSERT_EQ(reused.vertices.size(), fresh->vertices.size());
        EXPECT_EQ(reused.indices, fresh->indices);
        for (std::size_t i = 0; i < reused.vertices.size(); ++i)
            EXPECT_EQ(reused.vertices[i].position, fresh->vertices[i].position);
        ASSERT_EQ(reused.parts.size(), fresh->parts.size());
        for (std::size_t i = 0; i < reused.parts.size(); ++i) {
            EXPECT_EQ(reused.parts[i].light, fresh->parts[i].light);
            EXPECT_EQ(reused.parts[i].terms, fresh->parts[i].terms);
            EXPECT_EQ(reused.parts[i].firstIndex, fresh->parts[i].firstIndex);
        }
        ASSERT_EQ(reused.groups.size(), fresh->groups.size());
        for (std::size_t i = 0; i < reused.lights.size(); ++i)
            EXPECT_EQ(reused.lights[i].verdict, fresh->lights[i].verdict);
    }
}

}  // namespace
}  // namespace tyndall
