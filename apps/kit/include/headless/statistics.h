// The number of fragments that a part of a command buffer shades.
#pragma once

#include <headless/device.h>

#include <cstdint>

namespace headless {

/// Counts fragment shader invocations between begin() and end(). Drivers may round up to whole tiles:
/// compare the number with bounds, never for equality.
class FragmentCounter {
public:
    /// Errors: UnsupportedDevice without pipelineStatisticsQuery, Vulkan.
    static Result<FragmentCounter> create(const Device& device);
    FragmentCounter() = default;
    FragmentCounter(FragmentCounter&& other) noexcept;
    FragmentCounter& operator=(FragmentCounter&& other) noexcept;
    ~FragmentCounter();

    /// Call each outside of rendering, once per submission.
    void begin(VkCommandBuffer commands) const;
    void end(VkCommandBuffer commands) const;
    /// Call it after the submission has finished.
    Result<std::uint64_t> invocations() const;

private:
    std::shared_ptr<DeviceCore> core_;
    VkQueryPool pool_ = VK_NULL_HANDLE;
};

}  // namespace headless
