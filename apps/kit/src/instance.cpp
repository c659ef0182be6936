#include "instance.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace headless {
namespace {

constexpr const char* validationLayer = "VK_LAYER_KHRONOS_validation";

bool hasLayer(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(),
                       [&](const VkLayerProperties& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool hasExtension(const char* layer, const char* name) {
    std::uint32_t count = 0;
    if (vkEnumerateInstanceExtensionProperties(layer, &count, nullptr) != VK_SUCCESS) return false;
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(), [&](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, name) == 0;
    });
}

}  // namespace

Result<void> createInstance(DeviceCore& core, const DeviceOptions& options) {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "tyndall";
    application.apiVersion = VK_API_VERSION_1_3;

    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;

    std::vector<const char*> extensions;
    if (hasExtension(nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME))
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    core.log.skipInvalidCalls = options.skipInvalidCalls;
    core.log.consumer = options.onMessage;
    VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(core.log);
    constexpr std::array enabled{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.enabledValidationFeatureCount = static_cast<std::uint32_t>(enabled.size());
    features.pEnabledValidationFeatures = enabled.data();
    if (options.validation) {
        if (!hasLayer(validationLayer) || extensions.empty())
            return tl::unexpected(Error{ErrorCode::UnsupportedDevice,
                                        "validation was requested, but the layer VK_LAYER_KHRONOS_validation is not "
                                        "installed; install the Vulkan validation layers or run without them",
                                        VK_ERROR_LAYER_NOT_PRESENT});
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = &validationLayer;
        if (hasExtension(validationLayer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME)) {
            extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
            messenger.pNext = &features;
        }
        info.pNext = &messenger;
    }
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();

    const VkResult created = vkCreateInstance(&info, nullptr, &core.instance);
    if (created == VK_ERROR_INCOMPATIBLE_DRIVER)
        return tl::unexpected(Error{ErrorCode::UnsupportedDevice,
                                    "no Vulkan driver was found; install one, e.g. Mesa's lavapipe, which needs no GPU",
                                    created});
    if (created != VK_SUCCESS) return vulkanError("vkCreateInstance", created);

    if (options.validation) {
        const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(core.instance, "vkCreateDebugUtilsMessengerEXT"));
        messenger.pNext = nullptr;
        const VkResult result = create(core.instance, &messenger, nullptr, &core.messenger);
        if (result != VK_SUCCESS) return vulkanError("vkCreateDebugUtilsMessengerEXT", result);
    }
    return {};
}

}  // namespace headless
