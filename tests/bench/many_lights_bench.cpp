// Costs of a frame with many lights: planning, uploading and recording, and drawing it as planned and with nothing left
// out. Times are for all lights; the counter s_per_light divides them.
#include <benchmark/benchmark.h>
#include <headless/commands.h>
#include <headless/device.h>
#include <tyndall/explain.h>
#include <vulkan/vulkan.h>

#include <algorithm>

#include "city_frame.h"

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

/// One for the whole program: some drivers cannot start twice.
const Result<headless::Device>& theDevice() {
    static const auto device = headless::Device::create();
    return device;
}

constexpr VkExtent2D fullHd{1920, 1080};

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
    auto frame = bench::cityFrame(*device, city, fullHd);
    if (!frame) return state.SkipWithError(frame.error().message.c_str());
    const CommandBuffer commands(*device);
    // Recorded and discarded: this measures the CPU only.
    for (auto _ : state) {
        commands.begin();
        auto done = frame->renderer.upload(frame->data, *plan);
        if (done) done = frame->renderer.record(commands.handle, frame->data, *plan, frame->textures, frame->targets);
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
    auto frame = bench::cityFrame(*device, city, fullHd);
    if (!frame) return state.SkipWithError(frame.error().message.c_str());
    state.SetLabel(std::string(device->name()));
    double fragments = 0.0;
    for (const PlannedPart& part : plan->parts)
        fragments += expectedFragments(*plan, part, city.view, fullHd.width, fullHd.height);
    for (auto _ : state) {
        auto time = frame->renderer.upload(frame->data, *plan).and_then([&] {
            return headless::submitAndWait(*device, [&](VkCommandBuffer commands) -> Result<void> {
                headless::transition(commands, frame->colour, VK_IMAGE_LAYOUT_UNDEFINED,
                                     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
                return frame->renderer.record(commands, frame->data, *plan, frame->textures, frame->targets);
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
