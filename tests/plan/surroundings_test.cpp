// Invalid surroundings give an error and no plan.
#include <gtest/gtest.h>

#include "numbers.h"
#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

struct Bad {
    std::vector<float> depth{1.0f, 2.0f};
    DepthTiles tiles{2, 1, {}};
    TextureSurvey survey = surveyTexture(1, 1, std::vector<glm::vec4>(1), false);
    std::vector<LightSurvey> surveys;

    Bad() {
        tiles.farthest = depth;
        surveys = {{&survey, nullptr}};
    }
};

std::string whyRefused(const Bad& bad) {
    Random random(1);
    const Scene scene = randomScene(random);
    Surroundings surroundings;
    surroundings.depth = bad.tiles;
    surroundings.surveys = bad.surveys;
    Planner planner;
    Plan plan;
    // After an error the plan is empty, even if it held something before.
    EXPECT_TRUE(planner.plan(std::span(&scene.light, 1), scene.view, slices(4), {}, plan));
    EXPECT_FALSE(plan.vertices.empty());
    const Result<void> done = planner.plan(std::span(&scene.light, 1), scene.view, slices(4), surroundings, plan);
    if (done) return {};
    EXPECT_EQ(done.error().code, ErrorCode::InvalidArgument);
    EXPECT_TRUE(plan.vertices.empty() && plan.indices.empty() && plan.constants.empty() && plan.lights.empty() &&
                plan.parts.empty() && plan.groups.empty());
    return done.error().message;
}

void expectRefused(void (*change)(Bad&), const std::string& words) {
    Bad bad;
    change(bad);
    EXPECT_NE(whyRefused(bad).find(words), std::string::npos) << words << " / " << whyRefused(bad);
    EXPECT_EQ(whyRefused(bad).find("surroundings: "), 0u) << words;
}

TEST(Surroundings, AreTakenWhereTheyMakeSense) {
    EXPECT_EQ(whyRefused(Bad{}), "");
}

TEST(Surroundings, WithWrongNumbersOfEntriesAreRefused) {
    expectRefused([](Bad& b) { b.surveys.push_back({}); }, "surveys has 2 entries for 1 lights");
    expectRefused([](Bad& b) { b.survey.cells.clear(); }, "survey of light 0 is not complete");
    expectRefused([](Bad& b) { b.survey.detail = 0.0; }, "survey of light 0 is not complete");
    expectRefused([](Bad& b) { b.survey.detail = nan; }, "survey of light 0 is not complete");
    expectRefused([](Bad& b) { b.tiles.columns = 3; }, "depth has 2 tiles for 3 columns and 1 rows");
    expectRefused([](Bad& b) { b.tiles = {}; }, "depth has 0 tiles");
}

TEST(Surroundings, WithDepthsThatAreNoneAreRefused) {
    expectRefused([](Bad& b) { b.depth[1] = -1.0f; }, "a tile's depth is -1");
    expectRefused([](Bad& b) { b.depth[0] = NAN; }, "a tile's depth is nan");
}

}  // namespace
}  // namespace tyndall
