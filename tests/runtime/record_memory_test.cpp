// A Planner and a Renderer that have drawn such frames before allocate nothing on drawing the next.
#include <gtest/gtest.h>
#include <headless/commands.h>
#include <headless/image.h>
#include <tyndall/renderer.h>

#include "../bench/city.h"
#include "allocations.h"

namespace tyndall::test {
namespace {

headless::Image image(const headless::Device& device, VkFormat format, VkImageUsageFlags usage) {
    auto made = headless::Image::create(device, {.extent = {64, 36}, .format = format, .usage = usage});
    EXPECT_TRUE(made.has_value());
    return std::move(*made);
}

TEST(RecordMemory, IsNotAllocatedInTheSteadyState) {
    bench::City city = bench::city(400);
    Planner planner;
    Plan plan;
    // Without the validation layers, which allocate as they please.
    auto device = headless::Device::create();
    ASSERT_TRUE(device.has_value());
    auto renderer = Renderer::create({device->physicalDevice(), device->device()});
    ASSERT_TRUE(renderer.has_value());
    const auto sum = image(*device, accumulationFormat(plan.accumulation = city.options.accumulation),
                           VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    const auto colour = image(*device, VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    const ShaftTargets targets{.extent = {64, 36},
                               .accumulation = sum.handle(),
                               .accumulationView = sum.view(),
                               .colour = colour.view(),
                               .colourFormat = VK_FORMAT_R32G32B32A32_SFLOAT};
    const std::vector<LightTextures> textures(city.lights.size());
    FrameData frame;
    std::size_t parts = 0;
    const auto draw = [&](int step) {
        city.view.worldFromView[3].z = -0.05 * step;
        std::size_t during = 0;
        const std::function<Result<void>(VkCommandBuffer)> record = [&](VkCommandBuffer commands) -> Result<void> {
            const std::size_t before = allocations();
            Result<void> done = planner.plan(city.lights, city.view, city.options, city.surroundings(), plan);
            if (done) done = renderer->upload(frame, plan);
            if (done) done = renderer->record(commands, frame, plan, textures, targets);
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
