// A renderer that drew everything leaves no objects on its device.
#include <gtest/gtest.h>

#include <mutex>

#include "record_scene.h"

namespace tyndall::test {
namespace {

TEST(RecordLeak, NothingIsLeftOnTheDevice) {
    std::vector<std::string> messages;
    {
        headless::DeviceOptions options;
        options.validation = true;
        options.preferSoftware = true;
        options.onMessage = [&](const std::string& message) { messages.push_back(message); };
        const auto device = must(headless::Device::create(options));
        VkPipelineCacheCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
        VkPipelineCache cache = VK_NULL_HANDLE;
        ASSERT_EQ(vkCreatePipelineCache(device.device(), &info, nullptr, &cache), VK_SUCCESS);
        {
            auto renderer = must(Renderer::create({device.physicalDevice(), device.device(), cache}));
            FrameData frame;
            constexpr VkImageUsageFlags colourUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
            const auto accumulation =
                must(headless::Image::create(device, {{16, 16}, VK_FORMAT_R16G16B16A16_SFLOAT, colourUsage}));
            const auto colour =
                must(headless::Image::create(device, {{16, 16}, VK_FORMAT_R16G16B16A16_SFLOAT, colourUsage}));
            const auto map = must(headless::Image::create(
                device, {{16, 16}, VK_FORMAT_D32_SFLOAT, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT}));
            const Light light = lamp();
            PlanOptions planOptions;
            planOptions.terms = TermSet::all();
            const Plan shafts =
                must(plan(std::span(&light, 1), perspectiveView(glm::dmat4(1.0), 1.0, 1.0, 0.1, 100.0), planOptions));
            must(renderer.upload(frame, shafts));
            ShaftTargets targets;
            targets.extent = {16, 16};
            targets.accumulation = accumulation.handle();
            targets.accumulationView = accumulation.view();
            targets.colour = colour.view();
            targets.colourFormat = colour.format();
            const LightTextures none;
            must(headless::submitAndWait(device, [&](VkCommandBuffer commands) -> Result<void> {
                headless::transition(commands, map, VK_IMAGE_LAYOUT_UNDEFINED,
                                     VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
                headless::transition(commands, colour, VK_IMAGE_LAYOUT_UNDEFINED,
                                     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
                auto shadow = renderer.recordShadowMap(commands, frame, light, {}, map.view(), map.format(), 16);
                if (!shadow) return shadow;
                return renderer.record(commands, frame, shafts, std::span(&none, 1), targets);
            }));
            EXPECT_EQ(renderer.counters().neutralTexturesCreated, 2u);
            // A moved renderer still owns its objects, once.
            Renderer moved = std::move(renderer);
            EXPECT_GT(moved.counters().pipelinesCreated, 2u);
        }
        vkDestroyPipelineCache(device.device(), cache, nullptr);
    }
    for (const std::string& message : messages) ADD_FAILURE() << message;
}

}  // namespace
}  // namespace tyndall::test
