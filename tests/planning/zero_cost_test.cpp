// An effect that a scene does not need costs exactly nothing.
#include <gtest/gtest.h>

#include <functional>

#include "room_on_gpu.h"

namespace tyndall::test {
namespace {

class ZeroCost : public GpuTest {};

LightRecipe plainLamp() {
    LightRecipe light;
    light.x = -30;
    light.y = 15;
    light.yaw = -90;
    light.pitch = 0;
    return light;
}

Recipe withLights(std::vector<LightRecipe> lights) {
    Recipe recipe;
    recipe.lights = std::move(lights);
    recipe.eyeZ = 40;
    return recipe;
}

Plan planned(const Room& room) {
    return must(plan(room.lights, room.view, room.options, room.surroundings()));
}

void expectNothing(const RoomOnGpu::Shown& shown, const char* why) {
    const RendererCounters& c = shown.counters;
    EXPECT_EQ(c.draws, 0u) << why;
    EXPECT_EQ(c.slicesDrawn, 0u) << why;
    EXPECT_EQ(c.descriptorsPushed, 0u) << why;
    EXPECT_EQ(c.pipelinesCreated, 0u) << why;
    EXPECT_EQ(c.neutralTexturesCreated, 0u) << why;
    EXPECT_EQ(c.bytesUploaded, 0u) << why;
    EXPECT_EQ(shown.fragments, 0u) << why;
}

// Ways for a light not to be drawn.
struct Hiding {
    const char* why;
    Verdict verdict;
    std::function<void(Room&)> hide;
};

const std::vector<Hiding>& hidings() {
    static const std::vector<Hiding> all = {
        {"black", Verdict::Black, [](Room& r) { r.lights[0].colour = glm::dvec3(0.0); }},
        {"clear air", Verdict::NoDensity, [](Room& r) { r.lights[0].density = 0.0; }},
        {"beside", Verdict::BesideView, [](Room& r) { r.lights[0].worldFromLight[3].x += 100.0; }},
        {"behind", Verdict::BehindEye, [](Room& r) { r.lights[0].worldFromLight[3].z += 100.0; }},
        {"hidden", Verdict::BehindTiles, [](Room& r) { r.tiles.assign(r.tiles.size(), 0.2f); }},
        {"faint", Verdict::TooFaint, [](Room& r) { r.lights[0].intensity = 1e-9; }},
    };
    return all;
}

TEST_F(ZeroCost, OfLightsThatAreNotDrawn) {
    for (const Hiding& hiding : hidings()) {
        Room room;
        build(withLights({plainLamp()}), room);
        hiding.hide(room);
        const Plan plan = planned(room);
        EXPECT_EQ(plan.lights[0].verdict, hiding.verdict) << hiding.why;
        expectNothing(RoomOnGpu(room).draw(plan), hiding.why);
    }
}

// A thousand undrawn lights beside a drawn one cost nothing.
TEST_F(ZeroCost, OfLightsBesideOneThatIsDrawn) {
    Room alone;
    build(withLights({plainLamp()}), alone);
    const RoomOnGpu gpu(alone);
    const RoomOnGpu::Shown first = gpu.draw(planned(alone));
    EXPECT_EQ(first.counters.draws, 1u);
    EXPECT_GT(first.fragments, 1000u);
    for (const Hiding& hiding : hidings()) {
        if (hiding.verdict == Verdict::BehindTiles || hiding.verdict == Verdict::TooFaint)
            continue;  // hide all, or sum up
        Room room;
        build(withLights({plainLamp()}), room);
        hiding.hide(room);
        const Light hidden = room.lights[0];
        room.lights.assign(1001, hidden);
        room.lights[500] = alone.lights[0];
        room.lightSurveys.assign(1001, {});
        const std::vector<LightTextures> textures(1001);
        const RoomOnGpu::Shown shown = gpu.draw(planned(room), textures);
        EXPECT_EQ(shown.counters.draws, 1u) << hiding.why;
        EXPECT_EQ(shown.counters.descriptorsPushed, first.counters.descriptorsPushed) << hiding.why;
        EXPECT_EQ(shown.counters.bytesUploaded, first.counters.bytesUploaded) << hiding.why;
        EXPECT_EQ(shown.fragments, first.fragments) << hiding.why;
        EXPECT_EQ(largestDifference(shown.picture, first.picture), 0.0) << hiding.why;
    }
}

// Terms that a light has and the scene does not need.
struct Spared {
    const char* what;
    Term term;
    TermVerdict expected;
    std::function<void(Recipe&)> change;
};

TEST_F(ZeroCost, OfTermsThatAreNotCalledFor) {
    Room plain;
    build(withLights({plainLamp()}), plain);
    const RoomOnGpu::Shown bare = RoomOnGpu(plain).draw(planned(plain));
    const Spared terms[] = {
        {"shadow", Term::Shadow, TermVerdict::NoOccluder, [](Recipe& r) { r.lights[0].shadow = true; }},
        {"shadow of a box behind the lamp", Term::Shadow, TermVerdict::NoOccluder,
         [](Recipe& r) {
             r.lights[0].shadow = true;
             r.boxes = {{-38, 15, 0, 4, 4, 4, 0}};
         }},
        {"cookie", Term::Cookie, TermVerdict::Uniform, [](Recipe& r) { r.lights[0].slide = Slide::Uniform; }},
        {"noise", Term::Noise, TermVerdict::Uniform, [](Recipe& r) { r.lights[0].dust = Dust::Uniform; }},
    };
    for (const Spared& term : terms) {
        Recipe recipe = withLights({plainLamp()});
        term.change(recipe);
        Room room;
        build(recipe, room);
        const Plan plan = planned(room);
        EXPECT_EQ(plan.lights[0].verdicts[term.term], term.expected) << term.what;
        const LightTextures nothing{};
        const RoomOnGpu::Shown shown = RoomOnGpu(room).draw(plan, {&nothing, 1});
        EXPECT_EQ(shown.counters.draws, bare.counters.draws) << term.what;
        EXPECT_EQ(shown.counters.descriptorsPushed, bare.counters.descriptorsPushed) << term.what;
        EXPECT_EQ(shown.counters.pipelinesCreated, 0u) << term.what << ": the plain one is there";
        EXPECT_EQ(shown.counters.neutralTexturesCreated, 0u) << term.what;
        EXPECT_EQ(shown.counters.shadowMapsDrawn, 0u) << term.what;
    }
}

// A Renderer holds only the pipelines that its plans needed.
TEST_F(ZeroCost, OfPipelinesThatNoLightCallsFor) {
    Recipe recipe = withLights({plainLamp(), plainLamp(), plainLamp()});
    recipe.lights[1].slide = Slide::Checks;
    recipe.lights[2].slide = Slide::Uniform;
    Room room;
    build(recipe, room);
    const Plan plan = planned(room);
    const RoomOnGpu gpu(room);
    Renderer fresh = freshRenderer();
    EXPECT_EQ(gpu.draw(plan, {}, fresh).counters.pipelinesCreated, 2u) << "with and without a cookie";
    EXPECT_EQ(gpu.draw(plan, {}, fresh).counters.pipelinesCreated, 0u);
    EXPECT_EQ(fresh.counters().neutralTexturesCreated, 0u);
}

}  // namespace
}  // namespace tyndall::test
