// How many fragments a stretch of a command buffer shaded.
#pragma once

#include <headless/device.h>

#include <cstdint>

namespace headless {

/// Counts fragment shader invocations between begin() and end(). Drivers may round up to whole tiles:
/// bound the figure, never compare it for equality.
class FragmentCounter {
public:
    /// Errors: UnsupportedDevice without pipelineStatisticsQuery, Vulkan.
    static Result<FragmentCounter> create(const Device& device);
    FragmentCounter() = default;
    FragmentCounter(FragmentCounter&& other) noexcept;
    FragmentCounter& operator=(FragmentCounter&& other) noexcept;
    ~FragmentCounter();

    /// Outside of rendering, once each per submission.
    void begin(VkCommandBuffer commands) const;
    void end(VkCommandBuffer commands) const;
    /// After the submission has finished.
    Result<std::uint64_t> invocations() const;

private:
    std::shared_ptr<DeviceCore> core_;
    VkQueryPool pool_ = VK_NULL_HANDLE;
};

}  // namespace headless
