// What a frame costs as lights grow many: planning it, uploading and recording it, and drawing it as planned and as it
// were if nothing were left out. Time is that of all lights; the counter s_per_light divides it.
#include <benchmark/benchmark.h>
#include <headless/commands.h>
#include <headless/device.h>
#include <headless/image.h>
#include <tyndall/explain.h>
#include <tyndall/renderer.h>
#include <vulkan/vulkan.h>

#include <algorithm>

#include "city.h"

namespace {

using namespace tyndall;

void perLight(benchmark::State& state, std::size_t lights, const Plan& plan) {
    state.counters["drawn"] = static_cast<double>(
        std::count_if(plan.lights.begin(), plan.lights.end(), [](const PlannedLight& light) { return light.drawn; }));
    state.counters["parts"] = static_cast<double>(plan.parts.size());
    state.counters["vertices"] = static_cast<double>(plan.vertices.size());
    state.counters["s_per_light"] = benchmark::Counter(
        static_cast<double>(lights), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void planCity(benchmark::State& state) {
    const bench::City city = bench::city(static_cast<std::size_t>(state.range(0)));
    const Surroundings surroundings = city.surroundings();
    Planner planner;
    Plan plan;
    for (auto _ : state)
        if (const auto done = planner.plan(city.lights, city.view, city.options, surroundings, plan); !done)
            return state.SkipWithError(done.error().message.c_str());
    perLight(state, city.lights.size(), plan);
}

/// One for the whole program: some drivers do not start a second time.
const Result<headless::Device>& theDevice() {
    static const auto device = headless::Device::create();
    return device;
}

headless::Image target(const headless::Device& device, VkFormat format, VkImageUsageFlags usage) {
    auto image = headless::Image::create(device, {.extent = {1920, 1080}, .format = format, .usage = usage});
    return image ? std::move(*image) : headless::Image();
}

/// One that can be recorded again and again.
struct CommandBuffer {
    explicit CommandBuffer(const headless::Device& of) : device(of.device()) {
        VkCommandPoolCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
        info.queueFamilyIndex = of.queueFamily();
        VkCommandBufferAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocate.commandBufferCount = 1;
        if (vkCreateCommandPool(device, &info, nullptr, &pool) == VK_SUCCESS) {
            allocate.commandPool = pool;
            vkAllocateCommandBuffers(device, &allocate, &handle);
        }
    }
    CommandBuffer(const CommandBuffer&) = delete;
    ~CommandBuffer() { vkDestroyCommandPool(device, pool, nullptr); }
    void begin() const {
        VkCommandBufferBeginInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        vkBeginCommandBuffer(handle, &info);
    }

    VkDevice device;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer handle = VK_NULL_HANDLE;
};

void recordCity(benchmark::State& state) {
    const bench::City city = bench::city(static_cast<std::size_t>(state.range(0)));
    auto plan = tyndall::plan(city.lights, city.view, city.options, city.surroundings());
    const auto& device = theDevice();
    if (!plan) return state.SkipWithError(plan.error().message.c_str());
    if (!device) return state.SkipWithError(device.error().message.c_str());
    auto renderer = Renderer::create({device->physicalDevice(), device->device()});
    if (!renderer) return state.SkipWithError(renderer.error().message.c_str());
    const auto sum = target(*device, accumulationFormat(plan->accumulation),
                            VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    const auto colour = target(*device, VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    const ShaftTargets targets{.extent = {1920, 1080},
                               .accumulation = sum.handle(),
                               .accumulationView = sum.view(),
                               .colour = colour.view(),
                               .colourFormat = VK_FORMAT_R32G32B32A32_SFLOAT};
    const std::vector<LightTextures> textures(city.lights.size());
    FrameData frame;
    const CommandBuffer commands(*device);
    // Recorded and thrown away: what the GPU would do with it is another matter.
    for (auto _ : state) {
        commands.begin();
        auto done = renderer->upload(frame, *plan);
        if (done) done = renderer->record(commands.handle, frame, *plan, textures, targets);
        if (!done) return state.SkipWithError(done.error().message.c_str());
    }
    perLight(state, city.lights.size(), *plan);
}

/// From submission to fence, by the host's clock.
void drawCity(benchmark::State& state, bool everything) {
    const bench::City city = bench::city(static_cast<std::size_t>(state.range(0)));
    PlanOptions options = city.options;
    options.everything = everything;
    auto plan = tyndall::plan(city.lights, city.view, options, city.surroundings());
    const auto& device = theDevice();
    if (!plan) return state.SkipWithError(plan.error().message.c_str());
    if (!device) return state.SkipWithError(device.error().message.c_str());
    auto renderer = Renderer::create({device->physicalDevice(), device->device()});
    if (!renderer) return state.SkipWithError(renderer.error().message.c_str());
    state.SetLabel(std::string(device->name()));
    const auto sum = target(*device, accumulationFormat(plan->accumulation),
                            VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    const auto colour = target(*device, VK_FORMAT_R32G32B32A32_SFLOAT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    const ShaftTargets targets{.extent = {1920, 1080},
                               .accumulation = sum.handle(),
                               .accumulationView = sum.view(),
                               .colour = colour.view(),
                               .colourFormat = VK_FORMAT_R32G32B32A32_SFLOAT};
    const std::vector<LightTextures> textures(city.lights.size());
    FrameData frame;
    double fragments = 0.0;
    for (const PlannedPart& part : plan->parts) fragments += expectedFragments(*plan, part, city.view, 1920, 1080);
    for (auto _ : state) {
        auto time = renderer->upload(frame, *plan).and_then([&] {
            return headless::submitAndWait(*device, [&](VkCommandBuffer commands) -> Result<void> {
                headless::transition(commands, colour, VK_IMAGE_LAYOUT_UNDEFINED,
                                     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
                return renderer->record(commands, frame, *plan, textures, targets);
            });
        });
        if (!time) return state.SkipWithError(time.error().message.c_str());
        state.SetIterationTime(1e-3 * *time);
    }
    state.counters["fragments"] = fragments;
    perLight(state, city.lights.size(), *plan);
}

}  // namespace

BENCHMARK(planCity)->Arg(1)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(recordCity)->Arg(1)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drawCity, planned, false)->Arg(200)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(drawCity, forced, true)->Arg(200)->UseManualTime()->Unit(benchmark::kMillisecond);
