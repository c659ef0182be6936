#include <headless/statistics.h>

#include <utility>

#include "device_core.h"

namespace headless {

Result<FragmentCounter> FragmentCounter::create(const Device& device) {
    if (!device.hasPipelineStatistics())
        return tl::unexpected(Error{ErrorCode::UnsupportedDevice,
                                    "the device lacks pipelineStatisticsQuery, so fragments cannot be counted",
                                    VK_SUCCESS});
    FragmentCounter counter;
    counter.core_ = device.core();
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_PIPELINE_STATISTICS;
    info.queryCount = 1;
    info.pipelineStatistics = VK_QUERY_PIPELINE_STATISTIC_FRAGMENT_SHADER_INVOCATIONS_BIT;
    const VkResult result = vkCreateQueryPool(device.device(), &info, nullptr, &counter.pool_);
    if (result != VK_SUCCESS) return vulkanError("vkCreateQueryPool", result);
    return counter;
}

FragmentCounter::FragmentCounter(FragmentCounter&& other) noexcept {
    *this = std::move(other);
}

FragmentCounter& FragmentCounter::operator=(FragmentCounter&& other) noexcept {
    std::swap(core_, other.core_);
    std::swap(pool_, other.pool_);
    return *this;
}

FragmentCounter::~FragmentCounter() {
    if (core_) vkDestroyQueryPool(core_->device, pool_, nullptr);
}

void FragmentCounter::begin(VkCommandBuffer commands) const {
    vkCmdResetQueryPool(commands, pool_, 0, 1);
    vkCmdBeginQuery(commands, pool_, 0, 0);
}

void FragmentCounter::end(VkCommandBuffer commands) const {
    vkCmdEndQuery(commands, pool_, 0);
}

Result<std::uint64_t> FragmentCounter::invocations() const {
    std::uint64_t count = 0;
    const VkResult result = vkGetQueryPoolResults(core_->device, pool_, 0, 1, sizeof count, &count, sizeof count,
                                                  VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    if (result != VK_SUCCESS) return vulkanError("vkGetQueryPoolResults", result);
    return count;
}

}  // namespace headless
