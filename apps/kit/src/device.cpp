#include <headless/device.h>
#include <tyndall/vulkan_result.h>

#include <string>

#include "device_core.h"
#include "instance.h"
#include "physical_device.h"

namespace headless {
namespace {

Result<void> createDevice(DeviceCore& core, const DeviceOptions& options) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = core.queueFamily;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;

    VkPhysicalDeviceVulkan13Features features13{};
    features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    features13.dynamicRendering = VK_TRUE;
    features13.synchronization2 = VK_TRUE;
    VkPhysicalDeviceVulkan12Features features12{};
    features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    features12.pNext = &features13;
    features12.separateDepthStencilLayouts = VK_TRUE;  // every Vulkan 1.3 device has it
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &features12;
    features.features.shaderClipDistance = VK_TRUE;
    features.features.pipelineStatisticsQuery = core.pipelineStatistics ? VK_TRUE : VK_FALSE;

    const char* pushDescriptor = VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = options.pushDescriptors ? 1 : 0;
    info.ppEnabledExtensionNames = &pushDescriptor;
    const VkResult created = vkCreateDevice(core.physicalDevice, &info, nullptr, &core.device);
    if (created != VK_SUCCESS) return vulkanError("vkCreateDevice", created);

    vkGetDeviceQueue(core.device, core.queueFamily, 0, &core.queue);
    core.setObjectName = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
        vkGetDeviceProcAddr(core.device, "vkSetDebugUtilsObjectNameEXT"));
    return {};
}

}  // namespace

tl::unexpected<Error> vulkanError(const char* call, VkResult result) {
    return tl::unexpected(
        Error{ErrorCode::Vulkan, std::string(call) + " failed: " + tyndall::resultName(result), result, call});
}

DeviceCore::~DeviceCore() {
    if (device) {
        vkDeviceWaitIdle(device);
        vkDestroyDevice(device, nullptr);
    }
    if (messenger) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance, messenger, nullptr);
    }
    if (instance) vkDestroyInstance(instance, nullptr);
}

Result<Device> Device::create(const DeviceOptions& options) {
    auto core = std::make_shared<DeviceCore>();
    if (auto made = createInstance(*core, options); !made) return tl::unexpected(made.error());
    if (auto chosen = choosePhysicalDevice(*core, options); !chosen) return tl::unexpected(chosen.error());
    if (auto made = createDevice(*core, options); !made) return tl::unexpected(made.error());
    return Device(std::move(core));
}

VkInstance Device::instance() const {
    return core_->instance;
}
VkPhysicalDevice Device::physicalDevice() const {
    return core_->physicalDevice;
}
VkDevice Device::device() const {
    return core_->device;
}
VkQueue Device::queue() const {
    return core_->queue;
}
std::uint32_t Device::queueFamily() const {
    return core_->queueFamily;
}
const VkPhysicalDeviceProperties& Device::properties() const {
    return core_->properties;
}
std::string_view Device::name() const {
    return core_->properties.deviceName;
}
bool Device::isLlvmpipe() const {
    return name().find("llvmpipe") != std::string_view::npos;
}
bool Device::hasPipelineStatistics() const {
    return core_->pipelineStatistics;
}

std::vector<std::string> Device::messages() const {
    const std::lock_guard lock(core_->log.mutex);
    return core_->log.messages;
}

void Device::clearMessages() {
    const std::lock_guard lock(core_->log.mutex);
    core_->log.messages.clear();
}

std::uint64_t Device::memoryAllocated() const {
    return core_->allocated;
}
std::uint64_t Device::peakMemoryAllocated() const {
    return core_->peakAllocated;
}

void Device::setName(VkObjectType type, std::uint64_t handle, std::string_view name) const {
    if (!core_->setObjectName || name.empty()) return;
    const std::string text(name);
    VkDebugUtilsObjectNameInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = text.c_str();
    core_->setObjectName(core_->device, &info);
}

}  // namespace headless
