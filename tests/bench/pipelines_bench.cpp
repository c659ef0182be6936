// The time to make the pipelines of all techniques: one after the other, on all cores, and from a cache that was sealed
// and opened again. Drivers have their own caches: switch them off to measure (NVIDIA's by __GL_SHADER_DISK_CACHE=0,
// Mesa's by MESA_SHADER_CACHE_DISABLE=1). lavapipe compiles at the first draw, not here.
#include <benchmark/benchmark.h>
#include <headless/device.h>
#include <tyndall/pipeline_cache.h>
#include <tyndall/renderer.h>
#include <vulkan/vulkan.h>

#include <array>
#include <stdexcept>
#include <thread>

namespace {

using namespace tyndall;

void onThreads(std::size_t count, const std::function<void(std::size_t)>& job) {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < count; ++i) threads.emplace_back([&job, i] { job(i); });
}

template <class T>
T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

const headless::Device& device() {
    static const headless::Device one = must(headless::Device::create());
    return one;
}

VkPipelineCache makeCache(std::span<const std::byte> data) {
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = data.size();
    info.pInitialData = data.data();
    VkPipelineCache cache = VK_NULL_HANDLE;
    if (vkCreatePipelineCache(device().device(), &info, nullptr, &cache) != VK_SUCCESS)
        throw std::runtime_error("no pipeline cache");
    return cache;
}

/// The data of a cache after making all pipelines with it.
std::vector<std::byte> dataOf(VkPipelineCache cache) {
    std::size_t size = 0;
    vkGetPipelineCacheData(device().device(), cache, &size, nullptr);
    std::vector<std::byte> data(size);
    vkGetPipelineCacheData(device().device(), cache, &size, data.data());
    data.resize(size);
    return data;
}

std::uint64_t makeAll(VkPipelineCache cache, const ParallelFor& parallel) {
    Renderer renderer = must(Renderer::create({device().physicalDevice(), device().device(), cache}));
    must(renderer.prepare({.terms = allTermSets,
                           .depthFormat = VK_FORMAT_D32_SFLOAT,
                           .colourFormat = VK_FORMAT_R16G16B16A16_SFLOAT,
                           .shadowMapFormat = VK_FORMAT_D32_SFLOAT},
                          parallel));
    return renderer.counters().pipelinesPrepared;
}

void prepare(benchmark::State& state, const ParallelFor& parallel, bool kept) {
    state.SetLabel(std::string(device().name()));
    std::vector<std::byte> sealed;
    if (kept) {
        VkPipelineCache cache = makeCache({});
        makeAll(cache, {});
        sealed = sealPipelineCache(dataOf(cache), device().properties());
        vkDestroyPipelineCache(device().device(), cache, nullptr);
    }
    std::uint64_t pipelines = 0;
    for (auto _ : state) {
        std::span<const std::byte> data;
        if (kept) data = must(openPipelineCache(sealed, device().properties()));
        VkPipelineCache cache = makeCache(data);
        pipelines = makeAll(cache, parallel);
        vkDestroyPipelineCache(device().device(), cache, nullptr);
    }
    state.counters["pipelines"] = static_cast<double>(pipelines);
    state.counters["bytes kept"] = static_cast<double>(sealed.size());
}

}  // namespace

BENCHMARK_CAPTURE(prepare, inOrder, ParallelFor{}, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(prepare, onThreads, onThreads, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(prepare, inOrderFromCache, ParallelFor{}, true)->Unit(benchmark::kMillisecond)->UseRealTime();
