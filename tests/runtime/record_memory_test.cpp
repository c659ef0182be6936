// After some similar frames, a Planner and a Renderer draw the next without allocations.
#include <gtest/gtest.h>
#include <headless/commands.h>

#include "../bench/city_frame.h"
#include "../plan/allocations.h"

namespace tyndall::test {
namespace {

TEST(RecordMemory, IsNotAllocatedInTheSteadyState) {
    bench::City city = bench::city(400);
    Planner planner;
    Plan plan;
    // Without the validation layers, which allocate as they please.
    auto device = headless::Device::create();
    ASSERT_TRUE(device.has_value());
    auto frame = bench::cityFrame(*device, city, {64, 36});
    ASSERT_TRUE(frame.has_value());
    std::size_t parts = 0;
    const auto draw = [&](int step) {
        city.view.worldFromView[3].z = -0.05 * step;
        std::size_t during = 0;
        const std::function<Result<void>(VkCommandBuffer)> record = [&](VkCommandBuffer commands) -> Result<void> {
            const std::size_t before = allocations();
            Result<void> done = planner.plan(city.lights, city.view, city.options, city.surroundings(), plan);
            if (done) done = frame->renderer.upload(frame->data, plan);
            if (done) done = frame->renderer.record(commands, frame->data, plan, frame->textures, frame->targets);
            during = allocations() - before;
            return done;
        };
        EXPECT_TRUE(headless::submitAndWait(*device, record).has_value());
        parts += plan.parts.size();
        return during;
    };
    for (int step = 0; step <= 40; ++step) draw(step);
    std::size_t allocated = 0;
    for (int step = 40; step > 0; --step) allocated += draw(step);
    EXPECT_EQ(allocated, 0u) << "in 40 frames with " << parts / 81 << " parts each";
    EXPECT_GT(parts / 81, 10u);
}

}  // namespace
}  // namespace tyndall::test
