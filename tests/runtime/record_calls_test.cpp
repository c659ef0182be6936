// The renderer's calls to Vulkan. lavapipe runs everything in order and the validation layers of Vulkan 1.3.239 do not
// follow dynamic rendering, so neither detects a missing barrier; an unnecessary allocation only costs frame time. This
// is a separate program, because it replaces four of Vulkan's functions.
#include <gtest/gtest.h>

#include <string>

#include "record_scene.h"

namespace tyndall::test {
namespace {

/// A barrier, the beginning of a pass, or a dispatch.
struct Event {
    bool pass = false, dispatch = false;
    VkImageView target = VK_NULL_HANDLE;  ///< of a pass
    VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    VkImage image = VK_NULL_HANDLE;  ///< of a barrier; null: of all memory
    VkPipelineStageFlags2 before = 0, after = 0;
    VkAccessFlags2 written = 0, visible = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

std::vector<Event> events;
int allocations = 0;

template <class Function>
Function deviceFunction(VkDevice device, const char* name) {
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device, name));
}

}  // namespace

extern "C" VKAPI_ATTR void VKAPI_CALL vkCmdPipelineBarrier2(VkCommandBuffer commands, const VkDependencyInfo* info) {
    for (std::uint32_t i = 0; i < info->memoryBarrierCount; ++i) {
        const VkMemoryBarrier2& barrier = info->pMemoryBarriers[i];
        events.push_back({.before = barrier.srcStageMask,
                          .after = barrier.dstStageMask,
                          .written = barrier.srcAccessMask,
                          .visible = barrier.dstAccessMask});
    }
    for (std::uint32_t i = 0; i < info->imageMemoryBarrierCount; ++i) {
        const VkImageMemoryBarrier2& barrier = info->pImageMemoryBarriers[i];
        events.push_back({.image = barrier.image,
                          .before = barrier.srcStageMask,
                          .after = barrier.dstStageMask,
                          .written = barrier.srcAccessMask,
                          .visible = barrier.dstAccessMask,
                          .layout = barrier.newLayout});
    }
    deviceFunction<PFN_vkCmdPipelineBarrier2>(gpu().device.device(), "vkCmdPipelineBarrier2")(commands, info);
}

extern "C" VKAPI_ATTR void VKAPI_CALL vkCmdBeginRendering(VkCommandBuffer commands, const VkRenderingInfo* info) {
    if (info->colorAttachmentCount > 0)
        events.push_back(
            {.pass = true, .target = info->pColorAttachments[0].imageView, .load = info->pColorAttachments[0].loadOp});
    deviceFunction<PFN_vkCmdBeginRendering>(gpu().device.device(), "vkCmdBeginRendering")(commands, info);
}

extern "C" VKAPI_ATTR void VKAPI_CALL vkCmdDispatch(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y,
                                                    std::uint32_t z) {
    events.push_back({.dispatch = true});
    deviceFunction<PFN_vkCmdDispatch>(gpu().device.device(), "vkCmdDispatch")(commands, x, y, z);
}

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkAllocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                                           const VkAllocationCallbacks* callbacks,
                                                           VkDeviceMemory* memory) {
    ++allocations;
    return deviceFunction<PFN_vkAllocateMemory>(device, "vkAllocateMemory")(device, info, callbacks, memory);
}

namespace {

constexpr VkPipelineStageFlags2 kOutput = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 kFragment = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkAccessFlags2 kWrite = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 kBlend = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | kWrite;

template <class Flags>
bool holds(Flags all, Flags wanted) {
    return (all & wanted) == wanted;
}

/// Whether events[from, to) hold a barrier on the image (null: on all memory) that includes `wanted`.
bool waits(std::size_t from, std::size_t to, const Event& wanted) {
    for (std::size_t i = from; i < to; ++i) {
        const Event& event = events[i];
        if (!event.pass && !event.dispatch && event.image == wanted.image && holds(event.before, wanted.before) &&
            holds(event.after, wanted.after) && holds(event.written, wanted.written) &&
            holds(event.visible, wanted.visible) && event.layout == wanted.layout)
            return true;
    }
    return false;
}

using RecordCalls = GpuTest;

// Each light's dispatch adds to what the one before it wrote; the first adds to the cleared image, and the composite
// reads the last one's.
TEST_F(RecordCalls, EveryDispatchOfRaysWaitsForTheOneBefore) {
    constexpr VkPipelineStageFlags2 compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    constexpr VkAccessFlags2 write = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    constexpr VkAccessFlags2 add = VK_ACCESS_2_SHADER_STORAGE_READ_BIT | write;
    Stage stage({48, 32}, Accumulation::Rgba32f);
    const headless::Image sum = makeImage(
        {48, 32}, VK_FORMAT_R32G32B32A32_SFLOAT,
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT, "sum of rays");
    const std::array lights{lamp(), lamp(), lamp()};
    PlanOptions options;
    options.method = Method::Raycast;
    options.accumulation = Accumulation::Rgba32f;
    const Plan plan = must(tyndall::plan(lights, eye(stage), options));
    ASSERT_EQ(plan.parts.size(), 3u);
    std::array<LightTextures, 3> textures{};
    for (LightTextures& each : textures) each.cookieSize = each.noiseSize = {1, 1};
    FrameData frame;
    must(gpu().frozen.upload(frame, plan));
    ShaftTargets targets = stage.targets();
    targets.accumulation = sum.handle();
    targets.accumulationView = sum.view();
    targets.storage = true;
    events.clear();
    run([&](VkCommandBuffer commands) {
        events.clear();  // drops the caller's own calls
        return gpu().frozen.record(commands, frame, plan, textures, targets);
    });

    std::vector<std::size_t> dispatches, passes;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (events[i].dispatch) dispatches.push_back(i);
        if (events[i].pass) passes.push_back(i);
    }
    ASSERT_EQ(dispatches.size(), 3u);
    ASSERT_EQ(passes.size(), 2u);
    EXPECT_TRUE(waits(passes[0], dispatches[0],
                      {.image = sum.handle(),
                       .before = kOutput,
                       .after = compute,
                       .written = kWrite,
                       .visible = add,
                       .layout = VK_IMAGE_LAYOUT_GENERAL}));
    for (std::size_t i = 1; i < dispatches.size(); ++i)
        EXPECT_TRUE(waits(dispatches[i - 1], dispatches[i],
                          {.before = compute, .after = compute, .written = write, .visible = add}));
    EXPECT_TRUE(waits(dispatches[2], passes[1],
                      {.image = sum.handle(),
                       .before = compute,
                       .after = kFragment,
                       .written = write,
                       .visible = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                       .layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}));
}

