// A Vulkan 1.3 device with one queue and no window.
#pragma once

#include <headless/result.h>
#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace headless {

struct DeviceOptions {
    bool validation = false;        ///< the Khronos layer with synchronization validation; see Device::messages()
    bool skipInvalidCalls = false;  ///< calls with validation errors do not reach the driver: for tests that
                                    ///< make such a call on purpose
    std::string deviceName = {};    ///< part of the wanted device's name, case counts; empty: any
    bool preferSoftware = false;    ///< lavapipe before a GPU, for pictures that are the same everywhere
    /// Receives every message too, from any thread, including leaks found when the device is destroyed.
    std::function<void(const std::string&)> onMessage = {};
    bool pushDescriptors = true;  ///< false leaves VK_KHR_push_descriptor out: the Renderer must refuse such a device
};

/// Every object made from a device keeps this alive. Its fields are private to the library.
struct DeviceCore;

/// Instance, device and queue. Objects made from it keep it alive, so any order of destruction works.
class Device {
public:
    /// Takes the best device that has Vulkan 1.3 with dynamicRendering and synchronization2,
    /// shaderClipDistance, VK_KHR_push_descriptor and a graphics queue.
    /// Errors: UnsupportedDevice if no device qualifies (with the reason for each) or if validation is
    /// requested and its layer is not installed; Vulkan.
    static Result<Device> create(const DeviceOptions& options = {});
    Device(Device&&) noexcept = default;
    Device& operator=(Device&&) noexcept = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device() = default;

    VkInstance instance() const;
    VkPhysicalDevice physicalDevice() const;
    VkDevice device() const;
    VkQueue queue() const;
    std::uint32_t queueFamily() const;
    const VkPhysicalDeviceProperties& properties() const;
    std::string_view name() const;
    /// True on Mesa's software rasterizer.
    bool isLlvmpipe() const;
    bool hasPipelineStatistics() const;

    /// Validation messages so far: warnings and errors, one string each with the message's id first.
    /// Empty without validation. Safe to call from any thread.
    std::vector<std::string> messages() const;
    void clearMessages();

    /// Bytes of device memory that live objects of this library hold: now, and the maximum so far.
    std::uint64_t memoryAllocated() const;
    std::uint64_t peakMemoryAllocated() const;

    /// Names an object for validation messages and debuggers, if VK_EXT_debug_utils is available.
    void setName(VkObjectType type, std::uint64_t handle, std::string_view name) const;

    const std::shared_ptr<DeviceCore>& core() const { return core_; }

private:
    explicit Device(std::shared_ptr<DeviceCore> core) : core_(std::move(core)) {}
    std::shared_ptr<DeviceCore> core_;
};

}  // namespace headless
