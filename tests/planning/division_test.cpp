// The parts of a divided light add up to the undivided light, and the omitted parts are dark.
#include <gtest/gtest.h>

#include "room_on_gpu.h"

namespace tyndall::test {
namespace {

class Division : public GpuTest {
protected:
    // A lamp on the left shines to the right through the picture, over its whole width; a box blocks part of it. No
    // surface hides it.
    static Recipe beam() {
        Recipe recipe;
        recipe.eyeZ = 40;
        LightRecipe light;
        light.x = -30;
        light.y = 15;
        light.yaw = -90;
        light.pitch = 0;
        light.near = 30;
        light.strength = 6;
        light.shadow = true;
        recipe.lights = {light};
        recipe.boxes = {{5, 15, 0, 4, 4, 4, 30}};
        return recipe;
    }
};

Plan planFor(const Room& room, bool everything, const Surroundings& surroundings) {
    PlanOptions options = room.options;
    options.everything = everything;
    return must(plan(room.lights, room.view, options, surroundings));
}

Plan onlyPart(Plan plan, std::size_t part) {
    plan.parts = {plan.parts.at(part)};
    plan.groups.at(0).parts = 1;
    return plan;
}

Picture added(const Picture& a, const Picture& b) {
    Picture sum = a;
    for (std::size_t i = 0; i < sum.pixels.size(); ++i)
        for (int c = 0; c < 4; ++c) sum.pixels[i][c] += b.pixels[i][c];
    return sum;
}

// Pixels that differ by more than rounding: squares, quotients and sums of interpolated numbers are a few dozen
// roundings. No pixel may differ by more than the brightest possible slice.
int changedBySlices(const Picture& a, const Picture& b, const PlannedLight& light) {
    int changed = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double difference = std::fabs(static_cast<double>(a.pixels[i][0]) - b.pixels[i][0]);
        changed += difference > 1e-5 * b.pixels[i][0];
        EXPECT_LE(difference, light.brightest / light.slices);
    }
    return changed;
}

TEST_F(Division, PartsAddUpToTheWhole) {
    for (const bool adaptive : {false, true})
        for (const Slide slide : {Slide::None, Slide::Checks}) {
            Recipe recipe = beam();
            recipe.adaptive = adaptive;
            recipe.lights[0].slide = slide;
            Room room;
            build(recipe, room);
            const RoomOnGpu gpu(room);
            const Plan plan = planFor(room, false, room.surroundings());
            ASSERT_EQ(plan.parts.size(), 2u);
            EXPECT_TRUE(plan.lights[0].divided);
            const Picture both = gpu.draw(plan).picture;
            const Picture first = gpu.draw(onlyPart(plan, 0)).picture, second = gpu.draw(onlyPart(plan, 1)).picture;
            EXPECT_GT(litPixels(first), 200);
            EXPECT_GT(litPixels(second), 20) << "most of what lies behind the occluder is dark";
            // Sums of at most 64 floats in another order.
            EXPECT_LE(largestDifference(added(first, second), both), 64 * 0x1p-24);
            // The same slices with the shadow map looked up everywhere: before the occluder it gives 1, and a shader
            // that multiplies by it may round a few times more or less.
            const Picture whole = gpu.draw(planFor(room, true, room.surroundings())).picture;
            EXPECT_LE(largestDifference(both, whole), 64 * 0x1p-24);
        }
}

// The plan knows no occluders, so slices are not divided. Their outlines lack two corners, and pixels whose centres lie
// within 1/256 pixel of an outline may change by a slice; all others by the rounding of interpolation.
TEST_F(Division, IsTheUndividedDraw) {
    Room room;
    build(beam(), room);
    const RoomOnGpu gpu(room);
    Surroundings unknown = room.surroundings();
    unknown.occluders = nullptr;
    const Plan whole = planFor(room, false, unknown);
    ASSERT_EQ(whole.parts.size(), 1u);
    const Picture divided = gpu.draw(planFor(room, false, room.surroundings())).picture,
                  undivided = gpu.draw(whole).picture;
    EXPECT_LE(changedBySlices(divided, undivided, whole.lights[0]), Room::width * Room::height / 100);
}

// Before the first occluder no map is read, so none is bound.
TEST_F(Division, BeforeTheFirstOccluderThereIsNoShadowMap) {
    Room room;
    build(beam(), room);
    const RoomOnGpu gpu(room);
    const Plan plan = planFor(room, false, room.surroundings());
    ASSERT_EQ(plan.parts.size(), 2u);
    const std::size_t lit = plan.parts[0].terms.contains(Term::Shadow) ? 1 : 0;
    EXPECT_TRUE(plan.parts[1 - lit].terms.contains(Term::Shadow));
    EXPECT_EQ(plan.parts[lit].terms, TermSet{});
    const LightTextures nothing{};
    const RoomOnGpu::Shown with = gpu.draw(onlyPart(plan, lit)), without = gpu.draw(onlyPart(plan, lit), {&nothing, 1});
    EXPECT_EQ(with.counters.descriptorsPushed, 1u) << "the constants alone";
    EXPECT_EQ(without.counters.descriptorsPushed, 1u);
    EXPECT_EQ(without.counters.neutralTexturesCreated, 0u);
    EXPECT_EQ(largestDifference(with.picture, without.picture), 0.0);
    EXPECT_EQ(gpu.draw(onlyPart(plan, 1 - lit)).counters.descriptorsPushed, 2u) << "and the map";
}

// The shadow map makes the air behind a wall dark, whether the wall is in the picture or not. The exception is the
// millimetre of wallMargin(), a hundredth of a pixel: one in a hundred pixel centres at a slice's end may lie in it.
TEST_F(Division, UmbraIsNotDrawnAndDark) {
    Recipe recipe = beam();
    recipe.boxes.clear();
    recipe.wall = true;
    recipe.lights[0] = {0, 15, 0, 0, 0, 40, 30, 30, 6, Slide::None, Dust::None, true, false};  // at the wall, head on
    recipe.eyeX = 39;
    recipe.eyeZ = -35;
    recipe.yaw = -49;
    Room room;
    build(recipe, room);
    room.options.displayStep = 0.0;
    // No surface in the picture hides the air behind the wall.
    room.depth = constantTexture(Room::width, Room::height, {0.0f});
    const RoomOnGpu gpu(room);
    Surroundings open = room.surroundings();
    open.depth.reset();
    const Plan planned = planFor(room, false, open);
    EXPECT_EQ(planned.lights[0].walls, 1u);
    EXPECT_EQ(planned.lights[0].verdicts[Term::Shadow], TermVerdict::NoOccluder);
    const RoomOnGpu::Shown some = gpu.draw(planned), all = gpu.draw(planFor(room, true, open));
    EXPECT_GT(litPixels(some.picture), 100);
    EXPECT_LE(changedBySlices(some.picture, all.picture, planned.lights[0]), Room::width * Room::height / 50);
    EXPECT_LT(some.fragments, all.fragments * 9 / 10);
}

}  // namespace
}  // namespace tyndall::test