TEST_F(RecordCalls, EveryPassWaitsForWhatItReadsOrAddsTo) {
    Stage stage({48, 32}, Accumulation::Rgba8Routed);
    std::array lights{lamp(), lamp(), lamp()};
    lights[0].colour = {1.0, 0.0, 0.0};
    lights[1].colour = {0.0, 0.5, 1.0};
    PlanOptions options;
    options.slices = 8;
    options.accumulation = Accumulation::Rgba8Routed;
    const Plan plan = must(tyndall::plan(lights, eye(stage), options));
    ASSERT_EQ(plan.groups.size(), 3u);
    const std::array<LightTextures, 3> textures{};
    FrameData frame;
    must(gpu().frozen.upload(frame, plan));
    const ShaftTargets targets = stage.targets();
    events.clear();
    run([&](VkCommandBuffer commands) {
        events.clear();  // drops the caller's own calls
        return gpu().frozen.record(commands, frame, plan, textures, targets);
    });

    std::vector<std::size_t> passes;
    for (std::size_t i = 0; i < events.size(); ++i)
        if (events[i].pass) passes.push_back(i);
    ASSERT_EQ(passes.size(), 6u);
    std::size_t previous = 0;
    for (std::size_t p = 0; p < passes.size(); ++p) {
        SCOPED_TRACE("pass " + std::to_string(p));
        const Event& pass = events[passes[p]];
        if (p % 2 == 0) {
            // Clears the image that the previous composite may still read, and an earlier frame's slices may still
            // write.
            EXPECT_EQ(pass.target, targets.accumulationView);
            EXPECT_EQ(pass.load, VK_ATTACHMENT_LOAD_OP_CLEAR);
            EXPECT_TRUE(waits(previous, passes[p],
                              {.image = targets.accumulation,
                               .before = kOutput | kFragment,
                               .after = kOutput,
                               .written = kWrite,
                               .visible = kBlend,
                               .layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}));
        } else {
            // Reads the sum, and adds to the picture that the scene or the composite before it wrote.
            EXPECT_EQ(pass.target, targets.colour);
            EXPECT_EQ(pass.load, VK_ATTACHMENT_LOAD_OP_LOAD);
            EXPECT_TRUE(waits(previous, passes[p],
                              {.image = targets.accumulation,
                               .before = kOutput,
                               .after = kFragment,
                               .written = kWrite,
                               .visible = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                               .layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}));
            EXPECT_TRUE(waits(previous, passes[p],
                              {.before = kOutput, .after = kOutput, .written = kWrite, .visible = kBlend}));
        }
        previous = passes[p];
    }
}

TEST_F(RecordCalls, AFrameThatHasTheRoomAllocatesNothing) {
    Stage stage;
    const Light light = lamp();
    const auto planOf = [&](int slices) {
        PlanOptions options;
        options.slices = slices;
        return must(plan(std::span(&light, 1), eye(stage), options));
    };
    const Plan small = planOf(8), large = planOf(4000);
    FrameData frame;
    allocations = 0;
    must(gpu().frozen.upload(frame, large));
    EXPECT_EQ(allocations, 1);
    for (const Plan* next : {&small, &large, &small}) must(gpu().frozen.upload(frame, *next));
    EXPECT_EQ(allocations, 1);
}

}  // namespace
}  // namespace tyndall::test
