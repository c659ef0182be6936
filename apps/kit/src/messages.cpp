#include "messages.h"

namespace headless {
namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL collect(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto& log = *static_cast<MessageLog*>(user);
    const std::lock_guard lock(log.mutex);
    std::string text = data->pMessageIdName ? data->pMessageIdName : "unnamed";
    text += ": ";
    text += data->pMessage ? data->pMessage : "";
    if (log.consumer) log.consumer(text);
    log.messages.push_back(std::move(text));
    const bool error = (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) != 0;
    return log.skipInvalidCalls && error ? VK_TRUE : VK_FALSE;
}

}  // namespace

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(MessageLog& log) {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    // GENERAL is left out: the loader uses it to report drivers for hardware that is not present.
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = collect;
    info.pUserData = &log;
    return info;
}

}  // namespace headless
